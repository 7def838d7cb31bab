#include "base/unit_row.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit_ending.hpp"

namespace fingerpad {
namespace {

constexpr std::string_view si_symbols[quantities] = {"s", "m", "N", "N m", "m/s"};

std::string_view si_words(Quantity quantity) {
  constexpr std::string_view words[quantities] = {"seconds", "metres", "newtons", "newton metres",
                                                  "metres a second"};
  return words[static_cast<std::size_t>(quantity)];
}

bool is_unitless(std::string_view word) {
  return word.empty() || word == "-" || word == "1";
}

/// What a column's name ends in that may be a unit: "mm" of "X [mm]" and "x (mm)"; else what stands behind
/// its last "_", "/", comma or blank.
std::vector<std::string_view> unit_words(std::string_view name) {
  if (name.ends_with(']') || name.ends_with(')')) {
    const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
    if (open == std::string_view::npos) return {};
    return {trimmed(name.substr(open + 1, name.size() - open - 2))};
  }
  std::vector<std::string_view> words;
  for (const char mark : {'_', '/', ',', ' '})
    if (const std::size_t at = name.rfind(mark); at != std::string_view::npos)
      words.push_back(trimmed(name.substr(at + 1)));
  return words;
}

/// @param name  one of the group's columns, whose unit nobody says
void refuse_named_unit(const std::string& path, std::string_view name, const UnitGroup& group) {
  if (unit_in_ending(name) == si_symbols[static_cast<std::size_t>(group.quantity)]) return;
  const std::string column = fmt::format("has the column '{}', whose name says", printable(name, 60));
  for (const std::string_view word : unit_words(name)) {
    const auto si = si_per_unit(group.quantity, word);
    if (si && *si == group.si_per_unit) return;
    if (si)
      throw refused(path, fmt::format("{} a unit that is not said: say {}, \"{}\" if it is right", column,
                                      group.option, listed_unit(group.quantity, word)));
    if (is_other_unit(word))
      throw refused(path,
                    fmt::format("{} the unit '{}', and of a {} these are known: {}; turn its numbers into "
                                "one of them, and say {}",
                                column, printable(word, 20), quantity_words(group.quantity),
                                unit_list(group.quantity), group.option));
  }
}

}  // namespace

std::optional<double> unit_in_name(Quantity quantity, std::string_view name) {
  if (unit_in_ending(name) == si_symbols[static_cast<std::size_t>(quantity)]) return 1;
  for (const std::string_view word : unit_words(name))
    if (const auto si = si_per_unit(quantity, word)) return si;
  return std::nullopt;
}

std::optional<double> told_unit(const UnitRow& row, const std::vector<std::string_view>& names,
                                const UnitGroup& group) {
  std::optional<double> found;
  std::string first;
  // Where people cannot say a unit, numbers must be in SI.
  const bool is_line = row.source == UnitSource::line;
  const std::string_view leave_out = is_line ? "put # before the line" : "delete the attribute";
  const std::string si = fmt::format("turn the column into {}", si_words(group.quantity));
  const std::string mend = group.option.empty() ? fmt::format("{} and {}", si, leave_out)
                                                : fmt::format("{}, and say {}", leave_out, group.option);
  const auto fault = [&](std::size_t column, const std::string& what) {
    return refused(row.place, fmt::format("has {}'{}' {} '{}', {}", is_line ? "" : "the unit ",
                                          printable(row.words[column], 40), is_line ? "below" : "at",
                                          printable(names[column], 60), what));
  };
  for (const std::size_t column : group.columns) {
    if (column >= row.words.size() || is_unitless(row.words[column])) continue;
    const std::string& word = row.words[column];
    const auto unit = si_per_unit(group.quantity, word);
    if (!unit)
      throw fault(column, fmt::format("which is no unit of {} that is known ({}): {}",
                                      quantity_words(group.quantity), unit_list(group.quantity), mend));
    if (group.is_said && *unit != group.si_per_unit)
      throw fault(column, fmt::format("and {} says another unit: leave that out, or {} if it is wrong",
                                      group.option, leave_out));
    if (!group.is_said && unit_in_name(group.quantity, names[column]).value_or(*unit) != *unit)
      throw fault(column, fmt::format("whose name says another unit: {}", mend));
    if (found && *unit != *found)
      throw fault(column, fmt::format("and '{}' {} another column of that kind, which all have one unit "
                                      "here: turn them into one, and {}",
                                      first, is_line ? "below" : "at",
                                      !group.option.empty() ? mend
                                      : is_line             ? "let the line say it"
                                                            : "let the attributes say it"));
    found = *unit;
    first = word;
  }
  return found;
}

std::optional<double> told_unit_or_ask(const std::string& path, const UnitRow& row,
                                       const std::vector<std::string_view>& names, const UnitGroup& group) {
  const auto told = told_unit(row, names, group);
  if (!told && !group.is_said)
    for (const std::size_t column : group.columns) refuse_named_unit(path, names[column], group);
  return told;
}

std::string told_units_words(const ToldUnits& told, UnitSource source) {
  constexpr std::string_view things[quantities] = {"time", "position", "force", "torque", "speed"};
  std::string words;
  for (std::size_t q = 0; q < quantities; ++q) {
    if (told[q])
      words += fmt::format("{}a {} is {} {}", words.empty() ? "" : ", ", things[q], rounded_text(*told[q], 6),
                           si_symbols[q]);
  }
  if (words.empty()) return words;
  return fmt::format("units as {}: {}",
                     source == UnitSource::line ? "the line below its header has them"
                                                : "the attributes of its datasets have them",
                     words);
}

}  // namespace fingerpad
