#include "base/unit.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

/// What a unit is called, and the part of it that is its quantity's own.
struct NamedUnit {
  std::string_view name;
  double factor;
};

std::vector<NamedUnit> units_of(Quantity quantity) {
  std::vector<NamedUnit> units;
  switch (quantity) {
    case Quantity::time:
      for (const TimeUnit& unit : time_units) units.push_back({unit.name, unit.seconds});
      break;
    case Quantity::length:
      for (const LengthUnit& unit : length_units) units.push_back({unit.name, unit.metres});
      break;
    case Quantity::force:
      for (const ForceUnit& unit : force_units) units.push_back({unit.name, unit.newtons});
      break;
    case Quantity::torque:
      for (const TorqueUnit& unit : torque_units) units.push_back({unit.name, unit.newton_metres});
      break;
    case Quantity::speed:
      units = {{"m/s", 1}, {"mm/s", 1e-3}, {"cm/s", 1e-2}, {"in/s", 25.4e-3}, {"um/s", 1e-6}};
      break;
  }
  return units;
}

/// How people write some of them too; micro in Latin-1 as well.
struct Spelling {
  std::string_view written, name;
};
constexpr Spelling spellings[] = {
    {"sec", "s"},          {"second", "s"},       {"seconds", "s"},  {"msec", "ms"},
    {"usec", "us"},        {"nsec", "ns"},        {"minute", "min"}, {"minutes", "min"},
    {"metre", "m"},        {"metres", "m"},       {"meter", "m"},    {"meters", "m"},
    {"millimetres", "mm"}, {"millimeters", "mm"}, {"newton", "N"},   {"newtons", "N"},
    {"\u00b5s", "us"},     {"\u03bcs", "us"},     {"\xb5s", "us"},   {"inch", "in"},
    {"\u00b5m", "um"},     {"\u03bcm", "um"},     {"\xb5m", "um"},   {"micrometres", "um"},
    {"micrometers", "um"}, {"g", "gf"},           {"gram", "gf"},    {"grams", "gf"},
    {"kg", "kgf"},         {"lbs", "lbf"},        {"lb", "lbf"},     {"inches", "in"},
    {"Nm", "N.m"},         {"N m", "N.m"},        {"N*m", "N.m"},    {"N\u00b7m", "N.m"},
    {"Nmm", "N.mm"},       {"N mm", "N.mm"},      {"N*mm", "N.mm"},  {"N\u00b7mm", "N.mm"}};

/// "mm/s" of "mm s^-1", "mm.s-1" and the like; any other word as it is.
std::string with_stroke(std::string_view word) {
  for (const std::string_view power : {"^-1", "-1", "\u207b\u00b9"}) {
    if (!word.ends_with(power)) continue;
    const std::string_view product = word.substr(0, word.size() - power.size());
    for (const std::string_view mark : {" ", ".", "*", "\u00b7"}) {
      const std::size_t at = product.rfind(mark);
      if (at != std::string_view::npos)
        return std::string(product.substr(0, at)) + '/' + std::string(product.substr(at + mark.size()));
    }
  }
  return std::string(word);
}

}  // namespace

std::string_view quantity_words(Quantity quantity) noexcept {
  constexpr std::string_view words[] = {"time", "length", "force", "torque", "speed"};
  return words[static_cast<std::size_t>(quantity)];
}

bool is_other_unit(std::string_view word) {
  constexpr std::string_view others[] = {"ft",  "foot",  "feet",   "yd",     "dm",    "km", "nm",
                                         "mil", "V",     "mV",     "volt",   "volts", "oz", "ozf",
                                         "px",  "pixel", "pixels", "counts", "a.u.",  "%"};
  return std::ranges::find(others, word) != std::end(others);
}

std::string_view listed_unit(Quantity quantity, std::string_view word) {
  const std::vector<NamedUnit> units = units_of(quantity);
  for (const Spelling& spelling : spellings)
    if (spelling.written == word && std::ranges::find(units, spelling.name, &NamedUnit::name) != units.end())
      return spelling.name;
  return word;
}

std::optional<double> si_per_unit(Quantity quantity, std::string_view word) {
  word = listed_unit(quantity, word);
  std::string stroke(word);
  if (quantity == Quantity::speed) {
    stroke = with_stroke(word);
    const std::size_t length = std::min(stroke.find('/'), stroke.size());
    stroke.replace(0, length, listed_unit(Quantity::length, std::string_view(stroke).substr(0, length)));
  }
  for (const NamedUnit& unit : units_of(quantity))
    if (unit.name == stroke) return unit.factor;
  return std::nullopt;
}

std::string unit_list(Quantity quantity) {
  std::string list;
  for (const NamedUnit& unit : units_of(quantity)) {
    if (!list.empty()) list += ", ";
    list += unit.name;
  }
  return list;
}

std::vector<std::string> length_unit_names() {
  std::vector<std::string> names;
  names.reserve(std::size(length_units));
  for (const LengthUnit& unit : length_units) names.emplace_back(unit.name);
  return names;
}

std::optional<double> metres_per_unit(std::string_view name) noexcept {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit.metres;
  }
  return std::nullopt;
}

}  // namespace fingerpad
