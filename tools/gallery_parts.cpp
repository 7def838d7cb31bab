// Makes scenes/gallery/parts: the small meshes of the gallery of failure, in millimetres. Needs nothing but a
// compiler:
//   c++ -std=c++20 tools/gallery_parts.cpp -o build/gallery_parts && build/gallery_parts scenes/gallery/parts
// The same meshes at every run. Coordinates are whole 1/1024 mm, so that float32 holds those at 10,000 mm
// too.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

struct Mesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;

  int add(double x, double y, double z) {
    const auto exact = [](double v) { return std::round(v * 1024) / 1024; };
    vertices.push_back({exact(x), exact(y), exact(z)});
    return static_cast<int>(vertices.size()) - 1;
  }
  void add_quad(int a, int b, int c, int d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  Mesh moved(double x, double y, double z) const {
    Mesh mesh = *this;
    for (auto& v : mesh.vertices) v = {v[0] + x, v[1] + y, v[2] + z};
    return mesh;
  }
};

void write(const Mesh& mesh, const std::string& path) {
  std::ofstream file(path);
  file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  file.precision(12);
  for (const auto& v : mesh.vertices) file << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
  for (const auto& t : mesh.triangles) file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

/// A slab with its top in z = 0, cut into a grid with a vertex at each pair of xs and ys; inner vertices move
/// by up to `jitter_mm`, diagonals go either way. Of a grid of 2 x 2 lines it is a box.
Mesh slab(const std::vector<double>& xs, const std::vector<double>& ys, double thickness_mm,
          double jitter_mm) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const int nx = static_cast<int>(xs.size()), ny = static_cast<int>(ys.size());
  Mesh mesh;
  for (const double depth_mm : {0.0, thickness_mm}) {
    for (int i = 0; i < nx; ++i) {
      for (int j = 0; j < ny; ++j) {
        const bool inner = depth_mm == 0 && i > 0 && j > 0 && i + 1 < nx && j + 1 < ny;
        const double dx = jitter_mm * (2 * uniform() - 1), dy = jitter_mm * (2 * uniform() - 1);
        mesh.add(xs[i] + (inner ? dx : 0), ys[j] + (inner ? dy : 0), -depth_mm);
      }
    }
  }
  const auto top = [&](int i, int j) { return i * ny + j; };
  const auto bottom = [&](int i, int j) { return nx * ny + i * ny + j; };
  for (int i = 0; i + 1 < nx; ++i) {
    for (int j = 0; j + 1 < ny; ++j) {
      const std::array<int, 4> at{top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1)};
      const int turn = uniform() < 0.5 ? 0 : 1;
      mesh.add_quad(at[turn], at[1 + turn], at[2 + turn], at[(3 + turn) % 4]);
      mesh.add_quad(bottom(i, j), bottom(i, j + 1), bottom(i + 1, j + 1), bottom(i + 1, j));
    }
    mesh.add_quad(bottom(i, 0), bottom(i + 1, 0), top(i + 1, 0), top(i, 0));
    mesh.add_quad(top(i, ny - 1), top(i + 1, ny - 1), bottom(i + 1, ny - 1), bottom(i, ny - 1));
  }
  for (int j = 0; j + 1 < ny; ++j) {
    mesh.add_quad(top(0, j), top(0, j + 1), bottom(0, j + 1), bottom(0, j));
    mesh.add_quad(bottom(nx - 1, j), bottom(nx - 1, j + 1), top(nx - 1, j + 1), top(nx - 1, j));
  }
  return mesh;
}

/// A prism along y over a profile in (x, z), counterclockwise seen from -y, that its first corner sees whole.
Mesh prism(const std::vector<std::array<double, 2>>& profile, double half_length_mm) {
  Mesh mesh;
  const int n = static_cast<int>(profile.size());
  for (const double y : {-half_length_mm, half_length_mm}) {
    for (const auto& [x, z] : profile) mesh.add(x, y, z);
  }
  for (int i = 0; i < n; ++i) mesh.add_quad(i, n + i, n + (i + 1) % n, (i + 1) % n);
  for (int i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({n, n + i + 1, n + i});
  }
  return mesh;
}

Mesh cone(double radius_mm, double height_mm, int around) {
  Mesh mesh;
  const int tip = mesh.add(0, 0, 0), base = mesh.add(0, 0, -height_mm);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    mesh.add(radius_mm * std::cos(angle), radius_mm * std::sin(angle), -height_mm);
  }
  for (int i = 0; i < around; ++i) {
    const int a = 2 + i, b = 2 + (i + 1) % around;
    mesh.triangles.push_back({tip, a, b});
    mesh.triangles.push_back({base, b, a});
  }
  return mesh;
}

Mesh torus(double ring_mm, double tube_mm, int around, int across) {
  Mesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = ring_mm + tube_mm * std::cos(v);
      mesh.add(r * std::cos(u), r * std::sin(u), tube_mm * std::sin(v));
      const int next_i = (i + 1) % around * across, next_j = (j + 1) % across;
      mesh.add_quad(i * across + j, next_i + j, next_i + next_j, i * across + next_j);
    }
  }
  return mesh;
}

std::vector<double> even(double from, double to, int cells) {
  std::vector<double> lines;
  for (int i = 0; i <= cells; ++i) lines.push_back(from + (to - from) * i / cells);
  return lines;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: gallery_parts FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(words[1]) + "/";
  write(slab({-20, 20}, {-20, 20}, 20, 0), folder + "block.off");
  write(slab({-30, 30}, {-20, 20}, 1, 0), folder + "plate_1mm.off");
  write(slab({-30, 30}, {-20, 20}, 0.2, 0), folder + "plate_0.2mm.off");
  write(prism({{0, 0}, {-2.625, -30}, {2.625, -30}}, 20), folder + "blade.off");  // 10 degrees
  write(prism({{0, 0}, {0, 30}, {-10, 30}, {-10, -10}, {30, -10}, {30, 0}}, 20), folder + "corner.off");
  write(cone(8, 30, 32), folder + "cone.off");  // 30 degrees
  write(slab(even(-20, 20, 10), even(-20, 20, 10), 20, 1.5), folder + "patched.off");
  std::vector<double> crowded = even(-0.0625, 0.0625, 32);  // 1/256 mm apart, 40 mm long
  crowded.insert(crowded.begin(), -20);
  crowded.push_back(20);
  write(slab(crowded, {-20, 20}, 20, 0), folder + "slivers.off");
  const Mesh ring = torus(30, 10, 32, 16);
  write(ring, folder + "torus.off");
  write(ring.moved(10000, -10000, 10000), folder + "torus_far.off");
}
