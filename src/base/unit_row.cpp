#include "base/unit_row.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/error.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

/// The unit that a name of the program's own tables ends in, as x_m and tx_n_m.
std::optional<double> unit_in_name(Quantity quantity, std::string_view name) {
  constexpr std::string_view endings[] = {"_s", "_m", "_n", "_n_m"};
  return name.ends_with(endings[static_cast<std::size_t>(quantity)]) ? std::optional(1.0) : std::nullopt;
}

bool is_unitless(std::string_view word) {
  return word.empty() || word == "-" || word == "1";
}

}  // namespace

double unit_of_group(const UnitRow& row, const std::vector<std::string_view>& names, const UnitGroup& group) {
  double found = group.si_per_unit;
  std::string first;
  const std::string say = group.option.empty() ? "" : fmt::format(", and say {}", group.option);
  const auto fault = [&](std::size_t column, const std::string& what) {
    return refused(row.place, fmt::format("has '{}' below '{}', {}", printable(row.words[column], 40),
                                          printable(names[column], 60), what));
  };
  for (const std::size_t column : group.columns) {
    if (column >= row.words.size() || is_unitless(row.words[column])) continue;
    const std::string& word = row.words[column];
    const auto unit = si_per_unit(group.quantity, word);
    if (!unit)
      throw fault(column, fmt::format("which is no unit of {} that is known ({}): put # before the line{}",
                                      quantity_words(group.quantity), unit_list(group.quantity), say));
    if (group.is_said && *unit != group.si_per_unit)
      throw fault(column,
                  fmt::format("and {} says another unit: leave that out, or put # before the line if it "
                              "is wrong",
                              group.option));
    if (!group.is_said && unit_in_name(group.quantity, names[column]).value_or(*unit) != *unit)
      throw fault(column, fmt::format("whose name says another unit: put # before the line{}", say));
    if (!first.empty() && *unit != found)
      throw fault(column, fmt::format("and '{}' below another column of that kind, which all have one unit "
                                      "here: turn them into one, and put # before the line{}",
                                      first, say));
    found = *unit;
    first = word;
  }
  return found;
}

}  // namespace fingerpad
