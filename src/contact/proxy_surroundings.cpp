#include "contact/proxy_surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// Triangles in view that are kept at hand; a vertex with a larger fan asks for more.
constexpr std::size_t usual_view = 256;
/// The dual method adds a wall a pass; ordinary places take two or three.
constexpr int most_passes = 48;

int largest_fan(const Part& part) {
  std::vector<int> fan(static_cast<std::size_t>(part.welded_count), 0);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) ++fan[static_cast<std::size_t>(part.welded(k, t))];
  }
  return fan.empty() ? 0 : *std::max_element(fan.begin(), fan.end());
}

/// A wall in a part's frame, as the part's triangles are held against it.
struct PartWall {
  Vec3 normal;
  double offset_m;  // triangles up to here stand behind it
};

bool is_behind(const Part& part, int t, const PartWall& wall) noexcept {
  for (int k = 0; k < 3; ++k) {
    if (wall.normal.dot(part.vertices.col(part.triangles(k, t))) > wall.offset_m) return false;
  }
  return true;
}

bool is_behind_any(const Part& part, int t, std::span<const PartWall> walls) noexcept {
  return std::any_of(walls.begin(), walls.end(),
                     [&](const PartWall& wall) { return is_behind(part, t, wall); });
}

}  // namespace

ProxySurroundings::ProxySurroundings(std::vector<ProxySurface> surfaces, double radius_m)
    : surfaces_(std::move(surfaces)),
      radius_m_(radius_m),
      views_(surfaces_.size()),
      seeds_(surfaces_.size(), -1) {
  std::size_t most = usual_view;
  bool has_centre = false;
  for (const ProxySurface& surface : surfaces_) {
    const Part* part = surface.tree ? &surface.tree->part() : nullptr;
    const Vec3 at =
        part != nullptr ? Vec3(surface.R_WP * part->centre_P + surface.p_WP) : surface.plane_point_W;
    if (!has_centre && part != nullptr) centre_W_ = at;
    has_centre |= part != nullptr;
    part_from_centre_.push_back(at);
    if (part != nullptr) most = std::max(most, 64 + 2 * static_cast<std::size_t>(largest_fan(*part)));
  }
  if (!has_centre && !surfaces_.empty()) centre_W_ = part_from_centre_[0];
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    part_from_centre_[i] -= centre_W_;
    if (surfaces_[i].tree)
      extent_m_ =
          std::max(extent_m_, part_from_centre_[i].norm() + surfaces_[i].tree->part().half_extent.norm());
  }
  skin_m_ = std::ldexp(extent_m_, -27);
  tolerance_m_ = std::ldexp(skin_m_, -6);
  near_.reserve(most);
}

Vec3 ProxySurroundings::in_part(int surface, const Vec3& place) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  return surfaces_[i].R_WP.transpose() * (place - part_from_centre_[i]);
}

Vec3 ProxySurroundings::from_part(int surface, const Vec3& q) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  return surfaces_[i].R_WP * q + part_from_centre_[i];
}

bool ProxySurroundings::box_within(int surface, const Vec3& q, double distance_m) const noexcept {
  const Part& part = surfaces_[static_cast<std::size_t>(surface)].tree->part();
  const Vec3 beyond = (q.cwiseAbs() - part.half_extent).cwiseMax(0.0);
  return beyond.maxCoeff() <= distance_m && beyond.norm() <= distance_m * (1 + 1e-12);
}

ProxyWall ProxySurroundings::plane_wall(int surface, const Vec3& place) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  const Vec3& normal = surfaces_[i].plane_normal_W;
  return {normal, clearance_m() - normal.dot(place - part_from_centre_[i]), surface, -1};
}

ProxyWall ProxySurroundings::facet_wall(int surface, int triangle, double side,
                                        const Vec3& place) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  const Part& part = surfaces_[i].tree->part();
  const Vec3 normal = side * part.facet_normals.col(triangle);
  const Vec3 from_corner = in_part(surface, place) - part.vertices.col(part.triangles(0, triangle));
  return {surfaces_[i].R_WP * normal, clearance_m() - normal.dot(from_corner), surface, triangle};
}

bool ProxySurroundings::is_clear_of_planes(const Vec3& place, int but) const noexcept {
  for (int i = 0; i < static_cast<int>(surfaces_.size()); ++i) {
    if (i != but && !surfaces_[static_cast<std::size_t>(i)].tree && plane_wall(i, place).least_m > 0)
      return false;
  }
  return true;
}

double ProxySurroundings::room_m(const Vec3& place, double enough_m) noexcept {
  double room_m = enough_m;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const int surface = static_cast<int>(i);
    if (!surfaces_[i].tree) {
      room_m =
          std::min(room_m, surfaces_[i].plane_normal_W.dot(place - part_from_centre_[i]) - clearance_m());
      continue;
    }
    const Vec3 q = in_part(surface, place);
    const Part& part = surfaces_[i].tree->part();
    const double to_box_m = (q.cwiseAbs() - part.half_extent).cwiseMax(0.0).norm() * (1 - 1e-12);
    if (to_box_m - clearance_m() >= room_m) continue;
    if (to_box_m > 4 * part.size_m()) {  // the box is near enough to the truth
      room_m = std::min(room_m, to_box_m - clearance_m());
      continue;
    }
    const double reach_m = std::max(room_m, 0.0) + clearance_m();
    const ClosestTriangle closest = surfaces_[i].tree->closest(q, seeds_[i], reach_m);
    if (closest.triangle < 0) continue;
    seeds_[i] = closest.triangle;
    room_m = std::min(room_m, std::sqrt(closest.at.distance2_m2) - clearance_m());
  }
  return room_m;
}

ProxySurroundings::Near ProxySurroundings::near(int surface, int triangle, const Vec3& q) const noexcept {
  const Part& part = surfaces_[static_cast<std::size_t>(surface)].tree->part();
  const TriangleApproach approach = approach_triangle(part, triangle, q);
  return {triangle, approach.distance_m - clearance_m(), approach.towards};
}

/// From a place nearby: the triangles found before are all that can be within what is left of that reach.
bool ProxySurroundings::look_again(const Vec3& place, double reach_m) noexcept {
  const double left_m = search_reach_m_ - (place - search_place_).norm() * (1 + 1e-12);
  if (overflow_ || !(left_m >= 0.5 * reach_m)) return false;
  place_ = place;
  reach_m_ = left_m;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (!surfaces_[i].tree || !views_[i].within_reach) continue;
    views_[i].at = in_part(static_cast<int>(i), place);
    for (std::size_t k = views_[i].first; k < views_[i].end; ++k)
      near_[k] = near(static_cast<int>(i), near_[k].triangle, views_[i].at);
  }
  return true;
}

/// Fills the view; overflow_ where it is too rich.
void ProxySurroundings::search(const Vec3& place, double reach_m) noexcept {
  overflow_ = false;
  near_.clear();
  const double distance_m = clearance_m() + reach_m;
  for (std::size_t i = 0; i < surfaces_.size() && !overflow_; ++i) {
    View& view = views_[i];
    view.first = view.end = near_.size();
    view.within_reach = false;
    if (!surfaces_[i].tree) continue;
    const int surface = static_cast<int>(i);
    view.at = in_part(surface, place);
    view.within_reach = box_within(surface, view.at, distance_m);
    if (!view.within_reach) continue;
    struct Gathering {
      ProxySurroundings* all;
      int surface;
    } gathering{this, surface};
    surfaces_[i].tree->each_within(
        view.at, distance_m,
        [](void* context, int triangle) {
          const Gathering& g = *static_cast<Gathering*>(context);
          ProxySurroundings& all = *g.all;
          all.overflow_ |= all.near_.size() == all.near_.capacity();
          if (all.overflow_) return;
          all.near_.push_back(
              all.near(g.surface, triangle, all.views_[static_cast<std::size_t>(g.surface)].at));
        },
        &gathering);
    view.end = near_.size();
  }
}

double ProxySurroundings::look_around(const Vec3& place, double reach_m, bool anew) noexcept {
  if (!anew && look_again(place, reach_m)) return reach_m_;
  place_ = search_place_ = place;
  is_cut_ = false;
  constexpr int most_cuts = 6;
  for (int cut = 0; cut <= most_cuts; ++cut) {
    reach_m_ = search_reach_m_ = reach_m;
    search(place, reach_m);
    if (!overflow_) return reach_m_;
    is_cut_ = true;
    reach_m *= 0.25;
  }
  // Too many even this near: each pass asks the trees anew.
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (!surfaces_[i].tree) continue;
    views_[i].at = in_part(static_cast<int>(i), place);
    views_[i].within_reach = true;
  }
  return reach_m_;
}

template <class Visit>
void ProxySurroundings::each_near(int surface, Visit visit) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  if (!views_[i].within_reach) return;
  if (!overflow_) {
    for (std::size_t k = views_[i].first; k < views_[i].end; ++k) visit(near_[k]);
    return;
  }
  struct Passing {
    const ProxySurroundings* all;
    int surface;
    Visit* visit;
  } passing{this, surface, &visit};
  surfaces_[i].tree->each_within(
      views_[i].at, clearance_m() + reach_m_,
      [](void* context, int triangle) {
        const Passing& p = *static_cast<Passing*>(context);
        (*p.visit)(p.all->near(p.surface, triangle, p.all->views_[static_cast<std::size_t>(p.surface)].at));
      },
      &passing);
}

std::optional<ProxyWall> ProxySurroundings::worst_wall(const Vec3& z, std::span<const ProxyWall> walls,
                                                       double breach_m) const noexcept {
  std::optional<ProxyWall> worst;
  double worst_slack_m = -breach_m;
  const auto is_worse = [&](double slack_m, int surface, int triangle) {
    if (!(slack_m == worst_slack_m && worst)) return slack_m < worst_slack_m;
    return surface == worst->surface && triangle < worst->triangle;
  };
  for (int surface = 0; surface < static_cast<int>(surfaces_.size()); ++surface) {
    const auto i = static_cast<std::size_t>(surface);
    if (!surfaces_[i].tree) {
      const ProxyWall wall = plane_wall(surface, place_);
      const double slack_m = wall.normal.dot(z) - wall.least_m;
      if (is_worse(slack_m, surface, -1)) {
        worst = wall;
        worst_slack_m = slack_m;
      }
      continue;
    }
    if (!views_[i].within_reach) continue;
    const Part& part = surfaces_[i].tree->part();
    const Mat3& R_WP = surfaces_[i].R_WP;
    const Vec3 from = views_[i].at, way = R_WP.transpose() * z, to = from + way;
    std::array<PartWall, 3> in_front;
    const std::size_t count = std::min<std::size_t>(walls.size(), 3);
    for (std::size_t k = 0; k < count; ++k) {
      in_front[k].normal = R_WP.transpose() * walls[k].normal;
      in_front[k].offset_m = in_front[k].normal.dot(from) + walls[k].least_m - clearance_m() + tolerance_m_;
    }
    each_near(surface, [&](const Near& near) {
      if (near.gap_m + near.towards.dot(way) >= -tolerance_m_) return;
      if (is_behind_any(part, near.triangle, std::span(in_front.data(), count))) return;
      const TriangleSweep sweep =
          sweep_past_triangle(part, near.triangle, from, to, clearance_m(), tolerance_m_);
      if (!sweep.blocked || !is_worse(sweep.end_slack_m, surface, near.triangle)) return;
      worst_slack_m = sweep.end_slack_m;
      worst = ProxyWall{R_WP * sweep.normal, sweep.offset_m - sweep.normal.dot(from), surface, near.triangle};
    });
  }
  return worst;
}

double ProxySurroundings::free_share(const Vec3& z) const noexcept {
  double share = 1;
  for (int surface = 0; surface < static_cast<int>(surfaces_.size()); ++surface) {
    const auto i = static_cast<std::size_t>(surface);
    if (!surfaces_[i].tree) {
      const ProxyWall wall = plane_wall(surface, place_);
      const double along = wall.normal.dot(z);
      if (along < wall.least_m)
        share = std::min(share, along < 0 ? std::max(0.0, wall.least_m / along) : 0.0);
      continue;
    }
    const Vec3 from = views_[i].at, to = from + surfaces_[i].R_WP.transpose() * z;
    each_near(surface, [&](const Near& near) {
      const TriangleSweep sweep = sweep_past_triangle(surfaces_[i].tree->part(), near.triangle, from, to,
                                                      clearance_m(), tolerance_m_);
      if (sweep.blocked) share = std::min(share, sweep.reached);
    });
  }
  return share;
}

bool ProxySurroundings::is_free(const Vec3& z, std::span<const ProxyWall> walls) const noexcept {
  return !worst_wall(z, walls, tolerance_m_);
}

ProxyStep ProxySurroundings::step_towards(const Vec3& goal, const ProxyWall* first) const noexcept {
  ProxyStep step;
  std::array<ProxyWall, 4> walls;
  std::size_t count = 0;
  if (first != nullptr) walls[count++] = *first;
  const auto truncated = [&](const Vec3& z) {
    const double length_m = z.norm();
    step.truncated = length_m > reach_m_;
    return step.truncated ? Vec3(z * (reach_m_ / length_m)) : z;
  };
  // What the projection leaves behind a wall by rounding must not count as a breach.
  const double rounding_m = 4e-16 * goal.cwiseAbs().maxCoeff();
  const double slack_m = std::ldexp(tolerance_m_, -2) + rounding_m, breach_m = tolerance_m_ + 2 * rounding_m;
  for (int pass = 0; pass < most_passes; ++pass) {
    const ProxyProjection p = project_onto_walls(goal, std::span(walls.data(), count), slack_m);
    if (!p.found) {
      step.stuck = true;
      step.z.setZero();
      return step;
    }
    std::array<ProxyWall, 4> kept;
    step.wall_count = p.active_count;
    for (int k = 0; k < p.active_count; ++k) {
      kept[k] = walls[static_cast<std::size_t>(p.active[k])];
      step.walls[k] = kept[k];
      step.share_m[k] = p.share_m[k];
    }
    walls = kept;
    count = static_cast<std::size_t>(p.active_count);
    step.z = truncated(p.z);
    const auto worst = worst_wall(step.z, std::span(walls.data(), count), breach_m);
    if (!worst) return step;
    walls[count++] = *worst;
  }
  step.stuck = true;
  step.z *= free_share(step.z);
  return step;
}

double ProxySurroundings::room_in_front_of(const ProxyWall& wall) const noexcept {
  double room_m = overflow_ ? 0.0 : reach_m_;
  for (std::size_t i = 0; i < surfaces_.size() && room_m > 0; ++i) {
    if (!surfaces_[i].tree || !views_[i].within_reach) continue;
    const Part& part = surfaces_[i].tree->part();
    PartWall in_front;
    in_front.normal = surfaces_[i].R_WP.transpose() * wall.normal;
    in_front.offset_m = in_front.normal.dot(views_[i].at) + wall.least_m - clearance_m() + tolerance_m_;
    each_near(static_cast<int>(i), [&](const Near& near) {
      if (near.gap_m < room_m && !is_behind(part, near.triangle, in_front)) room_m = near.gap_m;
    });
  }
  return std::max(0.0, room_m);
}

}  // namespace fingerpad
