// HDF5 lets a file keep its parts elsewhere: a link may lead into any file that the user can read, a dataset
// may have its numbers in one. A trace that does so would show what is no trace. So whatever is opened for
// reading passes here first.
#include <fmt/format.h>

#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

std::string object_name(H5O_type_t type) {
  switch (type) {
    case H5O_TYPE_GROUP:
      return "a group";
    case H5O_TYPE_DATASET:
      return "a dataset";
    case H5O_TYPE_NAMED_DATATYPE:
      return "a data type";
    default:
      return "an object that HDF5 does not know";
  }
}

std::string link_name(H5L_type_t type) {
  if (type == H5L_TYPE_SOFT) return "a link to another place (soft link)";
  if (type == H5L_TYPE_EXTERNAL) return "a link into another file (external link)";
  return "a link of a kind that HDF5 does not know";
}

/// Whether a dataset passes through nothing but filters that HDF5 has in itself and that undo what we do:
/// any other would be looked for among the user's plugins and loaded. Each once at most: one deflate within
/// another would unfold a thousand times a thousand times.
bool has_known_filters(const Handle& creation, int count) {
  bool has_shuffle = false, has_deflate = false;
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, configuration = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation.id(), static_cast<unsigned>(i), &flags, &values,
                                               nullptr, 0, nullptr, &configuration);
    if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE) return false;
    bool& has_it = filter == H5Z_FILTER_SHUFFLE ? has_shuffle : has_deflate;
    if (has_it) return false;
    has_it = true;
  }
  return true;
}

}  // namespace

void check_link(const Handle& parent, const std::string& name, const std::string& what, H5O_type_t wanted) {
  const auto refuse = [&](const std::string& is) {
    return refused(parent.path(),
                   fmt::format("is refused: {} '{}' is {}; a trace keeps all in itself", what, name, is));
  };
  H5L_info_t link{};
  if (H5Lget_info(parent.id(), name.c_str(), &link, H5P_DEFAULT) < 0) throw read_error(parent.path(), name);
  if (link.type != H5L_TYPE_HARD) throw refuse(link_name(link.type));
  H5O_info_t object{};
  if (H5Oget_info_by_name2(parent.id(), name.c_str(), &object, H5O_INFO_BASIC, H5P_DEFAULT) < 0) {
    throw read_error(parent.path(), name);
  }
  if (object.type == wanted) return;
  throw refused(parent.path(),
                fmt::format("is refused: {} '{}' is {}", what, name, object_name(object.type)));
}

void check_storage(const Handle& dataset, const std::string& name, const std::string& what) {
  const auto refuse = [&](const std::string& does) {
    return refused(dataset.path(), fmt::format("is refused: {} '{}' {}", what, name, does));
  };
  const Handle creation = wrapped(H5Dget_create_plist(dataset.id()), H5Pclose, dataset.path());
  if (!creation.open()) throw read_error(dataset.path(), name);
  const int files = H5Pget_external_count(creation.id());
  const H5D_layout_t layout = H5Pget_layout(creation.id());
  const int filters = H5Pget_nfilters(creation.id());
  if (files > 0) throw refuse("keeps its numbers in another file (external storage)");
  if (layout == H5D_VIRTUAL) throw refuse("is put together from other datasets (virtual dataset)");
  if (filters > 0 && !has_known_filters(creation, filters)) {
    throw refuse(
        "passes through filters that no trace has (deflate and shuffle alone, once each); 'h5repack -f NONE "
        "IN.h5 OUT.h5' undoes that");
  }
  const bool plain = layout == H5D_COMPACT || layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED;
  if (files < 0 || filters < 0 || !plain) throw read_error(dataset.path(), name);
  hsize_t file_bytes = 0;
  const Handle file = wrapped(H5Iget_file_id(dataset.id()), H5Fclose, dataset.path());
  if (H5Fget_filesize(file.id(), &file_bytes) < 0 || H5Dget_storage_size(dataset.id()) > file_bytes) {
    throw refused(dataset.path(),
                  fmt::format("is damaged: {} '{}' takes more bytes than the file has", what, name));
  }
}

}  // namespace fingerpad::hdf5
