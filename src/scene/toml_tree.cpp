#include "scene/toml_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/error.hpp"

namespace fingerpad {
namespace {

/// toml++ 3.3 builds a table per part of a dotted key and takes them down recursively, so that a line of dots
/// would overflow the stack: no key of a scene has more than a few parts.
constexpr int max_key_dots = 16;

/// The position after the string that starts at `i`.
std::size_t after_string(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const std::string_view fence = text.substr(i, 3);
  const bool many_lines = fence.size() == 3 && fence[1] == quote && fence[2] == quote;
  for (std::size_t k = i + (many_lines ? 3 : 1); k < text.size(); ++k) {
    if (text[k] == '\\' && quote == '"') {
      ++k;
    } else if (many_lines ? text.substr(k, 3) == fence : text[k] == quote) {
      return k + (many_lines ? 3 : 1);
    } else if (!many_lines && text[k] == '\n') {
      return k;  // never closed: the parser says so
    }
  }
  return text.size();
}

void refuse_deep_keys(std::string_view text, const std::string& file) {
  int dots = 0, line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = after_string(text, i);
      line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                          text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '\n' || c == '=' || c == ',' || c == '{' || c == '[') dots = 0;
    if (c == '\n') ++line;
    if (c == '.' && ++dots > max_key_dots) {
      throw refused(fmt::format("{}:{}", file, line), fmt::format("a key of over {} parts", max_key_dots));
    }
    ++i;
  }
}

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

/// A line of the file. Its columns count code points.
class Line {
 public:
  explicit Line(std::string_view text) : text_(text) {
    const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
    if (std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80u; }))
      return;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!goes_on(text[i])) starts_.push_back(i);
    }
  }

  /// From one column up to another, from 1; without blanks at the end.
  std::string between(std::size_t begin, std::size_t end) const {
    const std::size_t from = start(begin), to = std::max(from, start(end));
    std::string_view out = text_.substr(from, to - from);
    while (!out.empty() && (out.back() == ' ' || out.back() == '\t' || out.back() == '\r'))
      out.remove_suffix(1);
    return std::string(out);
  }

 private:
  std::size_t start(std::size_t column) const {
    if (starts_.empty()) return std::min(column - 1, text_.size());
    return column <= starts_.size() ? starts_[column - 1] : text_.size();
  }

  std::string_view text_;
  std::vector<std::size_t> starts_;  // of each column; empty where every byte is one
};

TomlNode placed(TomlNode node, const toml::node& from) {
  node.place = place_of(from.source());
  return node;
}

/// Turns toml++ nodes into ours, with the file at hand to quote numbers as written.
class Converter {
 public:
  explicit Converter(std::string_view text) {
    for (std::size_t start = 0; start <= text.size();) {
      const std::size_t end = std::min(text.find('\n', start), text.size());
      lines_.emplace_back(text.substr(start, end - start));
      start = end + 1;
    }
  }

  TomlNode node(const toml::node& from) const {
    TomlNode to;
    to.place = place_of(from.source());
    switch (from.type()) {
      case toml::node_type::table:
        return table(*from.as_table());
      case toml::node_type::array:
        to.type = TomlNode::Type::array;
        for (const toml::node& item : *from.as_array()) to.items.push_back(node(item));
        return to;
      case toml::node_type::string:
        to.type = TomlNode::Type::text;
        to.text = from.as_string()->get();
        return to;
      case toml::node_type::integer:
        return placed(toml_integer(from.as_integer()->get(), quoted(from.source())), from);
      case toml::node_type::floating_point:
        return placed(toml_number(from.as_floating_point()->get(), quoted(from.source())), from);
      case toml::node_type::boolean:
        to.type = TomlNode::Type::boolean;
        to.boolean = from.as_boolean()->get();
        break;
      default:
        to.type = TomlNode::Type::date;
    }
    to.written = quoted(from.source());
    return to;
  }

  TomlNode table(const toml::table& from) const {
    TomlNode to;
    to.type = TomlNode::Type::table;
    to.place = place_of(from.source());
    for (const auto& [key, value] : from) {
      to.entries.push_back({std::string(key.str()), place_of(key.source()), node(value)});
    }
    std::stable_sort(to.entries.begin(), to.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
      return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    return to;
  }

 private:
  /// The text of a region within one line.
  std::string quoted(const toml::source_region& region) const {
    const bool in_one_line = region.begin.line > 0 && region.begin.line == region.end.line;
    if (!in_one_line || region.begin.line > lines_.size() || region.begin.column == 0) return {};
    return lines_[region.begin.line - 1].between(region.begin.column, region.end.column);
  }

  std::vector<Line> lines_;
};

}  // namespace

TomlNode toml_text(std::string text) {
  TomlNode node;
  node.type = TomlNode::Type::text;
  node.text = std::move(text);
  return node;
}

TomlNode toml_integer(std::int64_t value, std::string written) {
  TomlNode node = toml_number(static_cast<double>(value), std::move(written));
  node.type = TomlNode::Type::integer;
  node.integer = value;
  return node;
}

TomlNode toml_number(double value, std::string written) {
  TomlNode node;
  node.type = TomlNode::Type::number;
  node.number = value;
  node.written = std::move(written);
  return node;
}

const TomlEntry* find_entry(const TomlNode& table, std::string_view key) noexcept {
  for (const TomlEntry& entry : table.entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

TomlEntry* find_entry(TomlNode& table, std::string_view key) noexcept {
  return const_cast<TomlEntry*>(find_entry(std::as_const(table), key));
}

std::string place_text(const std::string& file, const Place& place) {
  return place.line > 0 ? fmt::format("{}:{}:{}", file, place.line, place.column) : file;
}

std::string_view type_text(TomlNode::Type type) noexcept {
  switch (type) {
    case TomlNode::Type::boolean:
      return "true or false";
    case TomlNode::Type::integer:
      return "a whole number";
    case TomlNode::Type::number:
      return "a number";
    case TomlNode::Type::text:
      return "a string";
    case TomlNode::Type::date:
      return "a date or time";
    case TomlNode::Type::array:
      return "a list";
    case TomlNode::Type::table:
      return "a table";
  }
  return "";
}

namespace {

/// Whether a number goes on there with a comma and digits: "0,3", which TOML writes 0.3. Lists have their
/// commas within brackets, of which the parser complains otherwise.
bool has_decimal_comma(const std::string& text, const Place& place) {
  std::istringstream lines(text);
  std::string line;
  for (int k = 0; k < place.line; ++k)
    if (!std::getline(lines, line)) return false;
  const auto at = static_cast<std::size_t>(std::max(place.column, 0));
  const auto is_digit = [&](std::size_t k) { return k < line.size() && line[k] >= '0' && line[k] <= '9'; };
  for (std::size_t comma = line.find(','); comma != std::string::npos; comma = line.find(',', comma + 1))
    if (comma + 1 == at || comma + 2 == at) return comma > 0 && is_digit(comma - 1) && is_digit(comma + 1);
  return false;
}

}  // namespace

TomlNode parse_toml(const std::string& text, const std::string& file) {
  refuse_deep_keys(text, file);
  try {
    const toml::table table = toml::parse(text, file);
    return Converter(text).table(table);
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    if (has_decimal_comma(text, place))
      throw refused(place_text(file, place), "a number has a comma: write a decimal point, as in 0.3");
    throw refused(place_text(file, place), fmt::format("{}", error.description()));
  }
}

}  // namespace fingerpad
