#include "study/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "study/shape_meshes.hpp"

namespace fingerpad {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

constexpr double sphere_m = 0.05;

ExactSurface sphere() {
  ExactSurface surface{"sphere", "radius 50 mm", {3, 4, 5, 6, 7}, {}, {}, {}, {}};
  surface.mesh = [](int level) { return ball_mesh(sphere_m, level); };
  surface.facet_m = [](int level) { return sphere_m * whole_turn / 4 / std::exp2(level); };
  surface.foot = [](const Vec3& p) { return ExactFoot{p.norm() - sphere_m, p.normalized()}; };
  surface.way = [](double along) {
    const double around = 0.3 + 4.1 * along, up = 0.45 * std::sin(1.3 + 5 * along);
    return Vec3(sphere_m *
                Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)));
  };
  surface.deepest_m = 0.8 * sphere_m;
  return surface;
}

/// The torus's ring and tube [m].
constexpr double ring_m = 0.05, tube_m = 0.02;

ExactSurface torus() {
  ExactSurface surface{"torus", "50 mm to the middle of a tube of 20 mm", {16, 32, 64, 128, 256}, {}, {}, {},
                       {}};
  surface.mesh = [](int across) { return torus_mesh(ring_m, tube_m, 2 * across, across); };
  surface.facet_m = [](int across) { return tube_m * whole_turn / across; };
  surface.foot = [](const Vec3& p) {
    const Vec3 middle = ring_m * Vec3(p.x(), p.y(), 0).normalized();
    return ExactFoot{(p - middle).norm() - tube_m, (p - middle).normalized()};
  };
  surface.way = [](double along) {
    const double u = 0.21 + 1.7 * along, v = 0.4 + 6.9 * along, r = ring_m + tube_m * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), tube_m * std::sin(v));
  };
  surface.deepest_m = 0.8 * tube_m;
  return surface;
}

/// The round part's sizes: radius, half height, fillet [m].
constexpr double round_m = 0.02, half_height_m = 0.015, fillet_m = 0.005;

/// Both fillets in `steps` facets, the flats between them in one each, as a CAD tessellation has them.
TriangleSoup round_part_mesh(int steps) {
  const int around = 8 * steps;
  std::vector<Vec2> profile;  // radius and height, from the top's rim to the bottom's
  for (int i = 0; i <= steps; ++i) {
    const double angle = whole_turn / 4 * i / steps;
    profile.emplace_back(round_m - fillet_m * (1 - std::sin(angle)),
                         half_height_m - fillet_m * (1 - std::cos(angle)));
  }
  for (int i = steps; i >= 0; --i) {
    const Vec2 above = profile[static_cast<std::size_t>(i)];
    profile.emplace_back(above.x(), -above.y());
  }
  return revolved_mesh(profile, around, half_height_m, -half_height_m);
}

ExactFoot round_part_foot(const Vec3& p) {
  const double from_axis_m = std::hypot(p.x(), p.y());
  const Vec3 outward = Vec3(p.x(), p.y(), 0) / from_axis_m, up(0, 0, p.z() < 0 ? -1 : 1);
  const Vec2 corner(from_axis_m - (round_m - fillet_m), std::abs(p.z()) - (half_height_m - fillet_m));
  if (corner.x() > 0 && corner.y() > 0) {
    const double length_m = corner.norm();
    return {length_m - fillet_m, (corner.x() * outward + corner.y() * up) / length_m};
  }
  return corner.x() > corner.y() ? ExactFoot{corner.x() - fillet_m, outward}
                                 : ExactFoot{corner.y() - fillet_m, up};
}

/// The profile at a length along it, from 7 mm off the axis over the top, the fillet and down the wall.
Vec2 round_part_profile(double length_m) {
  constexpr double flat_m = round_m - fillet_m - 0.007, arc_m = fillet_m * whole_turn / 4;
  if (length_m < flat_m) return {0.007 + length_m, half_height_m};
  if (length_m > flat_m + arc_m) return {round_m, half_height_m - fillet_m - (length_m - flat_m - arc_m)};
  const double angle = (length_m - flat_m) / fillet_m;
  return {round_m - fillet_m * (1 - std::sin(angle)), half_height_m - fillet_m * (1 - std::cos(angle))};
}

ExactSurface round_part() {
  ExactSurface surface{
      "fillet", "a cylinder of radius 20 mm, rims rounded by 5 mm", {4, 8, 16, 32, 64}, {}, {}, {}, {}};
  surface.mesh = round_part_mesh;
  surface.facet_m = [](int steps) { return fillet_m * whole_turn / 4 / steps; };
  surface.foot = round_part_foot;
  surface.way = [](double along) {
    const Vec2 at = round_part_profile(0.0125 - 0.012 * std::cos(7.1 * std::numbers::pi * along));
    const double around = 0.13 + 4.9 * along;
    return Vec3(at.x() * std::cos(around), at.x() * std::sin(around), at.y());
  };
  surface.deepest_m = 0.8 * fillet_m;
  return surface;
}

constexpr double hollow_m = 0.0085;

ExactSurface hollow() {
  ExactSurface surface{"hollow", "of radius 8.5 mm", {3, 5, 6}, {}, {}, {}, {}};
  surface.mesh = [](int level) {
    TriangleSoup box = plate_mesh(0.04);
    box.vertices_P.row(2).array() += 0.02;
    return hollowed(box, ball_mesh(hollow_m, level));
  };
  surface.facet_m = [](int level) { return hollow_m * whole_turn / 4 / std::exp2(level); };
  surface.foot = [](const Vec3& p) { return ExactFoot{hollow_m - p.norm(), -p.normalized()}; };
  surface.way = [on_sphere = sphere().way](double along) {
    return Vec3(hollow_m / sphere_m * on_sphere(along));
  };
  surface.deepest_m = 0.015;                   // to where the box is nearer
  surface.highest_m = (hollow_m + 0.007) / 2;  // a ball of 7 mm is free there, and not at the middle
  surface.is_whole = false;
  return surface;
}

/// The knob: a cap of this radius up to this angle off its middle, which is the origin, on a square plate of
/// this half width.
constexpr double knob_m = 0.02, knob_rad = 0.7, knob_plate_m = 0.15, knob_thickness_m = 0.04;

/// The cap in `steps` facets from its middle to its rim; the plate's sides are flat.
TriangleSoup knob_mesh(int steps) {
  std::vector<Vec2> profile;
  for (int i = 1; i <= steps; ++i) {
    const double angle = knob_rad * i / steps;
    profile.emplace_back(knob_m * std::sin(angle), knob_m * (std::cos(angle) - 1));
  }
  const double foot_m = profile.back().y(), bottom_m = foot_m - knob_thickness_m;
  profile.emplace_back(knob_plate_m, foot_m);
  profile.emplace_back(knob_plate_m, bottom_m);
  TriangleSoup soup = revolved_mesh(profile, 8 * steps, 0, bottom_m);
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i) {
    auto across = soup.vertices_P.col(i).head<2>();
    if (across.norm() > knob_m) across *= knob_plate_m / across.cwiseAbs().maxCoeff();
  }
  return soup;
}

ExactSurface knob() {
  ExactSurface surface{"knob", "a cap of radius 20 mm on a plate", {4, 8, 24}, {}, {}, {}, {}};
  surface.mesh = knob_mesh;
  surface.facet_m = [](int steps) { return knob_m * knob_rad / steps; };
  surface.foot = [](const Vec3& p) {
    const Vec3 out = p - Vec3(0, 0, -knob_m);
    return ExactFoot{out.norm() - knob_m, out.normalized()};
  };
  surface.way = [](double along) {
    // Off the slivers in the middle, and as far as a ball of 7 mm touches the cap alone.
    const double up = 0.25 + 0.1 * std::sin(1.3 + 11 * along), around = 0.3 + 9.1 * along;
    return Vec3(knob_m *
                Vec3(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up) - 1));
  };
  surface.deepest_m = 0.016;
  surface.is_whole = false;
  return surface;
}

constexpr double rounding_m = 0.005;

/// Half the block's sizes, less its roundings [m].
Vec3 block_inner_m() {
  return {0.015, 0.01, 0.005};
}

ExactFoot block_foot(const Vec3& p) {
  const Vec3 beyond = p.cwiseAbs() - block_inner_m();
  const Vec3 out = beyond.cwiseMax(0);
  const auto with_signs = [&p](const Vec3& v) -> Vec3 {
    return {std::copysign(v.x(), p.x()), std::copysign(v.y(), p.y()), std::copysign(v.z(), p.z())};
  };
  const double length_m = out.norm();
  if (length_m > 0) return {length_m - rounding_m, with_signs(out / length_m)};
  Eigen::Index nearest = 0;
  const double inside_m = beyond.maxCoeff(&nearest);
  return {inside_m - rounding_m, with_signs(Vec3::Unit(nearest))};
}

ExactSurface block() {
  ExactSurface surface{"block", "of 40, 30 and 20 mm, rounded by 5 mm", {6, 12}, {}, {}, {}, {}};
  surface.mesh = [](int steps) { return rounded_block_mesh(block_inner_m(), rounding_m, steps); };
  surface.facet_m = [](int steps) { return rounding_m * whole_turn / 4 / steps; };
  surface.foot = block_foot;
  // Round about it, over its top, its sides and its corners.
  surface.way = [](double along) {
    const double around = 0.3 + 7.3 * along, up = 0.9 * std::sin(1.3 + 5 * along);
    const Vec3 out(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
    const Vec3 over = 0.04 * out;
    const ExactFoot at = block_foot(over);
    return Vec3(over - at.signed_distance_m * at.normal);
  };
  surface.deepest_m = 0.8 * rounding_m;
  return surface;
}

/// A hill and a hollow of this radius beside it, which meet in the origin, where the normal leans by this.
constexpr double bend_m = 0.02, bend_rad = std::numbers::pi / 4, bend_end_rad = -0.3;

Vec3 bend_normal(double lean_rad) {
  return {std::sin(lean_rad), 0, std::cos(lean_rad)};
}

/// @param along_m  of the profile from the origin: < 0 on the hill
Vec3 bend_point(double along_m) {
  const double side = along_m < 0 ? 1 : -1;
  return side * bend_m * (bend_normal(bend_rad - std::abs(along_m) / bend_m) - bend_normal(bend_rad));
}

/// Each of them in `steps` facets from end to end.
TriangleSoup bend_mesh(int steps) {
  std::vector<Vec2> profile;
  for (int i = -steps; i <= steps; ++i) {
    const Vec3 at = bend_point(bend_m * (bend_rad - bend_end_rad) * i / steps);
    profile.emplace_back(at.x(), at.z());
  }
  return bar_mesh(profile, 0.03, -0.07);
}

ExactFoot bend_foot(const Vec3& p) {
  const bool is_hill = p.x() * std::cos(bend_rad) < p.z() * std::sin(bend_rad);
  const double side = is_hill ? 1 : -1;
  const Vec3 out = Vec3(p.x(), 0, p.z()) + side * bend_m * bend_normal(bend_rad);
  return {side * (out.norm() - bend_m), side * out.normalized()};
}

ExactSurface bend() {
  ExactSurface surface{"bend", "a hill and a hollow of 20 mm, nothing flat between", {8, 12, 24}, {}, {}, {},
                       {}};
  surface.mesh = bend_mesh;
  surface.facet_m = [](int steps) { return bend_m * (bend_rad - bend_end_rad) / steps; };
  surface.foot = bend_foot;
  surface.way = [](double along) {
    const Vec3 at = bend_point(0.6 * bend_m * std::sin(1.3 + 17.3 * along));
    return Vec3(at.x(), 0.013 * std::sin(4.1 * along), at.z());
  };
  surface.deepest_m = 0.75 * bend_m;
  surface.highest_m = (bend_m + 0.007) / 2;  // the hollow's other side is not met there
  surface.is_whole = false;
  return surface;
}

std::vector<ExactSurface> coarsest(std::vector<ExactSurface> surfaces, int most_levels) {
  for (ExactSurface& surface : surfaces)
    surface.levels.resize(std::min(surface.levels.size(), static_cast<std::size_t>(most_levels)));
  return surfaces;
}

}  // namespace

std::vector<ExactSurface> exact_surfaces(int most_levels) {
  return coarsest({sphere(), torus(), round_part()}, most_levels);
}

std::vector<ExactSurface> small_exact_surfaces(int most_levels) {
  return coarsest({hollow(), knob(), block(), bend()}, most_levels);
}

}  // namespace fingerpad
