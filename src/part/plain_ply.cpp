#include "part/plain_ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

namespace fingerpad {
namespace {

bool is_fraction(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

bool is_axis(const PlyProperty& property) {
  return property.name == "x" || property.name == "y" || property.name == "z";
}

/// Whether OpenMesh can be trusted with this: vertices, then faces, and of the faces nothing but the list.
/// (It drops properties before the list, and coordinates that are whole numbers, and reads their bytes as
/// counts: a few hundred bytes kept it busy for minutes.)
bool is_plain(const PlyHeader& header) {
  if (header.elements.size() != 2 || header.elements[0].name != "vertex" ||
      header.elements[1].name != "face") {
    return false;
  }
  for (const PlyProperty& property : header.elements[0].properties) {
    if (property.is_list || (is_axis(property) && !is_fraction(property.type))) return false;
  }
  const auto& of_face = header.elements[1].properties;
  return of_face.size() == 1 && of_face[0].is_list &&
         (of_face[0].count_type == PlyType::uint8 || of_face[0].count_type == PlyType::int32) &&
         (of_face[0].type == PlyType::int32 || of_face[0].type == PlyType::uint32);
}

std::string_view type_name(PlyType type) {
  static constexpr std::array<std::string_view, 8> names{"char", "uchar", "short", "ushort",
                                                         "int",  "uint",  "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

/// The header of a plain file without comments (their words mislead OpenMesh) and with names of no meaning
/// for what is not needed (of which it would read normals and colours as numbers).
std::string plain_header(const PlyHeader& header) {
  static constexpr std::array<std::string_view, 3> forms{"ascii", "binary_little_endian",
                                                         "binary_big_endian"};
  std::string text = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n",
                                 forms[static_cast<std::size_t>(header.form)], header.elements[0].count);
  for (const PlyProperty& property : header.elements[0].properties) {
    text += fmt::format("property {} {}\n", type_name(property.type),
                        is_axis(property) ? property.name : "passed_over");
  }
  const PlyProperty& list = header.elements[1].properties[0];
  text += fmt::format("element face {}\nproperty list {} {} vertex_indices\nend_header\n",
                      header.elements[1].count, type_name(list.count_type), type_name(list.type));
  return text;
}

bool has_missing(const RawMesh& mesh) {
  return std::find(mesh.corners.begin(), mesh.corners.end(), -1) != mesh.corners.end();
}

template <typename T>
void append_bytes(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

/// The mesh as the simplest binary PLY.
std::string bare_ply(const RawMesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty "
      "double z\n"
      "element face {}\nproperty list int int vertex_indices\nend_header\n",
      std::endian::native == std::endian::little ? "little" : "big", mesh.vertices.size(),
      mesh.polygon_count());
  for (const Vec3& vertex : mesh.vertices) {
    for (const double x : vertex) append_bytes(bytes, x);
  }
  for (int i = 0; i < mesh.polygon_count(); ++i) {
    append_bytes(bytes, mesh.corner_count(i));
    for (int c = mesh.first_corner(i); c < mesh.ends[static_cast<std::size_t>(i)]; ++c) {
      append_bytes(bytes, mesh.corners[static_cast<std::size_t>(c)]);
    }
  }
  return bytes;
}

}  // namespace

void write_plainly(std::string& bytes, const PlyHeader& header, RawMesh& mesh) {
  if (is_plain(header) && (mesh.binary || (mesh.nonfinite.empty() && !has_missing(mesh)))) {
    bytes.replace(0, header.body, plain_header(header));
  } else {
    bytes = bare_ply(mesh);
    mesh.binary = true;
  }
}

}  // namespace fingerpad
