#include "scene/set_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

constexpr const char* mend = "write { from = 0.2, to = 0.4, steps = 5 } or { values = [0.2, 0.3] }";

Error refuse_range(const TomlNode& node, const std::string& key, const std::string& path,
                   const std::string& what) {
  return refused(place_text(path, node.place), fmt::format("'{}' in [[set]] {}; {}", key, what, mend));
}

bool is_plain_number(const TomlNode& node) {
  return node.is(TomlNode::Type::integer) || node.is(TomlNode::Type::number);
}

const TomlNode& end_of_range(const TomlNode& table, std::string_view name, const std::string& key,
                             const std::string& path) {
  const TomlEntry* entry = find_entry(table, name);
  if (entry == nullptr) throw refuse_range(table, key, path, fmt::format("lacks '{}'", name));
  if (!is_plain_number(entry->value) || !std::isfinite(entry->value.number))
    throw refuse_range(entry->value, key, path, fmt::format("has no number for '{}'", name));
  return entry->value;
}

TomlNode value_node(double value, bool whole, const Place& place) {
  TomlNode node;
  if (whole && value == std::floor(value) && std::abs(value) < 9e15) {
    const auto integer = static_cast<std::int64_t>(value);
    node = toml_integer(integer, std::to_string(integer));
  } else {
    std::string written = number_text(value);
    if (written.find_first_of(".e") == std::string::npos) written += ".0";
    node = toml_number(value, std::move(written));
  }
  node.place = place;
  return node;
}

}  // namespace

bool is_set_range(const TomlNode& table) noexcept {
  if (!table.is(TomlNode::Type::table)) return false;
  return std::any_of(table.entries.begin(), table.entries.end(), [](const TomlEntry& entry) {
    return entry.key == "from" || entry.key == "to" || entry.key == "steps" || entry.key == "values";
  });
}

TomlNode range_values(const TomlNode& table, const std::string& key, bool wants_wholes,
                      const std::string& path) {
  for (const TomlEntry& entry : table.entries) {
    const bool known =
        entry.key == "from" || entry.key == "to" || entry.key == "steps" || entry.key == "values";
    if (!known) throw refuse_range(entry.value, key, path, fmt::format("knows no '{}'", entry.key));
  }
  if (const TomlEntry* values = find_entry(table, "values")) {
    if (table.entries.size() > 1) throw refuse_range(table, key, path, "has values and a range");
    if (!values->value.is(TomlNode::Type::array))
      throw refuse_range(values->value, key, path, "has values that are no list");
    return values->value;
  }
  const TomlNode& from = end_of_range(table, "from", key, path);
  const TomlNode& to = end_of_range(table, "to", key, path);
  const TomlNode& steps = end_of_range(table, "steps", key, path);
  if (!steps.is(TomlNode::Type::integer) || steps.integer < 2)
    throw refuse_range(steps, key, path, "needs steps of 2 or more, a whole number");
  const bool whole = wants_wholes || (from.is(TomlNode::Type::integer) && to.is(TomlNode::Type::integer));
  const double first = from.number, span = to.number - first;
  TomlNode list;
  list.type = TomlNode::Type::array;
  list.place = table.place;
  const auto count = std::min<std::int64_t>(steps.integer, max_jobs + 1);
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps.integer - 1);
    const double exact = i + 1 == steps.integer ? to.number : first + share * span;
    const double value = parse_number(fmt::format("{:.12g}", exact)).value_or(exact);
    list.items.push_back(value_node(i == 0 || i + 1 == steps.integer ? exact : value, whole, table.place));
  }
  return list;
}

}  // namespace fingerpad
