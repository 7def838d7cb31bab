#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact/surface_places.hpp"
#include "contact/triangle_tree.hpp"
#include "part/random_places.hpp"
#include "study/judged_cases.hpp"

namespace fingerpad {
namespace {

/// Of the finger over the surface before it comes down, beside its radius.
constexpr double low_m = 0.5e-3, high_m = 1e-3;
constexpr double along_m_per_s = 0.1, along_s = 0.2;

/// A place of a part's surface from where nothing of it lies in the way out.
struct Landing {
  Vec3 at_P, normal_P;
};

/// Places of a part's surface, relative to its centre, in a region or (-1) anywhere.
class LandingPlaces {
 public:
  LandingPlaces(const Part& part, int region) : part_(part), places_(part), region_(region) {
    if (region < 0) return;
    const double slack_m = 1e-12 * part.size_m();  // by which rounding puts a point beside its triangle
    may_be_there_.reserve(static_cast<std::size_t>(part.triangle_count()));
    for (int t = 0; t < part.triangle_count(); ++t) {
      Eigen::AlignedBox3d box;
      for (const int corner : part.triangles.col(t)) box.extend(part.vertices.col(corner));
      const Vec3 slack = Vec3::Constant(slack_m);
      may_be_there_.push_back(reaches_region(part, box.min() - slack, box.max() + slack, region));
    }
  }

  Landing draw(RandomStream& random) const {
    constexpr int most_draws = 20000;  // more than a region's share needs, which is at least a two-thousandth
    for (int tries = 0;; ++tries) {
      const int t = places_.triangle(random);
      const bool is_last = region_ < 0 || tries == most_draws;
      if (!is_last && !may_be_there_[static_cast<std::size_t>(t)]) {
        RandomPlaces::pass_point(random);
        continue;
      }
      const Landing landing{places_.point(t, Vec3::Zero(), random), part_.facet_normals.col(t)};
      if (is_last || region_of(part_, landing.at_P) == region_) return landing;
    }
  }

 private:
  const Part& part_;
  RandomPlaces places_;
  int region_;
  std::vector<bool> may_be_there_;  // a triangle's points
};

/// Whether a finger can come down there: it fits at its start, and nothing is in its centre's way.
bool is_free(const TriangleTree& tree, const Landing& landing, double height_m, double radius_m) {
  const Vec3 top = landing.at_P + height_m * landing.normal_P;
  const double slack_m = 1e-6 * tree.part().size_m();
  const Vec3 foot = landing.at_P + slack_m * landing.normal_P;
  if (tree.closest(top, -1, radius_m).triangle >= 0) return false;
  return tree.first_crossing(top, foot).triangle < 0 && tree.first_crossing(foot, top).triangle < 0;
}

/// Of the greatest force.
double drawn_press(StrokePress press, bool is_hard_turn, RandomStream& random) {
  constexpr double lightest = 0.1, hard = 1.0 / 3;
  if (press == StrokePress::lightest || (press == StrokePress::mixed && !is_hard_turn)) return lightest;
  // Drawn for the greatest too, which so comes down at the same places as the hard ones.
  const double drawn = std::pow(press == StrokePress::hard ? hard : lightest, random.uniform());
  return press == StrokePress::greatest ? 1 : drawn;
}

/// A direction across n, unit.
Vec3 drawn_across(const Vec3& n, RandomStream& random) {
  const double turn = 2 * std::numbers::pi * random.uniform();
  const Vec3 across = n.unitOrthogonal();
  return std::cos(turn) * across + std::sin(turn) * n.cross(across);
}

void go_to(std::vector<Vec3>& places, const Vec3& to, double speed_m_per_s, double rate_hz) {
  const Vec3 from = places.back();
  const auto ticks = static_cast<int>(std::ceil((to - from).norm() / speed_m_per_s * rate_hz));
  for (int k = 1; k <= ticks; ++k) places.emplace_back(from + (to - from) * k / ticks);
}

}  // namespace

std::vector<FingerPath> strokes_over(const Surface& surface, const Scene& scene, const StrokePlan& plan) {
  const Part& part = *surface.part;
  const double rate_hz = scene.motion.rate_hz, radius_m = scene.finger.radius_m;
  const double greatest_m = scene.contact.greatest_force_n / surface.properties.stiffness_n_per_m;
  const LandingPlaces landings(part, plan.region);
  RandomStream random(plan.seed);
  std::vector<FingerPath> strokes;
  for (int tries = 0; tries < 20 * plan.count && static_cast<int>(strokes.size()) < plan.count; ++tries) {
    const Landing landing = landings.draw(random);
    const Vec3 n = surface.R_WP * landing.normal_P;
    const double depth_m = greatest_m * drawn_press(plan.press, strokes.size() % 2 != 0, random);
    std::vector<Vec3> ways_W;
    ways_W.reserve(static_cast<std::size_t>(plan.legs));
    for (int leg = 0; leg < plan.legs; ++leg) ways_W.push_back(drawn_across(n, random));
    const double height_m =
        radius_m + (plan.starts_low ? plan.scale * low_m : radius_m + plan.scale * high_m);
    if (!is_free(*surface.tree, landing, height_m, radius_m)) continue;
    const Vec3 on = surface.R_WP * (landing.at_P + part.centre_P) + surface.p_WP;
    std::vector<Vec3> places{on + height_m * n};
    const Vec3 deep = on + (radius_m - depth_m) * n;
    const double length_m =
        std::min({plan.scale * along_m_per_s * along_s, part.size_m() / 4, plan.longest_m});
    const double down_m_per_s = plan.scale * plan.down_m_per_s;
    go_to(places, deep, down_m_per_s, rate_hz);
    for (const Vec3& along_W : ways_W)
      go_to(places, places.back() + length_m * along_W, plan.scale * along_m_per_s, rate_hz);
    go_to(places, places.back() + (height_m - radius_m + depth_m) * n, down_m_per_s, rate_hz);
    strokes.push_back(way_through(places, scene));
  }
  return strokes;
}

}  // namespace fingerpad
