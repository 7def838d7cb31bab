#include "trace/hdf5_file.hpp"

#include <fmt/format.h>

#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

/// How this project opens files: readable by every HDF5 since 1.8, and no locks, so that a trace can be
/// watched while it grows and a killed writer leaves nothing to clear.
Handle access_properties(const std::string& path) {
  Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110);
  H5Pset_file_locking(access.id(), 0, 1);
  return access;
}

}  // namespace

std::string system_reason() {
  std::string reason;
  const auto visit = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    constexpr std::string_view before = "error message = '";
    const std::string_view text = error->desc != nullptr ? error->desc : "";
    const std::size_t start = text.find(before);
    auto& reason = *static_cast<std::string*>(out);
    if (start == std::string_view::npos || !reason.empty()) return 0;
    const std::string_view rest = text.substr(start + before.size());
    reason = rest.substr(0, rest.find('\''));
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &reason);
  return reason.empty() ? reason : ": " + reason;
}

Error write_error(const std::string& path, const std::string& what) {
  return {ErrorKind::fault, path, fmt::format("cannot write {}{}", what, system_reason())};
}

Error read_error(const std::string& path, const std::string& what) {
  return refused(path, fmt::format("is damaged or no trace: cannot read {}", what));
}

Handle made(hid_t id, herr_t (*closer)(hid_t), const std::string& path) {
  if (id < 0) throw Error(ErrorKind::fault, path, "HDF5 failed" + system_reason());
  return wrapped(id, closer, path);
}

Turn take_turn() {
  static std::mutex mutex;
  Turn turn(mutex);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are told by Error alone
  return turn;
}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this == &other) return *this;
  close();
  id_ = std::exchange(other.id_, -1);
  closer_ = other.closer_;
  path_ = std::move(other.path_);
  return *this;
}

bool Handle::close() noexcept {
  if (id_ < 0) return true;
  return closer_(std::exchange(id_, -1)) >= 0;
}

Handle create_file(const std::string& path) {
  const Handle access = access_properties(path);
  const Handle creation = made(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path);
  H5Pset_obj_track_times(creation.id(), 0);
  Handle file = wrapped(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, path);
  if (!file.open()) throw Error(ErrorKind::fault, path, "cannot be created" + system_reason());
  return file;
}

Handle open_file(const std::string& path) {
  const Handle access = access_properties(path);
  Handle file = wrapped(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, path);
  if (!file.open())
    throw refused(path, "is no HDF5 file that can be read (cut short or damaged)" + system_reason());
  return file;
}

void flush(const Handle& file) {
  if (H5Fflush(file.id(), H5F_SCOPE_LOCAL) < 0) throw write_error(file.path(), "to the disk");
}

Handle create_group(const Handle& parent, const std::string& name) {
  const Handle creation = made(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, parent.path());
  H5Pset_obj_track_times(creation.id(), 0);
  Handle group = wrapped(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Gclose, parent.path());
  if (!group.open()) throw write_error(parent.path(), name);
  return group;
}

bool has_link(const Handle& parent, const std::string& name) {
  return H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT) > 0;
}

Handle open_group(const Handle& parent, const std::string& name) {
  Handle group = wrapped(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, parent.path());
  if (!group.open()) throw read_error(parent.path(), name);
  return group;
}

}  // namespace fingerpad::hdf5
