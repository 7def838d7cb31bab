#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/printable_text.hpp"
#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

constexpr std::size_t most_named = 12;        // of each group
constexpr std::size_t most_looked_at = 1000;  // likewise
constexpr std::size_t longest_name = 40;

/// What a link leads to, where that is an object of the file's own; nothing is followed to find out.
H5O_type_t type_of(const Handle& parent, const std::string& name) {
  H5L_info_t link{};
  H5O_info_t object{};
  const bool is_own =
      H5Lget_info(parent.id(), name.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD &&
      H5Oget_info_by_name2(parent.id(), name.c_str(), &object, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
  return is_own ? object.type : H5O_TYPE_UNKNOWN;
}

/// Some names of a group's links.
struct Names {
  std::vector<std::string> looked_at;
  bool is_cut = false;  ///< there are more
};

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* into) {
  auto& names = *static_cast<Names*>(into);
  names.is_cut = names.looked_at.size() == most_looked_at;
  if (names.is_cut) return 1;  // ends the walk
  names.looked_at.emplace_back(name);
  return 0;
}

/// By the alphabet. Of very many those that the file keeps first: to put all in order takes seconds.
Names names_in(const Handle& group) {
  Names names;
  hsize_t at = 0;
  H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &at, add_name, &names);
  std::sort(names.looked_at.begin(), names.looked_at.end());
  return names;
}

/// "500 x 3", or why it has no such shape. HDF5 opens the other files of a virtual dataset to tell its
/// extents, whatever these files are: so its storage is asked first.
std::string shape_words(const Handle& dataset) {
  const Handle creation = wrapped(H5Dget_create_plist(dataset.id()), H5Pclose, dataset.path());
  if (!creation.open()) return "unreadable";
  if (H5Pget_layout(creation.id()) == H5D_VIRTUAL) return "a virtual dataset, put together from others";
  if (H5Pget_external_count(creation.id()) != 0) return "in another file, as external storage";
  const Handle type = wrapped(H5Dget_type(dataset.id()), H5Tclose, dataset.path());
  const Handle space = wrapped(H5Dget_space(dataset.id()), H5Sclose, dataset.path());
  const H5T_class_t kind = H5Tget_class(type.id());
  const std::string_view no_numbers = kind == H5T_INTEGER || kind == H5T_FLOAT ? "" : ", no numbers";
  const H5S_class_t shape = H5Sget_simple_extent_type(space.id());
  if (shape == H5S_SCALAR) return fmt::format("a scalar{}", no_numbers);
  std::array<hsize_t, H5S_MAX_RANK> size{};
  const int rank = shape == H5S_SIMPLE ? H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) : 0;
  if (rank < 1) return "empty";
  return fmt::format("{}{}", fmt::join(size.begin(), size.begin() + rank, " x "), no_numbers);
}

/// "pos (500 x 3)".
std::string dataset_words(const Handle& parent, const std::string& name) {
  const Handle dataset = wrapped(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose, parent.path());
  return fmt::format("{} ({})", printable(name, longest_name),
                     dataset.open() ? shape_words(dataset) : "unreadable");
}

std::string group_words(const Handle& group, int deeper);

std::string object_words(const Handle& parent, const std::string& name, int deeper) {
  const H5O_type_t type = type_of(parent, name);
  if (type == H5O_TYPE_DATASET) return dataset_words(parent, name);
  if (type != H5O_TYPE_GROUP) return printable(name, longest_name);
  const Handle group = wrapped(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, parent.path());
  const std::string inside = deeper > 0 && group.open() ? group_words(group, deeper - 1) : "";
  return fmt::format("the group {}{}", printable(name, longest_name),
                     inside.empty() ? "" : " with " + inside);
}

std::string group_words(const Handle& group, int deeper) {
  const Names names = names_in(group);
  const std::size_t named = std::min(names.looked_at.size(), most_named),
                    left = names.looked_at.size() - named;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < named; ++i) words.push_back(object_words(group, names.looked_at[i], deeper));
  if (left > 0) words.push_back(fmt::format("and {}{} more", names.is_cut ? "more than " : "", left));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string contents_words(const Handle& file) {
  const Turn turn;
  const Handle root = wrapped(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, file.path());
  const std::string words = root.open() ? group_words(root, 1) : "";
  return words.empty() ? "it holds nothing" : "it holds " + words;
}

}  // namespace fingerpad::hdf5
