#include "trace/hdf5_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <mutex>

#include "base/path_words.hpp"
#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

// Not a recursive mutex: that one knows its owner by the thread's number, which is another in a forked child.
std::mutex library_mutex;
thread_local int turns_held = 0;

/// How this project opens files: readable by every HDF5 since 1.8, and no locks, so that a trace can be
/// watched while it grows and a killed writer leaves nothing to clear.
Handle access_properties(const std::string& path) {
  Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110);
  H5Pset_file_locking(access.id(), 0, 1);
  return access;
}

Error disk_error(const std::string& path, int failure) {
  return {ErrorKind::fault, path, "cannot be written: " + path_words(path, failure)};
}

/// HDF5 writes here and there in a file, and reads it again.
void refuse_irregular(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw Error(
      ErrorKind::usage, path,
      std::filesystem::is_directory(status)
          ? "cannot be created: is a folder: name a file in it"
          : "is no regular file, which an HDF5 trace needs; a CSV trace can go into a pipe or a device");
}

}  // namespace

Error write_error(const std::string& path, const std::string& what) {
  return {ErrorKind::fault, path, fmt::format("cannot write {}", what)};
}

Error read_error(const std::string& path, const std::string& what) {
  return refused(path, fmt::format("is damaged or no trace: cannot read {}", what));
}

Handle made(hid_t id, herr_t (*closer)(hid_t), const std::string& path) {
  if (id < 0) throw Error(ErrorKind::fault, path, "HDF5 failed");
  return wrapped(id, closer, path);
}

Turn::Turn() {
  if (turns_held++ > 0) return;
  library_mutex.lock();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are told by Error alone
}

Turn::~Turn() {
  if (--turns_held == 0) library_mutex.unlock();
}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this == &other) return *this;
  close();
  id_ = std::exchange(other.id_, -1);
  closer_ = other.closer_;
  path_ = std::move(other.path_);
  return *this;
}

void Handle::close() noexcept {
  if (id_ < 0) return;
  const Turn turn;
  closer_(std::exchange(id_, -1));
}

Handle create_file(const std::string& path, Layout layout) {
  // A list of 64 chunks of one dimension has 2096 bytes.
  constexpr hsize_t list_bytes = 2048, page_bytes = 4096;
  const Turn turn;
  refuse_irregular(path);
  const Handle access = access_properties(path);
  if (layout == Layout::paged) H5Pset_alignment(access.id(), list_bytes, page_bytes);
  const Handle creation = made(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path);
  H5Pset_obj_track_times(creation.id(), 0);
  if (!write_through_disk(access)) throw Error(ErrorKind::fault, path, "HDF5 failed");
  last_open_failure();
  Handle file = wrapped(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, path);
  if (file.open()) return file;
  const int failure = last_open_failure();
  if (failure == 0) throw Error(ErrorKind::fault, path, "cannot be created: it is open");
  throw Error(output_fault(failure), path, "cannot be created: " + unmade_words(path, failure, Made::file));
}

Handle open_file(const std::string& path) {
  const Turn turn;
  const Handle access = access_properties(path);
  Handle file = wrapped(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, path);
  if (!file.open()) throw refused(path, "is no HDF5 file that can be read: cut short or damaged");
  return file;
}

void flush(const Handle& file) {
  const Turn turn;
  const bool flushed = flush_in_order(file);
  if (const int failure = write_failure(file)) throw disk_error(file.path(), failure);
  if (!flushed) throw write_error(file.path(), "to the disk");
}

void close_file(Handle file) {
  const Turn turn;
  last_close_failure();
  file.close();
  if (const int failure = last_close_failure()) throw disk_error(file.path(), failure);
}

Handle create_group(const Handle& parent, const std::string& name) {
  const Turn turn;
  const Handle creation = made(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, parent.path());
  H5Pset_obj_track_times(creation.id(), 0);
  Handle group = wrapped(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Gclose, parent.path());
  if (!group.open()) throw write_error(parent.path(), name);
  return group;
}

bool has_link(const Handle& parent, const std::string& name) {
  const Turn turn;
  return H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT) > 0;
}

Handle open_group(const Handle& parent, const std::string& name) {
  const Turn turn;
  check_link(parent, name, "group", H5O_TYPE_GROUP);
  Handle group = wrapped(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, parent.path());
  if (!group.open()) throw read_error(parent.path(), name);
  return group;
}

std::string library_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace fingerpad::hdf5
