#include <fmt/format.h>

#include <Eigen/Geometry>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "base/error.hpp"
#include "part/mesh_format.hpp"
#include "part/openmesh_reader.hpp"
#include "part/raw_mesh.hpp"
#include "part/sniff.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t facet_bytes = 50;

/// How the stored normals stand to the winding.
struct StoredNormals {
  long zero = 0, opposed = 0, all = 0;

  void look(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
    ++all;
    if (normal.isZero(0)) {
      ++zero;
    } else if (normal.allFinite() && normal.dot((b - a).cross(c - a)) < 0) {
      ++opposed;
    }
  }

  void tell(RawMesh& mesh) const {
    if (opposed > 0) {
      mesh.warnings.push_back(fmt::format(
          "{} of {} stored normals contradict the winding: the winding is trusted", opposed, all));
    }
    if (all > 0 && zero == all) {
      mesh.warnings.emplace_back("all stored normals are zero: normals are made from the winding");
    }
  }
};

Vec3 floats_at(const std::string& bytes, std::size_t at) {
  std::array<float, 3> xyz{};
  static_assert(std::endian::native == std::endian::little,
                "STL is little-endian and is read without swapping");
  std::memcpy(xyz.data(), bytes.data() + at, sizeof(xyz));
  return {xyz[0], xyz[1], xyz[2]};
}

RawMesh scan_binary(const std::string& bytes) {
  RawMesh mesh;
  mesh.format = "binary STL";
  mesh.binary = mesh.float32 = true;
  mesh.place_unit = "byte";
  const std::size_t announced = stl_announced_count(bytes), present = (bytes.size() - 84) / facet_bytes;
  if (announced > present) {
    throw refused(
        "byte 80",
        fmt::format("the header announces {} triangles, but the file ends after {}: truncated, or the "
                    "count is wrong",
                    announced, present));
  }
  const std::size_t over = bytes.size() - 84 - facet_bytes * announced;
  if (over >= facet_bytes) {
    throw refused(
        "byte 80",
        fmt::format("the header's count is too small: it announces {} triangles, but bytes for {} follow; "
                    "which of them belong to the part is not known",
                    announced, present));
  }
  if (over > 0)
    mesh.warnings.push_back(fmt::format("{} bytes after the last triangle are passed over", over));
  StoredNormals normals;
  mesh.vertices.reserve(3 * announced);
  for (std::size_t i = 0; i < announced; ++i) {
    const std::size_t at = 84 + facet_bytes * i;
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = floats_at(bytes, at + 12 * (k + 1));
      mesh.corners.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.add_vertex(corner[k], at + 12 * (k + 1));
    }
    normals.look(floats_at(bytes, at), corner[0], corner[1], corner[2]);
    mesh.end_polygon();
  }
  normals.tell(mesh);
  return mesh;
}

/// Reads the text form; `bytes` loses the solids' names.
class StlText {
 public:
  explicit StlText(std::string& bytes) : bytes_(bytes), cursor_(bytes) {}

  RawMesh scan() {
    mesh_.format = "text STL";
    bool in_solid = false;
    for (std::string_view word = cursor_.word(); !word.empty(); word = cursor_.word()) {
      if (same_word(word, "solid") || same_word(word, "endsolid")) {
        in_solid = same_word(word, "solid");
        blank_name();
      } else if (same_word(word, "facet")) {
        facet();
      } else if (!same_word(word, "color")) {
        throw refused(cursor_.place(), "'" + shown(word) + "' where 'facet' or 'endsolid' should stand");
      } else {
        colour();
      }
    }
    if (in_solid) {
      mesh_.warnings.push_back(cursor_.place() + ": ends without 'endsolid'; it may have been cut short");
    }
    normals_.tell(mesh_);
    return std::move(mesh_);
  }

 private:
  /// A name goes to the end of its line. A facet within it would be lost with it.
  void blank_name() {
    const std::size_t from = cursor_.offset();
    const std::string place = cursor_.place();
    const std::string_view name = cursor_.rest_of_line();
    TextCursor words(name);
    for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
      if (!same_word(word, "endfacet")) continue;
      throw refused(place, "a facet on the line of the solid's name: begin a new line behind the name");
    }
    std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(from), name.size(), ' ');
  }

  void colour() {
    for (std::string_view word = cursor_.word_in_line(); !word.empty(); word = cursor_.word_in_line()) {
      if (!coordinate_of(word)) throw refused(cursor_.place(), not_a_number(word) + " in a colour");
    }
  }

  void expect(std::string_view wanted) {
    const std::string_view word = cursor_.word();
    if (same_word(word, wanted)) return;
    // At the end of the file stands nothing, or the beginning of the word.
    if (cursor_.at_end() && same_word(word, wanted.substr(0, word.size()))) throw truncated();
    throw refused(cursor_.place(), fmt::format("'{}' where '{}' should stand", shown(word), wanted));
  }

  Error truncated() const {
    return refused(cursor_.place(),
                   fmt::format("truncated: the file ends within triangle {}", mesh_.polygon_count()));
  }

  Vec3 three_numbers() {
    Vec3 numbers;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = cursor_.word();
      if (word.empty()) throw truncated();
      const auto number = coordinate_of(word);
      if (!number) throw refused(cursor_.place(), not_a_number(word));
      numbers[i] = *number;
    }
    return numbers;
  }

  void facet() {
    expect("normal");
    const Vec3 normal = three_numbers();
    expect("outer");
    expect("loop");
    std::array<Vec3, 3> corner;
    for (Vec3& vertex : corner) {
      expect("vertex");
      const auto line = static_cast<std::size_t>(cursor_.line());
      vertex = three_numbers();
      mesh_.corners.push_back(static_cast<int>(mesh_.vertices.size()));
      mesh_.add_vertex(vertex, line);
    }
    expect("endloop");
    expect("endfacet");
    mesh_.end_polygon();
    normals_.look(normal, corner[0], corner[1], corner[2]);
  }

  std::string& bytes_;
  TextCursor cursor_;
  RawMesh mesh_;
  StoredNormals normals_;
};

RawMesh scan_stl(std::string& bytes) {
  if (is_binary_stl_size(bytes)) return scan_binary(bytes);
  const bool binary = bytes.find('\0') != std::string::npos;
  if (!binary && same_word(TextCursor(bytes).word(), "solid")) return StlText(bytes).scan();
  if (bytes.size() < 84 || !binary) {
    throw refused(
        "byte 0",
        "is no STL: a text one begins with 'solid', a binary one has 84 bytes and 50 for each triangle");
  }
  return scan_binary(bytes);
}

bool is_stl(std::string_view bytes) {
  return is_binary_stl_size(bytes) ||
         (bytes.starts_with("solid ") && bytes.substr(0, 1000).find("facet") != std::string_view::npos);
}

}  // namespace

MeshFormat stl_format() noexcept {
  static constexpr std::string_view endings[] = {".stl"};
  return {"STL",
          endings,
          is_stl,
          [](std::string_view word) { return same_word(word, "solid"); },
          scan_stl,
          [](const std::string& bytes, const RawMesh& mesh, const LoadProgress& progress) {
            return read_by_openmesh(OpenMesh::IO::STLReader(), bytes, mesh, progress);
          }};
}

}  // namespace fingerpad
