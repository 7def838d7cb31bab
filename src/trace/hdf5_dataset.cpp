#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

// A table's chunk: the whole table up to so many rows.
constexpr hsize_t most_table_rows = 65536;

hid_t file_type(NumberType type) {
  switch (type) {
    case NumberType::float64:
      return H5T_IEEE_F64LE;
    case NumberType::int32:
      return H5T_STD_I32LE;
    case NumberType::uint8:
      return H5T_STD_U8LE;
  }
  return H5T_IEEE_F64LE;
}

std::size_t file_bytes(NumberType type) noexcept {
  if (type == NumberType::uint8) return 1;
  return type == NumberType::int32 ? 4 : 8;
}

/// Asks for the filters that packed_chunk stands for.
void set_filters(const Handle& creation) {
  H5Pset_shuffle(creation.id());
  H5Pset_deflate(creation.id(), deflate_level);
}

/// A table in deflated chunks of whole rows.
Handle write_packed_dataset(const Handle& parent, const std::string& name, NumberType type,
                            std::span<const hsize_t> extents, const void* values) {
  const std::size_t row_bytes = file_bytes(type) * (extents.size() == 2 ? extents[1] : 1);
  std::array<hsize_t, 2> chunk = {std::min(extents[0], most_table_rows), 3};
  Handle dataset;
  {
    const Turn turn;
    const Handle space = made(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                              H5Sclose, parent.path());
    const Handle creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, parent.path());
    H5Pset_obj_track_times(creation.id(), 0);
    H5Pset_chunk(creation.id(), static_cast<int>(extents.size()), chunk.data());
    set_filters(creation);
    dataset = wrapped(H5Dcreate2(parent.id(), name.c_str(), file_type(type), space.id(), H5P_DEFAULT,
                                 creation.id(), H5P_DEFAULT),
                      H5Dclose, parent.path());
    if (!dataset.open()) throw write_error(parent.path(), name);
  }
  std::vector<std::byte> plain, room;
  for (hsize_t first = 0; first < extents[0]; first += chunk[0]) {
    const std::size_t rows = std::min(chunk[0], extents[0] - first);
    const auto* from = static_cast<const std::byte*>(values) + first * row_bytes;
    plain.assign(from, from + rows * row_bytes);
    plain.resize(chunk[0] * row_bytes);
    const ChunkBytes packed = packed_chunk(plain, file_bytes(type), room);
    const std::array<hsize_t, 2> at = {first, 0};
    const Turn turn;
    if (H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, packed.skipped_filters, at.data(), packed.bytes.size(),
                       packed.bytes.data()) < 0)
      throw write_error(parent.path(), name);
  }
  return dataset;
}

/// A dataset of its own extents, written whole.
Handle write_whole_dataset(const Handle& parent, const std::string& name, NumberType type, hid_t memory_type,
                           std::span<const hsize_t> extents, const void* values, Packing packing) {
  if (packing == Packing::deflated && extents[0] > 0)
    return write_packed_dataset(parent, name, type, extents, values);
  const Turn turn;
  const Handle space = made(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                            H5Sclose, parent.path());
  const Handle creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, parent.path());
  H5Pset_obj_track_times(creation.id(), 0);
  Handle dataset = wrapped(H5Dcreate2(parent.id(), name.c_str(), file_type(type), space.id(), H5P_DEFAULT,
                                      creation.id(), H5P_DEFAULT),
                           H5Dclose, parent.path());
  if (!dataset.open() || H5Dwrite(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) {
    throw write_error(parent.path(), name);
  }
  return dataset;
}

/// Reads a dataset of `rank` dimensions whole after its extents were found sane.
std::uint64_t checked_rows(const Handle& dataset, const std::string& name, std::size_t rank,
                           std::uint64_t max_rows) {
  const auto size = extents(dataset);
  if (size.size() != rank || size[0] > max_rows || (rank == 2 && size[1] != 3)) {
    throw read_error(dataset.path(), name);
  }
  const std::uint64_t stored = stored_values(dataset);
  if (size[0] * (rank == 2 ? 3 : 1) > stored) {
    throw refused(dataset.path(), fmt::format("is damaged: table '{}' has {} rows, but bytes for {} numbers",
                                              name, size[0], stored));
  }
  return size[0];
}

void read_whole_dataset(const Handle& dataset, const std::string& name, hid_t memory_type, void* out) {
  if (H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out) < 0) {
    throw read_error(dataset.path(), name);
  }
}

}  // namespace

Handle create_column(const Handle& file, const std::string& name, const ColumnLayout& layout,
                     const std::string& unit) {
  const Turn turn;
  const hsize_t none = 0, unlimited = H5S_UNLIMITED, chunk_rows = layout.chunk_rows;
  const Handle space = made(H5Screate_simple(1, &none, &unlimited), H5Sclose, file.path());
  const Handle creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, file.path());
  H5Pset_chunk(creation.id(), 1, &chunk_rows);
  H5Pset_obj_track_times(creation.id(), 0);
  if (layout.deflated) set_filters(creation);
  const Handle access = made(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, file.path());
  // A few chunks: columns are written in order, and many files may be open.
  H5Pset_chunk_cache(access.id(), 13, 8 * chunk_rows * sizeof(double), 1.0);
  Handle column = wrapped(H5Dcreate2(file.id(), name.c_str(), file_type(layout.type), space.id(), H5P_DEFAULT,
                                     creation.id(), access.id()),
                          H5Dclose, file.path());
  if (!column.open()) throw write_error(file.path(), name);
  write_text(column, "unit", unit);
  return column;
}

Handle create_column(const Handle& file, const std::string& name, NumberType type, const std::string& unit) {
  return create_column(file, name, ColumnLayout{type}, unit);
}

void write_chunks(std::span<const ColumnChunk> chunks, std::uint64_t first_row, std::uint64_t rows) {
  static_assert(std::endian::native == std::endian::little, "chunks are written as they lie in memory");
  const hsize_t at = first_row, total = rows;
  LateBytes late;
  const Handle* refused = nullptr;  // the first column that HDF5 does not take
  {
    const Turn turn;
    // Of a full list of chunks all but the last stay in it: HDF5 would move a tenth of them.
    const Handle transfer = made(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "");
    H5Pset_btree_ratios(transfer.id(), 0.1, 0.5, 1);
    for (const auto& [column, chunk] : chunks) {
      herr_t status = H5Dset_extent(column->id(), &total);
      if (status >= 0) {
        late.expect(chunk.bytes);
        status = H5Dwrite_chunk(column->id(), transfer.id(), chunk.skipped_filters, &at, chunk.bytes.size(),
                                chunk.bytes.data());
        late.settle();
      }
      if (status < 0) {
        refused = column;
        break;
      }
    }
  }
  late.write();  // what was taken before it has its place in the file
  if (refused != nullptr) throw write_error(refused->path(), "a column");
}

void append(const Handle& column, std::size_t rows, std::span<const double> values) {
  const Turn turn;
  const hsize_t start = rows, count = values.size(), total = rows + values.size();
  if (H5Dset_extent(column.id(), &total) < 0) throw write_error(column.path(), "a column");
  const Handle file_space = made(H5Dget_space(column.id()), H5Sclose, column.path());
  const Handle memory_space = made(H5Screate_simple(1, &count, nullptr), H5Sclose, column.path());
  H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, &start, nullptr, &count, nullptr);
  if (H5Dwrite(column.id(), H5T_NATIVE_DOUBLE, memory_space.id(), file_space.id(), H5P_DEFAULT,
               values.data()) < 0) {
    throw write_error(column.path(), "a column");
  }
}

Handle open_dataset(const Handle& parent, const std::string& name, const std::string& what) {
  const Turn turn;
  check_link(parent, name, what, H5O_TYPE_DATASET);
  Handle dataset = wrapped(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose, parent.path());
  if (!dataset.open()) throw read_error(parent.path(), name);
  check_storage(dataset, name, what);
  return dataset;
}

std::vector<std::uint64_t> extents(const Handle& dataset) {
  const Turn turn;
  const Handle type = wrapped(H5Dget_type(dataset.id()), H5Tclose, "");
  const Handle space = wrapped(H5Dget_space(dataset.id()), H5Sclose, "");
  const H5T_class_t kind = H5Tget_class(type.id());
  const std::size_t bytes = H5Tget_size(type.id());
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || bytes > sizeof(double) || rank < 1 || rank > 2) return {};
  std::array<hsize_t, 2> size{};
  if (H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) != rank) return {};
  return {size.begin(), size.begin() + rank};
}

bool is_deflated(const Handle& dataset) {
  const Turn turn;
  const Handle creation = wrapped(H5Dget_create_plist(dataset.id()), H5Pclose, "");
  return H5Pget_nfilters(creation.id()) > 0;
}

std::uint64_t stored_values(const Handle& dataset) {
  const Turn turn;
  const Handle type = wrapped(H5Dget_type(dataset.id()), H5Tclose, "");
  const std::size_t bytes = H5Tget_size(type.id());
  if (!is_deflated(dataset)) return bytes == 0 ? 0 : H5Dget_storage_size(dataset.id()) / bytes;
  const Handle creation = wrapped(H5Dget_create_plist(dataset.id()), H5Pclose, "");
  std::array<hsize_t, 2> chunk{1, 1};
  hsize_t chunks = 0;
  const Handle space = wrapped(H5Dget_space(dataset.id()), H5Sclose, "");
  if (H5Pget_chunk(creation.id(), 2, chunk.data()) < 1 ||
      H5Dget_num_chunks(dataset.id(), space.id(), &chunks) < 0)
    return 0;
  return chunks * chunk[0] * chunk[1];
}

bool read_rows(const Handle& column, std::size_t first, std::span<double> out) {
  const Turn turn;
  const hsize_t start = first, count = out.size();
  const Handle file_space = wrapped(H5Dget_space(column.id()), H5Sclose, "");
  const Handle memory_space = wrapped(H5Screate_simple(1, &count, nullptr), H5Sclose, "");
  return H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, &start, nullptr, &count, nullptr) >= 0 &&
         H5Dread(column.id(), H5T_NATIVE_DOUBLE, memory_space.id(), file_space.id(), H5P_DEFAULT,
                 out.data()) >= 0;
}

std::optional<std::uint64_t> length_of_row(const std::vector<std::uint64_t>& extents) {
  if (extents.size() == 1) return extents[0];
  if (extents.size() == 2 && (extents[0] == 1 || extents[1] == 1)) return extents[0] * extents[1];
  return std::nullopt;
}

bool read_all(const Handle& dataset, std::span<double> out) {
  const Turn turn;
  const hsize_t count = out.size();
  const Handle memory_space = wrapped(H5Screate_simple(1, &count, nullptr), H5Sclose, "");
  return H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, memory_space.id(), H5S_ALL, H5P_DEFAULT, out.data()) >= 0;
}

// Eigen's matrices are stored by column, so that 3 x n here is n x 3 there.
void write_table(const Handle& parent, const std::string& name, const Points& points, const std::string& unit,
                 Packing packing) {
  const std::array<hsize_t, 2> size = {static_cast<hsize_t>(points.cols()), 3};
  const Handle table =
      write_whole_dataset(parent, name, NumberType::float64, H5T_NATIVE_DOUBLE, size, points.data(), packing);
  write_text(table, "unit", unit);
}

void write_table(const Handle& parent, const std::string& name, const IndexTriples& triples,
                 Packing packing) {
  const std::array<hsize_t, 2> size = {static_cast<hsize_t>(triples.cols()), 3};
  write_whole_dataset(parent, name, NumberType::int32, H5T_NATIVE_INT, size, triples.data(), packing);
}

void write_list(const Handle& parent, const std::string& name, std::span<const int> values, Packing packing) {
  const std::array<hsize_t, 1> size = {values.size()};
  write_whole_dataset(parent, name, NumberType::int32, H5T_NATIVE_INT, size, values.data(), packing);
}

Points read_points(const Handle& parent, const std::string& name, std::uint64_t max_columns) {
  const Turn turn;
  const Handle table = open_dataset(parent, name, "table");
  Points points(3, static_cast<Eigen::Index>(checked_rows(table, name, 2, max_columns)));
  read_whole_dataset(table, name, H5T_NATIVE_DOUBLE, points.data());
  return points;
}

IndexTriples read_triples(const Handle& parent, const std::string& name, std::uint64_t max_columns) {
  const Turn turn;
  const Handle table = open_dataset(parent, name, "table");
  IndexTriples triples(3, static_cast<Eigen::Index>(checked_rows(table, name, 2, max_columns)));
  read_whole_dataset(table, name, H5T_NATIVE_INT, triples.data());
  return triples;
}

std::vector<int> read_list(const Handle& parent, const std::string& name, std::uint64_t max_count) {
  const Turn turn;
  const Handle list = open_dataset(parent, name, "table");
  std::vector<int> values(checked_rows(list, name, 1, max_count));
  read_whole_dataset(list, name, H5T_NATIVE_INT, values.data());
  return values;
}

}  // namespace fingerpad::hdf5
