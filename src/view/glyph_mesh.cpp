#include "view/glyph_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tangent_frame.hpp"

namespace fingerpad {
namespace {

constexpr int sides = 20;

Vec3 around(const Mat3& frame, int side) {
  const double angle = 2 * std::numbers::pi * side / sides;
  return frame.col(0) * std::cos(angle) + frame.col(1) * std::sin(angle);
}

Mat3 frame_along(const Vec3& axis) {
  const Vec3 across = std::abs(axis.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
  return tangent_frame(axis, across);
}

}  // namespace

int GlyphMesh::add(const Vec3& point, const Vec3& normal, const Colour& colour) {
  points.push_back(point);
  normals.push_back(normal);
  colours.push_back(
      {colour.red, colour.green, colour.blue, static_cast<std::uint8_t>(std::lround(255 * colour.opacity))});
  return static_cast<int>(points.size()) - 1;
}

void GlyphMesh::bar(const Vec3& from, const Vec3& to, double from_radius, double to_radius,
                    const Colour& colour) {
  const double length = (to - from).norm();
  if (!(length > 0)) return;
  const Vec3 axis = (to - from) / length;
  const Mat3 frame = frame_along(axis);
  const int first = static_cast<int>(points.size());
  for (int i = 0; i <= sides; ++i) {
    const Vec3 out = around(frame, i);
    const Vec3 normal = (out * length + axis * (from_radius - to_radius)).normalized();
    add(from + out * from_radius, normal, colour);
    add(to + out * to_radius, normal, colour);
    if (i == 0) continue;
    const int a = first + 2 * (i - 1);
    triangles.push_back({a, a + 2, a + 1});
    triangles.push_back({a + 1, a + 2, a + 3});
  }
  for (const bool far : {false, true}) {
    const double radius = far ? to_radius : from_radius;
    if (!(radius > 0)) continue;
    std::vector<Vec3> rim;
    rim.reserve(static_cast<std::size_t>(sides));
    // Outward is where the rim goes round to the left.
    for (int i = 0; i < sides; ++i)
      rim.push_back((far ? to : from) + around(frame, far ? i : sides - i) * radius);
    fan(far ? to : from, rim, far ? axis : Vec3(-axis), colour);
  }
}

void GlyphMesh::arrow(const Vec3& from, const Vec3& to, double shaft_radius, const Colour& colour) {
  const double length = (to - from).norm();
  if (!(length > 1e-9)) return;
  const double head = std::min(length, 5 * shaft_radius);
  const double radius = 2.1 * shaft_radius * head / (5 * shaft_radius);
  const Vec3 neck = to - (to - from) * (head / length);
  if (length > head) bar(from, neck, shaft_radius, shaft_radius, colour);
  bar(neck, to, radius, 0, colour);
}

void GlyphMesh::ball(const Vec3& centre, double radius, const Colour& colour) {
  constexpr int rings = 12;
  const int first = static_cast<int>(points.size());
  for (int ring = 0; ring <= rings; ++ring) {
    const double height = std::numbers::pi * ring / rings;
    for (int i = 0; i <= sides; ++i) {
      const Vec3 out = around(Mat3::Identity(), i) * std::sin(height) + Vec3::UnitZ() * std::cos(height);
      add(centre + radius * out, out, colour);
      if (ring == 0 || i == 0) continue;
      const int below = first + ring * (sides + 1) + i;
      const int above = below - (sides + 1);
      triangles.push_back({above - 1, below - 1, above});
      triangles.push_back({above, below - 1, below});
    }
  }
}

void GlyphMesh::tube(const std::vector<Vec3>& line, bool closed, double radius, const Colour& colour) {
  for (std::size_t i = 1; i < line.size(); ++i) bar(line[i - 1], line[i], radius, radius, colour);
  if (closed && line.size() > 2) bar(line.back(), line.front(), radius, radius, colour);
}

void GlyphMesh::fan(const Vec3& centre, const std::vector<Vec3>& rim, const Vec3& normal,
                    const Colour& colour) {
  const int middle = add(centre, normal, colour);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const int here = add(rim[i], normal, colour);
    const int next = i + 1 < rim.size() ? here + 1 : middle + 1;
    triangles.push_back({middle, here, next});
  }
}

void GlyphMesh::band(const std::vector<Vec3>& inner, const std::vector<Vec3>& outer, const Vec3& normal,
                     const Colour& colour) {
  const int first = static_cast<int>(points.size());
  const int count = static_cast<int>(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) {
    add(inner[i], normal, colour);
    add(outer[i], normal, colour);
  }
  for (int i = 0; i < count; ++i) {
    const int here = first + 2 * i, next = first + 2 * ((i + 1) % count);
    triangles.push_back({here, here + 1, next});
    triangles.push_back({next, here + 1, next + 1});
  }
}

}  // namespace fingerpad
