#include "scene/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.hpp"
#include "motion/farthest.hpp"

namespace fingerpad {
namespace {

std::string range_text(const NumberRange& range) {
  const NumberRange open;
  std::string out;
  if (range.min != open.min)
    out = fmt::format("{} {}", range.above_min ? "above" : "at least", number_text(range.min));
  if (range.max != open.max)
    out += fmt::format("{}at most {}", out.empty() ? "" : " and ", number_text(range.max));
  return out.empty() ? "finite" : out;
}

bool is_number(const TomlNode& value) {
  return value.is(TomlNode::Type::integer) || value.is(TomlNode::Type::number);
}

}  // namespace

TomlTable::TomlTable(const TomlNode& table, std::string file, std::string label,
                     const std::vector<std::string>& known)
    : table_(table), file_(std::move(file)), label_(std::move(label)) {
  for (const TomlEntry& entry : table.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    throw refused(place_text(file_, entry.place), unknown_word_text("key", entry.key, "in " + label_, known));
  }
}

const TomlNode* TomlTable::value(std::string_view key) const noexcept {
  const TomlEntry* entry = find_entry(table_, key);
  return entry != nullptr ? &entry->value : nullptr;
}

std::string TomlTable::name(std::string_view key) const {
  return fmt::format("'{}' in {}", key, label_);
}

Error TomlTable::error(std::string_view key, const std::string& what) const {
  const TomlEntry* entry = find_entry(table_, key);
  if (entry == nullptr) return refused(place_text(file_, table_.place), what);
  // The line of a mistake is the line of its value (a list may hold several); an implicit table has only its
  // key's.
  return refused(place_text(file_, entry->value.place.line > 0 ? entry->value.place : entry->place), what);
}

void TomlTable::require(std::string_view key) const {
  if (!has(key)) throw error(key, fmt::format("{} needs the key '{}'", label_, key));
}

const TomlNode& TomlTable::typed(std::string_view key, const TomlNode& value, bool good,
                                 std::string_view wanted) const {
  if (!good) throw error(key, fmt::format("{} must be {}, not {}", name(key), wanted, type_text(value.type)));
  return value;
}

double TomlTable::number(std::string_view key, double fallback, const NumberRange& range) const {
  const TomlNode* found = value(key);
  if (found == nullptr) return fallback;
  const double number = typed(key, *found, is_number(*found), "a number").number;
  const bool inside = std::isfinite(number) && number <= range.max &&
                      (range.above_min ? number > range.min : number >= range.min);
  if (!inside) {
    throw error(key,
                fmt::format("{} is {}; it must be {}", name(key), number_text(number), range_text(range)));
  }
  return number;
}

std::int64_t TomlTable::whole(std::string_view key, std::int64_t fallback, std::int64_t min,
                              std::int64_t max) const {
  const TomlNode* found = value(key);
  if (found == nullptr) return fallback;
  if (found->is(TomlNode::Type::number))
    throw error(key, fmt::format("{} must be a whole number, and {} is none", name(key), found->written));
  const std::int64_t number =
      typed(key, *found, found->is(TomlNode::Type::integer), "a whole number").integer;
  if (number < min || number > max) {
    throw error(key, fmt::format("{} is {}; it must be from {} to {}", name(key), number, min, max));
  }
  return number;
}

bool TomlTable::flag(std::string_view key, bool fallback) const {
  const TomlNode* found = value(key);
  if (found == nullptr) return fallback;
  return typed(key, *found, found->is(TomlNode::Type::boolean), "true or false").boolean;
}

std::string TomlTable::text(std::string_view key, const std::string& fallback) const {
  const TomlNode* found = value(key);
  if (found == nullptr) return fallback;
  const std::string& text = typed(key, *found, found->is(TomlNode::Type::text), "a string").text;
  if (text.find('\0') != std::string::npos) throw error(key, name(key) + " holds a null character");
  return text;
}

Vec3 TomlTable::vector(std::string_view key, const Vec3& fallback) const {
  const TomlNode* found = value(key);
  if (found == nullptr) return fallback;
  typed(key, *found, found->is(TomlNode::Type::array), "a list of three numbers");
  if (found->items.size() != 3) {
    throw error(key,
                fmt::format("{} must be a list of three numbers, not of {}", name(key), found->items.size()));
  }
  Vec3 vector;
  for (int i = 0; i < 3; ++i) {
    const TomlNode& item = found->items[static_cast<std::size_t>(i)];
    typed(key, item, is_number(item), "a list of three numbers");
    if (!(std::abs(item.number) <= farthest_m)) {
      throw error(key, fmt::format("{} holds {}; it must lie between -{:g} and {:g}", name(key),
                                   number_text(item.number), farthest_m, farthest_m));
    }
    vector[i] = item.number;
  }
  return vector;
}

Vec3 TomlTable::direction(std::string_view key, const Vec3& fallback) const {
  if (!has(key)) return fallback;
  const Vec3 given = vector(key, fallback);
  // Scaled first, so that a tiny vector keeps its direction.
  const double largest = given.cwiseAbs().maxCoeff();
  if (!(largest > 1e-100)) throw error(key, name(key) + " is zero and names no direction");
  return (given / largest).normalized();
}

std::size_t TomlTable::choice(std::string_view key, std::size_t fallback,
                              const std::vector<std::string>& words) const {
  if (!has(key)) return fallback;
  const std::string word = text(key, "");
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  throw error(key, fmt::format("{}: {}", label_, unknown_word_text(key, word, "", words)));
}

}  // namespace fingerpad
