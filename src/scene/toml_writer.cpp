#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

std::string quoted_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(key) : quoted_text(key);
}

std::string float_text(double value) {
  const std::string text = number_text(value);
  const bool whole = std::isfinite(value) && text.find_first_of(".e") == std::string::npos;
  return whole ? text + ".0" : text;
}

bool is_table_array(const TomlNode& value) {
  const auto is_table = [](const TomlNode& item) { return item.is(TomlNode::Type::table); };
  return value.is(TomlNode::Type::array) && !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(), is_table);
}

void write_entries(std::string& out, const TomlNode& table) {
  for (const TomlEntry& entry : table.entries) {
    out += fmt::format("{} = {}\n", key_text(entry.key), write_toml_value(entry.value));
  }
}

}  // namespace

std::string write_toml_value(const TomlNode& value) {
  std::string out;
  switch (value.type) {
    case TomlNode::Type::boolean:
      return value.boolean ? "true" : "false";
    case TomlNode::Type::integer:
      return fmt::format("{}", value.integer);
    case TomlNode::Type::number:
      return float_text(value.number);
    case TomlNode::Type::text:
      return quoted_text(value.text);
    case TomlNode::Type::date:
      return value.written;
    case TomlNode::Type::array:
      for (const TomlNode& item : value.items) out += (out.empty() ? "" : ", ") + write_toml_value(item);
      return "[" + out + "]";
    case TomlNode::Type::table:
      for (const TomlEntry& entry : value.entries) {
        out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", key_text(entry.key),
                           write_toml_value(entry.value));
      }
      return out.empty() ? "{}" : "{ " + out + " }";
  }
  return out;
}

std::string write_toml(const TomlNode& root) {
  std::string values, tables;
  for (const TomlEntry& entry : root.entries) {
    if (entry.value.is(TomlNode::Type::table)) {
      tables += fmt::format("\n[{}]\n", key_text(entry.key));
      write_entries(tables, entry.value);
    } else if (is_table_array(entry.value)) {
      for (const TomlNode& item : entry.value.items) {
        tables += fmt::format("\n[[{}]]\n", key_text(entry.key));
        write_entries(tables, item);
      }
    } else {
      values += fmt::format("{} = {}\n", key_text(entry.key), write_toml_value(entry.value));
    }
  }
  return values + tables;
}

}  // namespace fingerpad
