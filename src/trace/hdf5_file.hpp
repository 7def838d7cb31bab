#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/types.hpp"

/// What the trace needs of HDF5, behind plain types, so that hdf5.h stays in one file. Functions that write
/// throw Error (fault, with the file's path); functions that read throw Error (refused). All of them, and
/// every Handle's end, may be called from any thread: each takes its own turn with the library.
namespace fingerpad::hdf5 {

/// One thread's turn with the library: Debian's HDF5 is not thread-safe. Turns of one thread may nest.
/// Holding one over several calls keeps other threads out between them. In a child that a thread forks during
/// its turn, that thread's copy still has it.
class Turn {
 public:
  Turn();
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
};

/// An open HDF5 object; closed at its end, which takes its own turn: where an exception passes, a Handle may
/// outlive the turn it was opened in.
class Handle {
 public:
  using Id = std::int64_t;
  Handle() = default;
  Handle(Id id, int (*closer)(Id), std::string path) : id_(id), closer_(closer), path_(std::move(path)) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), closer_(other.closer_), path_(std::move(other.path_)) {}
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { close(); }

  bool open() const noexcept { return id_ >= 0; }
  Id id() const noexcept { return id_; }
  void close() noexcept;
  /// Of the file that the object is in, for messages.
  const std::string& path() const noexcept { return path_; }

 private:
  Id id_ = -1;
  int (*closer_)(Id) = nullptr;
  std::string path_;
};

enum class NumberType { float64, int32, uint8 };

/// Where HDF5's lists of chunks lie in a file: anywhere; or each at the start of a page of memory, so that a
/// killed process has written all of it or nothing.
enum class Layout { tight, paged };

// Files and groups. No times are kept, so that equal contents are equal bytes.
Handle create_file(const std::string& path, Layout layout = Layout::tight);
Handle open_file(const std::string& path);
/// Throws Error (fault) if what was written so far, or any of it, has not reached the file.
void flush(const Handle& file);
/// Closes a file that was written, all of whose objects are closed. Throws Error (fault) as flush() does.
void close_file(Handle file);
Handle create_group(const Handle& parent, const std::string& name);
bool has_link(const Handle& parent, const std::string& name);
/// Refuses a link that may lead out of the file, and what is no group.
Handle open_group(const Handle& parent, const std::string& name);

// Attributes.
void write_text(const Handle& object, const std::string& name, const std::string& text);
void write_texts(const Handle& object, const std::string& name, const std::vector<std::string>& texts);
void write_flag(const Handle& object, const std::string& name, bool flag);  ///< may be written again
void write_whole(const Handle& object, const std::string& name, std::uint64_t value);
void write_numbers(const Handle& object, const std::string& name, std::span<const double> values);
bool has_attribute(const Handle& object, const std::string& name);
/// Texts of an attribute, none where the object has no such attribute.
std::vector<std::string> read_texts(const Handle& object, const std::string& name);
std::string read_text(const Handle& object, const std::string& name);  ///< "" where there is none
std::optional<std::uint64_t> read_whole(const Handle& object, const std::string& name);
/// Exactly `count` numbers.
std::vector<double> read_numbers(const Handle& object, const std::string& name, std::size_t count);

// Columns: one-dimensional datasets that grow.

/// How the file keeps a column.
struct ColumnLayout {
  NumberType type;
  std::uint64_t chunk_rows = 1024;
  bool deflated = false;  ///< its chunks pass through packed_chunk()
};
Handle create_column(const Handle& file, const std::string& name, const ColumnLayout& layout,
                     const std::string& unit);
Handle create_column(const Handle& file, const std::string& name, NumberType type, const std::string& unit);

/// One chunk of a column as it stands in the file, all its rows, whether they are needed or not.
struct ChunkBytes {
  std::span<const std::byte> bytes;
  std::uint32_t skipped_filters = 0;  ///< HDF5's mask: bit 1 set where deflating did not pay
};
/// What a deflated column's chunk becomes: its bytes shuffled (first bytes of all values, then second ones)
/// and deflated by zlib, as HDF5's own filters would. Takes no turn, so that many threads may pack at once.
/// @param room  kept by the caller, so that it is not asked for anew each time
ChunkBytes packed_chunk(std::span<const std::byte> chunk, std::size_t value_bytes,
                        std::vector<std::byte>& room);
struct ColumnChunk {
  const Handle* column;
  ChunkBytes chunk;
};
/// Puts chunks of one file's columns where they begin, beyond HDF5's cache; the columns then have `rows`
/// rows. The turn is taken to find their places; the disk has their bytes afterwards, while other threads
/// take theirs.
/// @pre first_row is a multiple of the chunks' rows; the numbers are the file's: little-endian
void write_chunks(std::span<const ColumnChunk> chunks, std::uint64_t first_row, std::uint64_t rows);

/// Adds values behind the first `rows`.
void append(const Handle& column, std::size_t rows, std::span<const double> values);
/// Refuses a link that may lead out of the file, what is no dataset, and a dataset whose numbers are not
/// bytes of the file's own: no external storage, no virtual dataset, no filter but HDF5's own shuffle and
/// deflate, of which nothing is loaded.
/// @param what  what it is called in messages ("column")
Handle open_dataset(const Handle& parent, const std::string& name, const std::string& what);
/// See read_hdf5_contents.
std::string contents_words(const Handle& file);
/// The extents of a dataset of numbers; none if it is something else.
std::vector<std::uint64_t> extents(const Handle& dataset);
/// Whether its numbers are deflated.
bool is_deflated(const Handle& dataset);
/// How many values the file has bytes for, of a deflated dataset chunks. (HDF5 reads zeros where it has
/// none.)
std::uint64_t stored_values(const Handle& dataset);
/// How many numbers a row of them has: of N, and of N x 1 and 1 x N, as some programs write one. None of
/// another shape.
std::optional<std::uint64_t> length_of_row(const std::vector<std::uint64_t>& extents);
/// All numbers of a dataset, as doubles; false if they cannot be read.
/// @pre out has room for all
bool read_all(const Handle& dataset, std::span<double> out);
/// Rows first .. first + out.size() of a column, as doubles; false if they cannot be read.
bool read_rows(const Handle& column, std::size_t first, std::span<double> out);

// Small fixed tables, n x 3 in the file for 3 x n here.
/// Whether they are deflated as columns are.
enum class Packing { plain, deflated };
void write_table(const Handle& parent, const std::string& name, const Points& points, const std::string& unit,
                 Packing packing = Packing::plain);
void write_table(const Handle& parent, const std::string& name, const IndexTriples& triples,
                 Packing packing = Packing::plain);
void write_list(const Handle& parent, const std::string& name, std::span<const int> values,
                Packing packing = Packing::plain);
Points read_points(const Handle& parent, const std::string& name, std::uint64_t max_columns);
IndexTriples read_triples(const Handle& parent, const std::string& name, std::uint64_t max_columns);
std::vector<int> read_list(const Handle& parent, const std::string& name, std::uint64_t max_count);

/// Of HDF5 as it is loaded, as "1.10.8".
std::string library_version();

}  // namespace fingerpad::hdf5
