#include "closed_mesh.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

namespace fingerpad::parts {
namespace {

constexpr size_t header_bytes = 80;
using Vector = std::array<double, 3>;

Vector between(const std::array<float, 3>& from, const std::array<float, 3>& to) {
  return {double(to[0]) - from[0], double(to[1]) - from[1], double(to[2]) - from[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the area along the outward normal.
Vector area_vector(const ClosedMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& a = mesh.vertices[triangle[0]];
  return cross(between(a, mesh.vertices[triangle[1]]), between(a, mesh.vertices[triangle[2]]));
}

}  // namespace

std::string fault_of(const ClosedMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& triangle : mesh.triangles) {
    const Vector area = area_vector(mesh, triangle);
    if (std::hypot(area[0], area[1], area[2]) == 0) return "a triangle without area";
    for (int k = 0; k < 3; ++k) ++uses[{triangle[k], triangle[(k + 1) % 3]}];
  }
  size_t bad = 0;
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end() || back->second != 1) ++bad;
  }
  if (bad > 0) return std::to_string(bad) + " edges are not used once each way";
  return volume_mm3(mesh) > 0 ? "" : "the volume is not positive";
}

double volume_mm3(const ClosedMesh& mesh) {
  double six_volumes = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector area = area_vector(mesh, triangle);
    const auto& a = mesh.vertices[triangle[0]];
    six_volumes += area[0] * a[0] + area[1] * a[1] + area[2] * a[2];
  }
  return six_volumes / 6;
}

void write_stl(const ClosedMesh& mesh, const std::string& part_name, const std::string& path) {
  std::array<char, header_bytes> header{};
  const std::string title = part_name + ", mm; (c) the fingerpad authors, BSD-3-Clause";
  std::memcpy(header.data(), title.data(), std::min(title.size(), header_bytes));
  std::ofstream file(path, std::ios::binary);
  file.write(header.data(), header_bytes);
  const auto count = std::uint32_t(mesh.triangles.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle : mesh.triangles) {
    const Vector area = area_vector(mesh, triangle);
    const double length = std::hypot(area[0], area[1], area[2]);
    std::array<char, 50> record{};
    std::array<float, 12> numbers{};
    for (int k = 0; k < 3; ++k) {
      numbers[k] = float(area[k] / length);
      std::memcpy(&numbers[3 + 3 * k], mesh.vertices[triangle[k]].data(), 3 * sizeof(float));
    }
    std::memcpy(record.data(), numbers.data(), sizeof numbers);
    file.write(record.data(), record.size());
  }
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

void write_ply(const ClosedMesh& mesh, const std::string& comment, const std::string& path) {
  if (mesh.vertices.size() > 0x10000) throw std::runtime_error(path + ": too many vertices for 16 bits");
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\ncomment " << comment << "\nelement vertex "
       << mesh.vertices.size() << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
       << mesh.triangles.size() << "\nproperty list uchar ushort vertex_indices\nend_header\n";
  for (const auto& vertex : mesh.vertices)
    file.write(reinterpret_cast<const char*>(vertex.data()), sizeof vertex);
  for (const auto& triangle : mesh.triangles) {
    std::array<char, 7> record{3};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = std::uint16_t(triangle[k]);
      std::memcpy(record.data() + 1 + 2 * k, &index, sizeof index);
    }
    file.write(record.data(), record.size());
  }
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

ClosedMesh read_stl(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(header_bytes);
  std::uint32_t count = 0;
  file.read(reinterpret_cast<char*>(&count), sizeof count);
  ClosedMesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> known;
  for (std::uint32_t i = 0; i < count && file; ++i) {
    std::array<char, 50> record{};
    file.read(record.data(), record.size());
    std::array<std::uint32_t, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      std::array<float, 3> vertex{};
      std::memcpy(vertex.data(), record.data() + 12 * std::size_t(k + 1), sizeof vertex);
      const auto [entry, is_new] = known.try_emplace(vertex, std::uint32_t(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(vertex);
      triangle[k] = entry->second;
    }
    mesh.triangles.push_back(triangle);
  }
  if (!file || mesh.triangles.empty()) throw std::runtime_error(path + ": cannot be read as binary STL");
  return mesh;
}

}  // namespace fingerpad::parts
