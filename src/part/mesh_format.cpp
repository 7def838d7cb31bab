#include "part/mesh_format.hpp"

#include <algorithm>

#include "part/text_cursor.hpp"

namespace fingerpad {

const MeshFormat* format_of_ending(std::string_view ending) noexcept {
  const auto is_of = [ending](const MeshFormat& format) {
    return std::ranges::any_of(format.endings,
                               [ending](std::string_view known) { return same_word(ending, known); });
  };
  const auto table = mesh_format_table();
  const auto found = std::ranges::find_if(table, is_of);
  return found == table.end() ? nullptr : &*found;
}

std::string mesh_format_names(std::string_view last) {
  const auto table = mesh_format_table();
  std::string names;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (i > 0) names += i + 1 < table.size() ? ", " : ' ' + std::string(last) + ' ';
    names += table[i].name;
  }
  return names;
}

}  // namespace fingerpad
