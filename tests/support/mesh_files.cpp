#include "support/mesh_files.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <fstream>

namespace fingerpad::test {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string point_lines(const TriangleSoup& soup, const std::string& before) {
  std::string text;
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i) {
    const Vec3 p = soup.vertices_P.col(i);
    text += fmt::format("{}{:.17g} {:.17g} {:.17g}\n", before, p.x(), p.y(), p.z());
  }
  return text;
}

std::string face_lines(const TriangleSoup& soup, const std::string& before, int first) {
  std::string text;
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    const Eigen::Vector3i f = soup.triangles.col(t).array() + first;
    text += fmt::format("{}{} {} {}\n", before, f.x(), f.y(), f.z());
  }
  return text;
}

}  // namespace

std::filesystem::path write_file(const std::filesystem::path& folder, const std::string& name,
                                 const std::string& bytes) {
  const std::filesystem::path path = folder / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

double as_float32(double coordinate) {
  const volatile float rounded = static_cast<float>(coordinate);  // GCC 12 folds a plain round trip away
  return rounded;
}

std::string binary_stl(const TriangleSoup& soup) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(soup.triangles.cols()));
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0f);
    for (int k = 0; k < 3; ++k) {
      for (const double x : soup.vertices_P.col(soup.triangles(k, t))) append(bytes, static_cast<float>(x));
    }
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

std::string text_stl(const TriangleSoup& soup) {
  std::string text = "solid part\n";
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = soup.vertices_P.col(soup.triangles(k, t));
      text += fmt::format("   vertex {:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid part\n";
}

std::string obj_text(const TriangleSoup& soup) {
  return point_lines(soup, "v ") + face_lines(soup, "f ", 1);
}

std::string off_text(const TriangleSoup& soup) {
  return fmt::format("OFF\n{} {} 0\n", soup.vertices_P.cols(), soup.triangles.cols()) +
         point_lines(soup, "") + face_lines(soup, "3 ", 0);
}

std::string ply_text(const TriangleSoup& soup) {
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty "
             "double z\n"
             "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
             soup.vertices_P.cols(), soup.triangles.cols()) +
         point_lines(soup, "") + face_lines(soup, "3 ", 0);
}

std::string binary_ply(const TriangleSoup& soup) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double "
      "y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      soup.vertices_P.cols(), soup.triangles.cols());
  for (const double x : soup.vertices_P.reshaped()) append(bytes, x);
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    append(bytes, std::uint8_t(3));
    for (const int corner : soup.triangles.col(t)) append(bytes, std::int32_t(corner));
  }
  return bytes;
}

}  // namespace fingerpad::test
