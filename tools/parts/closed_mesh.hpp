#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fingerpad::parts {

/// Triangles over welded float32 vertices, as the STL files hold them [mm].
struct ClosedMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What is wrong with a mesh that should be closed; "" where every edge is used once each way, no triangle
/// has no area and the volume is positive.
std::string fault_of(const ClosedMesh& mesh);

double volume_mm3(const ClosedMesh& mesh);

/// Binary STL: the header names the part and its licence and does not start with "solid". Same mesh, same
/// bytes.
void write_stl(const ClosedMesh& mesh, const std::string& part_name, const std::string& path);

/// Binary PLY, float vertices and 16-bit indices: a quarter of an STL's bytes. Same mesh, same bytes. Throws
/// std::runtime_error, also for more than 65536 vertices.
void write_ply(const ClosedMesh& mesh, const std::string& comment, const std::string& path);

/// Reads what write_stl wrote and welds equal vertices. Throws std::runtime_error.
ClosedMesh read_stl(const std::string& path);

}  // namespace fingerpad::parts
