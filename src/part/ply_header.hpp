#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;

  /// The place of a property, or -1.
  int find(std::string_view property) const;
  /// The bytes that one such element takes at least.
  std::size_t least_bytes(bool text) const;
};

struct PlyHeader {
  enum class Form { text, little_endian, big_endian } form = Form::text;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  ///< the first byte after the header
  long body_line = 1;    ///< and its line
};

/// Reads a PLY header (Turk 1994) strictly: every line must be understood, every count possible in the bytes
/// that follow. Throws Error (refused) at a line.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace fingerpad
