#pragma once

#include <hdf5.h>

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "trace/hdf5_file.hpp"

/// What the files that call HDF5 share. Every function of hdf5_file.hpp takes its turn first; what stands
/// here is called in turns alone.
namespace fingerpad::hdf5 {

static_assert(std::is_same_v<hid_t, Handle::Id>);
static_assert(std::is_same_v<herr_t, int>);

/// Of zlib, 1 to 9. On traces 4 takes 1.5 times as long as 1.
inline constexpr int deflate_level = 1;

/// Lets files be written through our own driver, which HDF5 never hears an error from; see hdf5_disk.cpp.
bool write_through_disk(const Handle& access);
/// errno of the last file that could not be opened through that driver, once; 0 if all could.
int last_open_failure();
/// errno of the first failure of the last file that was closed there, its writes and its close; 0 if all is
/// in the file. Once.
int last_close_failure();
/// errno of the first write of this file that failed; 0 if none has.
int write_failure(const Handle& file);
/// H5Fflush in an order that leaves a file of Layout::paged whole wherever the process is killed; see
/// HeldWrites. (Not one whose chunks are deflated: they move when they are written again.)
bool flush_in_order(const Handle& file);

/// Of a chunk that HDF5 is asked to write as it lies in memory: the driver notes where it belongs, and writes
/// it when the thread no longer holds up the others.
class LateBytes {
 public:
  /// The driver takes these bytes of this thread's next writes for late ones. They must stay until write().
  void expect(std::span<const std::byte> bytes);
  /// From now on writes of this thread are written at once again.
  void settle() noexcept;
  /// Writes what was noted; a failure is kept as that of any write (write_failure). Needs no turn.
  void write() noexcept;
  LateBytes() = default;
  ~LateBytes() { settle(); }
  LateBytes(const LateBytes&) = delete;
  LateBytes& operator=(const LateBytes&) = delete;

  /// Of the driver: whether the bytes are expected, and are noted.
  bool notes(H5FD_t* file, haddr_t at, std::size_t size, const void* from) noexcept;

 private:
  struct Place {
    H5FD_t* file;
    haddr_t at;
    std::span<const std::byte> bytes;
  };
  std::span<const std::byte> expected_;
  std::vector<Place> places_;
};

/// HDF5 itself would not write `what`.
Error write_error(const std::string& path, const std::string& what);
Error read_error(const std::string& path, const std::string& what);

/// A handle on what an HDF5 call gave; not open if it failed.
inline Handle wrapped(hid_t id, herr_t (*closer)(hid_t), const std::string& path) {
  return {id, closer, path};
}

// What may stand in a file that somebody else made. Each throws Error (refused), in the words of a person,
// for anything but an object of the file's own; nothing is followed or opened to find out.
void check_link(const Handle& parent, const std::string& name, const std::string& what, H5O_type_t wanted);
void check_storage(const Handle& dataset, const std::string& name, const std::string& what);

/// For the small objects that describe others; these fail only for want of memory. Throws Error (fault).
Handle made(hid_t id, herr_t (*closer)(hid_t), const std::string& path);

}  // namespace fingerpad::hdf5
