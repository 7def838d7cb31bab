#include <array>

#include "base/error.hpp"
#include "part/mesh_format.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

/// Nine numbers a triangle, and nothing else.
RawMesh scan_tri(std::string& bytes) {
  RawMesh mesh;
  mesh.format = "TRI";
  TextCursor cursor(bytes);
  std::vector<double> numbers;
  for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
    const auto number = coordinate_of(word);
    if (!number) throw refused(cursor.place(), not_a_number(word));
    numbers.push_back(*number);
    if (numbers.size() < 3) continue;
    mesh.corners.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.add_vertex({numbers[0], numbers[1], numbers[2]}, static_cast<std::size_t>(cursor.line()));
    if (mesh.vertices.size() % 3 == 0) mesh.end_polygon();
    numbers.clear();
  }
  return mesh;
}

}  // namespace

MeshFormat tri_format() noexcept {
  static constexpr std::string_view endings[] = {".tri"};
  return {"TRI",    endings, [](std::string_view) { return false; }, [](std::string_view) { return false; },
          scan_tri, nullptr};
}

}  // namespace fingerpad
