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

ProxyWall ProxySurroundings::tangent_wall(int surface, int triangle, const Vec3& from,
                                          const Vec3& place) const noexcept {
  const ProxySurface& s = surfaces_[static_cast<std::size_t>(surface)];
  const TriangleApproach approach = approach_triangle(s.tree->part(), triangle, in_part(surface, from));
  const Vec3 normal = s.R_WP * approach.towards;
  return {normal, clearance_m() - approach.distance_m + normal.dot(from - place), surface, triangle};
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

/// From a place nearby: the triangles found before are all that can be within what is left of that reach.
bool ProxySurroundings::look_again(const Vec3& place, double need_m) noexcept {
  const double left_m = search_reach_m_ - (place - search_place_).norm() * (1 + 1e-12);
  if (overflow_ || !(left_m >= need_m)) return false;
  place_ = place;
  reach_m_ = left_m;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_[i].tree && views_[i].within_reach) views_[i].at = in_part(static_cast<int>(i), place);
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
          NearTriangle& near = all.near_.emplace_back();
          near.triangle = triangle;
          near.corners =
              corners_of(all.surfaces_[static_cast<std::size_t>(g.surface)].tree->part(), triangle);
        },
        &gathering);
    view.end = near_.size();
  }
}

void ProxySurroundings::search_around(const Vec3& place, double reach_m) noexcept {
  place_ = search_place_ = place;
  is_cut_ = false;
  constexpr int most_cuts = 6;
  for (int cut = 0; cut <= most_cuts; ++cut) {
    reach_m_ = search_reach_m_ = reach_m;
    search(place, reach_m);
    if (!overflow_) return;
    is_cut_ = true;
    reach_m *= 0.25;
  }
  // Too many even this near: each pass asks the trees anew.
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (!surfaces_[i].tree) continue;
    views_[i].at = in_part(static_cast<int>(i), place);
    views_[i].within_reach = true;
  }
}

double ProxySurroundings::look_around(const Vec3& place, double reach_m, bool anew) noexcept {
  if (anew || !look_again(place, 0.5 * reach_m)) search_around(place, reach_m);
  return reach_m_;
}

bool ProxySurroundings::look_ahead(const Vec3& place, double need_m, double reach_m,
                                   const Vec3& ahead) noexcept {
  if (look_again(place, need_m)) return false;
  search_around(place + ahead, reach_m);
  if (!look_again(place, need_m)) search_around(place, reach_m);  // cut short there
  return true;
}

template <class Visit>
void ProxySurroundings::each_near(int surface, Visit visit) noexcept {
  const auto i = static_cast<std::size_t>(surface);
  if (!views_[i].within_reach) return;
  if (!overflow_) {
    for (std::size_t k = views_[i].first; k < views_[i].end; ++k) visit(near_[k]);
    return;
  }
  struct Passing {
    const Part* part;
    Visit* visit;
  } passing{&surfaces_[i].tree->part(), &visit};
  surfaces_[i].tree->each_within(
      views_[i].at, clearance_m() + reach_m_,
      [](void* context, int triangle) {
        const Passing& p = *static_cast<Passing*>(context);
        NearTriangle near;
        near.triangle = triangle;
        near.corners = corners_of(*p.part, triangle);
        (*p.visit)(near);
      },
      &passing);
}

/// The walls in a part's frame; seen from the place looked around from.
std::size_t ProxySurroundings::part_walls(int surface, std::span<const ProxyWall> walls,
                                          std::array<PartWall, 3>& in_part) const noexcept {
  const auto i = static_cast<std::size_t>(surface);
  const std::size_t count = std::min(walls.size(), in_part.size());
  for (std::size_t k = 0; k < count; ++k) {
    in_part[k].normal = surfaces_[i].R_WP.transpose() * walls[k].normal;
    in_part[k].offset_m =
        in_part[k].normal.dot(views_[i].at) + walls[k].least_m - clearance_m() + tolerance_m_;
  }
  return count;
}

/// The wall that a way breaches most, of those offered so far; ties go to the lowest triangle.
struct ProxySurroundings::Worst {
  std::optional<ProxyWall> wall;
  double slack_m;  ///< < 0

  bool is_beaten_by(double other_slack_m, int surface, int triangle) const noexcept {
    if (!(other_slack_m == slack_m && wall)) return other_slack_m < slack_m;
    return surface == wall->surface && triangle < wall->triangle;
  }
};

void ProxySurroundings::offer_plane(int surface, const Vec3& z, Worst& worst) const noexcept {
  const ProxyWall wall = plane_wall(surface, place_);
  const double slack_m = wall.normal.dot(z) - wall.least_m;
  if (worst.is_beaten_by(slack_m, surface, -1)) worst = {wall, slack_m};
}

void ProxySurroundings::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                                   Worst& worst) noexcept {
  const auto i = static_cast<std::size_t>(surface);
  const Mat3& R_WP = surfaces_[i].R_WP;
  const Vec3 from = views_[i].at, way = R_WP.transpose() * z, to = from + way;
  const double way_m = way.norm() * (1 + 1e-12);
  std::array<PartWall, 3> in_front;
  const std::span in_front_of(in_front.data(), part_walls(surface, walls, in_front));
  const NearTriangle* worst_near = nullptr;
  const auto offer = [&](NearTriangle& near) {
    if (near.is_behind_any(in_front_of)) return;
    if (!near.seen || near.seen_from != from) near.look_from(from, clearance_m());
    // The breach only shrinks as the sweep goes on from its first tangent, which is this.
    const double end_slack_m = near.gap_m + near.towards.dot(way);
    if (end_slack_m >= -tolerance_m_ || end_slack_m > worst.slack_m) return;
    const TriangleSweep sweep = sweep_past_triangle(near.corners, from, to, clearance_m(), tolerance_m_);
    if (!sweep.blocked || !worst.is_beaten_by(sweep.end_slack_m, surface, near.triangle)) return;
    worst.slack_m = sweep.end_slack_m;
    worst.wall =
        ProxyWall{R_WP * sweep.normal, sweep.offset_m - sweep.normal.dot(from), surface, near.triangle};
    worst_near = &near;
  };
  each_near(surface, [&](NearTriangle& near) {
    if (near.seen) {
      const double here_m = near.least_gap_m(from), there_m = near.least_gap_m(to);
      // Both ends well in front of the half space that an earlier look left free (where the ball touches,
      // what it sees from here decides), or, however steeply the way leads down from here, a smaller breach
      // than one that is known.
      if (std::min(here_m, there_m) >= 2 * tolerance_m_ || here_m - way_m > worst.slack_m) return;
    }
    offer(near);
  });
  // It is likely the worst of the next way too, which then tells at once that others are not.
  if (worst_near != nullptr && !overflow_)
    std::swap(near_[views_[i].first], near_[static_cast<std::size_t>(worst_near - near_.data())]);
}

std::optional<ProxyWall> ProxySurroundings::worst_wall(const Vec3& z, std::span<const ProxyWall> walls,
                                                       double breach_m) noexcept {
  Worst worst{std::nullopt, -breach_m};
  for (int surface = 0; surface < static_cast<int>(surfaces_.size()); ++surface) {
    const auto i = static_cast<std::size_t>(surface);
    if (!surfaces_[i].tree) {
      offer_plane(surface, z, worst);
    } else if (views_[i].within_reach) {
      offer_part(surface, z, walls, worst);
    }
  }
  return worst.wall;
}

double ProxySurroundings::free_share(const Vec3& z) noexcept {
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
    each_near(surface, [&](const NearTriangle& near) {
      const TriangleSweep sweep = sweep_past_triangle(near.corners, from, to, clearance_m(), tolerance_m_);
      if (sweep.blocked) share = std::min(share, sweep.reached);
    });
  }
  return share;
}

bool ProxySurroundings::is_free(const Vec3& z, std::span<const ProxyWall> walls) noexcept {
  return !worst_wall(z, walls, tolerance_m_);
}

ProxyStep ProxySurroundings::step_towards(const Vec3& goal, const ProxyWall* first) noexcept {
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

double ProxySurroundings::room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre) noexcept {
  double room_m = overflow_ ? 0.0 : search_reach_m_ - (centre - search_place_).norm() * (1 + 1e-12);
  for (std::size_t i = 0; i < surfaces_.size() && room_m > 0; ++i) {
    if (!surfaces_[i].tree || !views_[i].within_reach) continue;
    const int surface = static_cast<int>(i);
    const Vec3 at = in_part(surface, centre);
    std::array<PartWall, 3> in_front;
    const std::span in_front_of(in_front.data(), part_walls(surface, walls, in_front));
    each_near(surface, [&](NearTriangle& near) {
      if (near.seen && near.least_gap_m(at) >= room_m) return;
      if (near.is_behind_any(in_front_of)) return;
      if (!near.seen || near.seen_from != at) near.look_from(at, clearance_m());
      room_m = std::min(room_m, near.gap_m);
    });
  }
  return std::max(0.0, room_m);
}

}  // namespace fingerpad
