#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// Where something stands in a text file, from 1; 0 where it stands nowhere.
struct Place {
  int line = 0;
  int column = 0;
};

struct TomlEntry;

/// A TOML value as plain data: copied freely with its place (toml++ forgets it), tables in the order written
/// (toml++ sorts them).
struct TomlNode {
  enum class Type { boolean, integer, number, text, date, array, table };
  Type type = Type::table;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0;               ///< of a number, and of an integer
  std::string text;                ///< of a text
  std::vector<TomlNode> items;     ///< of an array
  std::vector<TomlEntry> entries;  ///< of a table, in the order written
  std::string written;             ///< of a boolean, an integer or a number: as it stands in the file
  Place place;

  bool is(Type wanted) const noexcept { return type == wanted; }
};

struct TomlEntry {
  std::string key;
  Place place;  ///< of the key
  TomlNode value;
};

TomlNode toml_text(std::string text);
/// @param written  as it stands in the file
TomlNode toml_integer(std::int64_t value, std::string written);
TomlNode toml_number(double value, std::string written);

/// The entry of a table by key; nullptr if there is none, or if `table` is no table.
const TomlEntry* find_entry(const TomlNode& table, std::string_view key) noexcept;
TomlEntry* find_entry(TomlNode& table, std::string_view key) noexcept;

/// "file:line:column", or the file alone for a place that is nowhere.
std::string place_text(const std::string& file, const Place& place);

/// What a value is, for messages: "a string", "a table".
std::string_view type_text(TomlNode::Type type) noexcept;

/// Parses TOML. Throws Error (refused, `file:line:column`) for bad syntax and for keys of absurdly many
/// parts.
TomlNode parse_toml(const std::string& text, const std::string& file);

/// A table as a TOML file: values, then tables, then arrays of tables; tables inside those are written
/// inline.
std::string write_toml(const TomlNode& root);

/// One value as it would stand after a `=`.
std::string write_toml_value(const TomlNode& value);

}  // namespace fingerpad
