#pragma once

#include <array>
#include <vector>

#include "base/types.hpp"
#include "view/colours.hpp"

namespace fingerpad {

/// Small coloured solids as one triangle mesh, in the draw space [mm].
class GlyphMesh {
 public:
  /// An arrow with a round shaft; its head is five shaft radii long, or all of a short arrow.
  void arrow(const Vec3& from, const Vec3& to, double shaft_radius, const Colour& colour);
  void ball(const Vec3& centre, double radius, const Colour& colour);
  /// A round bar between two points, of a radius at each end; closed at both.
  void bar(const Vec3& from, const Vec3& to, double from_radius, double to_radius, const Colour& colour);
  /// A bar along a line of points, round at the corners.
  void tube(const std::vector<Vec3>& points, bool closed, double radius, const Colour& colour);
  /// A fan of triangles about `centre` over a closed rim.
  void fan(const Vec3& centre, const std::vector<Vec3>& rim, const Vec3& normal, const Colour& colour);

  /// The band between two closed rings of as many points.
  void band(const std::vector<Vec3>& inner, const std::vector<Vec3>& outer, const Vec3& normal,
            const Colour& colour);

  std::vector<Vec3> points;
  std::vector<Vec3> normals;                         ///< one a point, unit
  std::vector<std::array<std::uint8_t, 4>> colours;  ///< one a point, RGBA
  std::vector<std::array<int, 3>> triangles;

 private:
  int add(const Vec3& point, const Vec3& normal, const Colour& colour);
};

}  // namespace fingerpad
