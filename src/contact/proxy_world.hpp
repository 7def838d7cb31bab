#pragma once

#include <span>
#include <vector>

#include "contact/approach_memory.hpp"
#include "contact/placed_surface.hpp"
#include "contact/proxy_sweep.hpp"
#include "contact/proxy_wall.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The surfaces that a ball stays out of, and what it keeps from them.
///
/// Frame O has the world's axes and its origin at the centre of the first part (without parts: at the first
/// plane's point), so that far coordinates cost no digits. A place is where the ball's centre is, in O. The
/// ball keeps `clearance_m()` from every triangle, seen from either side, and from every plane's half space.
class ProxyWorld {
 public:
  ProxyWorld(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals);

  int surface_count() const noexcept { return static_cast<int>(surfaces_.size()); }
  const PlacedSurface& surface(int i) const noexcept { return surfaces_[static_cast<std::size_t>(i)]; }
  /// The numbers of those that are parts, and of those that are planes: a part is searched, and may have to
  /// wait for the next tick's looks; a plane is always there and costs none. Parts are asked first.
  std::span<const int> parts() const noexcept { return parts_; }
  std::span<const int> planes() const noexcept { return planes_; }
  const Part& part(int i) const noexcept { return surface(i).tree->part(); }
  Normals normals() const noexcept { return normals_; }
  /// Whether facets stand for a smooth surface, with normals of its own.
  bool is_shaded() const noexcept { return !normals_->shows_facets(); }

  const Vec3& p_WO() const noexcept { return p_WO_; }
  /// The largest distance from O's origin to a part's far end [m]; 0 without parts.
  double extent_m() const noexcept { return extent_m_; }
  double radius_m() const noexcept { return radius_m_; }
  /// What the ball keeps beyond its radius [m]; none without parts, since planes have one side only.
  double skin_m() const noexcept { return skin_m_; }
  double clearance_m() const noexcept { return radius_m_ + skin_m_; }
  /// By how much the clearance may be missed [m]; 0 without parts.
  double tolerance_m() const noexcept { return tolerance_m_; }
  /// By how much a projection may miss a wall [m].
  double slack_m() const noexcept { return slack_m_; }
  /// Among planes alone, what rounding leaves of a place's distance from them [m]: of the finger's too, from
  /// which places are reckoned, since it may stay behind where the planes meet in O itself. 0 with parts,
  /// whose tolerance is far larger.
  double plane_rounding_m(const Vec3& place_O, const Vec3& goal_O) const noexcept;
  /// A ball that is no more than this away from a wall lies on it [m].
  double touching_m() const noexcept { return touching_m_; }

  /// A direction in a part's frame, and back; of a part that stands upright it is the same.
  Vec3 turned_into_part(int surface, const Vec3& v_W) const noexcept {
    return is_upright(surface) ? v_W : Vec3(this->surface(surface).R_WP.transpose() * v_W);
  }
  Vec3 turned_from_part(int surface, const Vec3& v_P) const noexcept {
    return is_upright(surface) ? v_P : Vec3(this->surface(surface).R_WP * v_P);
  }
  /// A place in the frame of a part's arrays, and back.
  Vec3 in_part(int surface, const Vec3& place_O) const noexcept;
  Vec3 from_part(int surface, const Vec3& q_P) const noexcept;
  /// How a place stands before a part's triangle; in the frame of the part's arrays. For one thread at a
  /// time.
  /// @returns good until the next question
  const TriangleApproach& approach(int surface, int triangle, const Vec3& place_O) const noexcept;

  /// Whether there is a gap that could be seen between the ball at a place and the triangle of a wall.
  bool is_far_from(const ProxyWall& wall, const Vec3& place_O) const noexcept;
  /// Whether a triangle's wall lies in its own plane.
  bool is_own_plane(const ProxyWall& wall) const noexcept;

  /// The half space that a plane leaves free, seen from a place.
  ProxyWall plane_wall(int surface, const Vec3& place_O) const noexcept;
  /// The half space that a triangle leaves free of a ball at `from`: the way to there from its closest point
  /// is the wall's normal. Seen from a place.
  ProxyWall tangent_wall(int surface, int triangle, const Vec3& from_O, const Vec3& place_O) const noexcept;
  /// The same of a ball at the place itself.
  ProxyWall wall_at(int surface, int triangle, const Vec3& place_O) const noexcept {
    return tangent_wall(surface, triangle, place_O, place_O);
  }

 private:
  bool is_upright(int surface) const noexcept { return is_upright_[static_cast<std::size_t>(surface)] != 0; }

  std::vector<PlacedSurface> surfaces_;
  std::vector<int> parts_, planes_;
  double radius_m_;
  Normals normals_;
  Vec3 p_WO_ = Vec3::Zero();
  double extent_m_ = 0, middles_m_ = 0, skin_m_ = 0, tolerance_m_ = 0, slack_m_ = 0, touching_m_ = 0;
  std::vector<Vec3> middle_O_;    // per surface: the part's centre, or the plane's point
  std::vector<char> is_upright_;  // per surface: it is not turned
  mutable ApproachMemory approaches_;
};

}  // namespace fingerpad
