#pragma once

#include <hdf5.h>

#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "trace/hdf5_file.hpp"

/// What the files that call HDF5 share.
namespace fingerpad::hdf5 {

static_assert(std::is_same_v<hid_t, Handle::Id>);
static_assert(std::is_same_v<herr_t, int>);

/// What the system said at the bottom of HDF5's error stack (": No space left on device"); empty if nothing.
std::string system_reason();

Error write_error(const std::string& path, const std::string& what);
Error read_error(const std::string& path, const std::string& what);

/// A handle on what an HDF5 call gave; not open if it failed.
inline Handle wrapped(hid_t id, herr_t (*closer)(hid_t), const std::string& path) {
  return {id, closer, path};
}

/// For the small objects that describe others; these fail only for want of memory. Throws Error (fault).
Handle made(hid_t id, herr_t (*closer)(hid_t), const std::string& path);

}  // namespace fingerpad::hdf5
