#include "part/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "part/raw_mesh.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

PlyType type_of(std::string_view word, const std::string& place) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{
      {{"char", PlyType::int8},
       {"int8", PlyType::int8},
       {"uchar", PlyType::uint8},
       {"uint8", PlyType::uint8},
       {"short", PlyType::int16},
       {"int16", PlyType::int16},
       {"ushort", PlyType::uint16},
       {"uint16", PlyType::uint16},
       {"int", PlyType::int32},
       {"int32", PlyType::int32},
       {"uint", PlyType::uint32},
       {"uint32", PlyType::uint32},
       {"float", PlyType::float32},
       {"float32", PlyType::float32},
       {"double", PlyType::float64},
       {"float64", PlyType::float64}}};
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  throw refused(place, "'" + shown(word) + "' is no type that a PLY property can have");
}

PlyProperty property_of(TextCursor& line, const std::string& place) {
  PlyProperty property;
  std::string_view word = line.word_in_line();
  if (word == "list") {
    property.is_list = true;
    property.count_type = type_of(line.word_in_line(), place);
    if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
      throw refused(place, "the count of a list cannot be a fraction");
    }
    word = line.word_in_line();
  }
  property.type = type_of(word, place);
  property.name = std::string(line.word_in_line());
  if (property.name.empty()) throw refused(place, "a property without a name");
  return property;
}

PlyElement element_of(TextCursor& line, const std::string& place) {
  PlyElement element;
  element.name = std::string(line.word_in_line());
  const std::string_view word = line.word_in_line();
  const auto count = integer_of(word);
  if (!count) throw refused(place, "the number of elements should stand here: " + not_a_number(word));
  element.count = *count;
  return element;
}

PlyHeader::Form form_of(TextCursor& line, const std::string& place) {
  const std::string_view word = line.word_in_line();
  line.word_in_line();  // the version
  if (word == "ascii") return PlyHeader::Form::text;
  if (word == "binary_little_endian") return PlyHeader::Form::little_endian;
  if (word == "binary_big_endian") return PlyHeader::Form::big_endian;
  throw refused(place, "'" + shown(word) + "' is no format of a PLY");
}

void check_counts(const PlyHeader& header, std::size_t bytes_left, const std::string& place) {
  constexpr std::size_t many = 100;
  if (header.elements.size() > many)
    throw refused(place, "the header announces more than 100 kinds of elements");
  for (const PlyElement& element : header.elements) {
    const std::size_t least =
        std::max<std::size_t>(1, element.least_bytes(header.form == PlyHeader::Form::text));
    plausible_count(element.count, least, bytes_left, place, "elements '" + shown(element.name) + "'");
    for (const PlyElement& other : header.elements) {
      if (&other != &element && other.name == element.name) {
        throw refused(place, "element '" + shown(element.name) + "' is announced twice");
      }
    }
  }
}

}  // namespace

std::size_t ply_size(PlyType type) {
  static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return static_cast<int>(i);
  }
  return -1;
}

std::size_t PlyElement::least_bytes(bool text) const {
  if (text) return 2 * properties.size();  // a digit and a blank
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) {
    bytes += ply_size(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

PlyHeader read_ply_header(std::string_view bytes) {
  PlyHeader header;
  TextCursor cursor(bytes);
  if (cursor.word_in_line() != "ply" || !TextCursor(cursor.rest_of_line()).word().empty()) {
    throw refused("line 1", "is no PLY: its first line is not 'ply'");
  }
  bool has_format = false;
  while (!cursor.at_end()) {
    const std::string place = cursor.place();
    TextCursor line(cursor.rest_of_line());
    const std::string_view keyword = line.word_in_line();
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
    if (keyword == "format") {
      header.form = form_of(line, place);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(element_of(line, place));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(line, place));
    } else if (keyword != "end_header") {
      throw refused(place, "'" + shown(keyword) + "' does not belong in the header of a PLY");
    }
    if (!line.word_in_line().empty()) throw refused(place, "more words than a line of a PLY header has");
    if (keyword != "end_header") continue;
    if (!has_format) throw refused(place, "the header names no format");
    header.body = cursor.offset();
    header.body_line = cursor.line();
    // A text's last line needs no end: one more byte than is there.
    check_counts(header, bytes.size() - header.body + 1, place);
    return header;
  }
  throw refused(cursor.place(), "truncated: the file ends within its header");
}

}  // namespace fingerpad
