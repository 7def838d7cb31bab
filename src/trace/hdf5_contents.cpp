#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/printable_text.hpp"
#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

constexpr hsize_t most_named = 12;  // of each group
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

/// Names by the alphabet, the first of them.
std::vector<std::string> names_in(const Handle& group, bool& are_more) {
  H5G_info_t info{};
  std::vector<std::string> names;
  if (H5Gget_info(group.id(), &info) < 0) return names;
  are_more = info.nlinks > most_named;
  for (hsize_t i = 0; i < std::min(info.nlinks, most_named); ++i) {
    std::string name(200, '\0');
    const ssize_t length = H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                                              name.size(), H5P_DEFAULT);
    if (length <= 0) continue;
    name.resize(std::min(static_cast<std::size_t>(length), name.size() - 1));
    names.push_back(std::move(name));
  }
  return names;
}

/// "pos (500 x 3)".
std::string dataset_words(const Handle& parent, const std::string& name) {
  const Handle dataset = wrapped(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose, parent.path());
  const std::vector<std::uint64_t> size = dataset.open() ? extents(dataset) : std::vector<std::uint64_t>();
  const std::string shape = size.empty() ? "no numbers" : fmt::format("{}", fmt::join(size, " x "));
  return fmt::format("{} ({})", printable(name, longest_name), shape);
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
  bool are_more = false;
  std::vector<std::string> words;
  for (const std::string& name : names_in(group, are_more))
    words.push_back(object_words(group, name, deeper));
  if (are_more) words.emplace_back("...");
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
