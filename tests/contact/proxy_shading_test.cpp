#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "contact/fast_proxy.hpp"
#include "contact/nasty_corners.hpp"
#include "part/import.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"

// What a proxy shows with shaded normals: how far its normal leans off the way from the finger, and how much
// its push changes in a tick.

namespace fingerpad::proxy_shading_test {
namespace {

constexpr double dt_s = 1e-3;
constexpr double degree = std::numbers::pi / 180;
const int rub_ticks = test::sanitized() ? 300 : 3000;
/// On a real part: fewer would not reach it.
constexpr int real_rub_ticks = 1000;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The greatest angle between two of the facets that meet at a triangle's corners, as far as no crease parts
/// them: by looking at every triangle, nothing of it from src/contact.
class FacetCones {
 public:
  explicit FacetCones(const Part& part) : part_(part) {
    for (int t = 0; t < part.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) at_vertex_[part.welded(k, t)].push_back(t);
    }
  }

  double operator()(int triangle) {
    const auto [known, fresh] = cones_.try_emplace(triangle, 0.0);
    if (!fresh) return known->second;
    std::vector<int> facets;
    for (int k = 0; k < 3; ++k) {
      for (const int t : fan(triangle, part_.welded(k, triangle))) facets.push_back(t);
    }
    for (const int a : facets) {
      for (const int b : facets)
        known->second =
            std::max(known->second, angle_between(part_.facet_normals.col(a), part_.facet_normals.col(b)));
    }
    return known->second;
  }

 private:
  bool joins(int a, int b, int vertex) const {
    for (int k = 0; k < 3; ++k) {
      const bool at_vertex = part_.welded(k, a) == vertex || part_.welded((k + 1) % 3, a) == vertex;
      if (at_vertex && part_.neighbours(k, a) == b &&
          (part_.creases[static_cast<std::size_t>(a)] >> k & 1) == 0)
        return true;
    }
    return false;
  }
  std::vector<int> fan(int triangle, int vertex) const {
    std::vector<int> found{triangle};
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const int t : at_vertex_.at(vertex)) {
        if (std::find(found.begin(), found.end(), t) == found.end() && joins(found[i], t, vertex))
          found.push_back(t);
      }
    }
    return found;
  }

  const Part& part_;
  std::map<int, std::vector<int>> at_vertex_;
  std::map<int, double> cones_;
};

/// A finger that is pressed in jerks into places of the parts, into concave edges by preference, and now and
/// then goes far off.
class Rub {
 public:
  Rub(const test::NastyWorld& world, std::uint64_t seed, double depth, double pace)
      : random_(seed), depth_(depth), pace_(pace), at_(world.start), aim_(world.start) {
    for (const PlacedSurface& surface : world.surfaces) {
      if (surface.tree) parts_.push_back(&surface.tree->part());
    }
    size_m_ = parts_[0]->size_m();
  }

  double size_m() const { return size_m_; }
  Vec3 next() {
    if (--left_ < 0) aim();
    const Vec3 way = aim_ - at_;
    const double step_m = pace_ * size_m_ * (random_.uniform() < 0.02 ? 10 : 1);
    if (way.norm() > step_m) at_ += way.normalized() * step_m;
    at_ += 0.1 * pace_ * size_m_ * somewhere();
    return at_;
  }

 private:
  Vec3 somewhere() { return {random_.normal(), random_.normal(), random_.normal()}; }
  int below(int count) { return std::min(count - 1, static_cast<int>(random_.uniform() * count)); }
  void aim() {
    left_ = 20 + below(150);
    const Part& part = *parts_[static_cast<std::size_t>(below(static_cast<int>(parts_.size())))];
    const auto corner = [&part](int k, int t) -> Vec3 { return part.vertices.col(part.triangles(k, t)); };
    int t = below(part.triangle_count()), edge = -1;
    for (int tries = 0; tries < 50 && edge < 0; ++tries) {
      const int k = below(3), other = part.neighbours(k, t);
      const Vec3 along = corner((k + 1) % 3, t) - corner(k, t);
      const bool is_concave =
          other >= 0 &&
          Vec3(part.facet_normals.col(t)).cross(Vec3(part.facet_normals.col(other))).dot(along) <
              -0.1 * along.norm();
      if (is_concave) edge = k;
      if (!is_concave) t = below(part.triangle_count());
    }
    double u = std::sqrt(random_.uniform()), v = random_.uniform();
    if (edge >= 0 && random_.uniform() < 0.7) u = 1;  // on the edge itself
    const int k = std::max(edge, 0);
    const Vec3 foot =
        (1 - u) * corner((k + 2) % 3, t) + u * (1 - v) * corner(k, t) + u * v * corner((k + 1) % 3, t);
    aim_ = part.centre_P + foot - depth_ * size_m_ * random_.uniform() * part.facet_normals.col(t);
    if (random_.uniform() < 0.1) aim_ += 0.3 * size_m_ * somewhere();
  }

  std::vector<const Part*> parts_;
  RandomStream random_;
  double depth_, pace_, size_m_ = 0;
  Vec3 at_, aim_;
  int left_ = 0;
};

/// What a rub came to. Excesses: <= 0 keeps within the promise.
struct Findings {
  double cone_excess_rad = -1, step_excess = -1, facet_step_excess = -1;  ///< steps as a share of the depth
  double farthest_rad = 0;
  int touched = 0, several = 0;
};

/// The way and the normal of one tick after another, held against what Proxy promises.
class Witness {
 public:
  /// @param hop_share  of the depth, by which a hop may change the push
  Witness(double size_m, double hop_share) : size_m_(size_m), hop_share_(hop_share) {}

  /// By how much the push changed more than it may, as a share of the depth.
  double step_excess(const Vec3& goal, const ProxyContact& contact) {
    const Vec3 push = contact.touching() ? Vec3(contact.depth_m * contact.normal_W) : Vec3::Zero();
    const double finger_m = (goal - goal_).norm(), depth_m = std::max(push.norm(), push_.norm());
    // The finger's motion and the proxy's: twice that, or, where it rests, dt/0.5 s of the way to it.
    const double proxy_m = std::max(2 * finger_m, (push_.norm() + finger_m) * dt_s / 0.5);
    const double most_m = finger_m + proxy_m + hop_share_ * contact.depth_m;
    // 2^-27 of the extent is the proxy's skin.
    const double excess_m = (push - push_).norm() - most_m - 1e-8 * size_m_;
    const bool counts = any_ && depth_m > 0;
    any_ = true;
    goal_ = goal;
    push_ = push;
    return counts ? excess_m / depth_m : -1;
  }

 private:
  double size_m_, hop_share_;
  bool any_ = false;
  Vec3 goal_ = Vec3::Zero(), push_ = Vec3::Zero();
};

Findings rub(const test::NastyWorld& world, std::vector<FacetCones>& cones, Normals normals, double radius,
             int seed, int ticks) {
  Rub finger(world, 77 + static_cast<std::uint64_t>(seed), seed % 2 == 0 ? 0.005 : 0.05,
             seed % 2 == 0 ? 5e-4 : 2e-3);
  Proxy shaded = fast_proxy(world.surfaces, radius * finger.size_m(), normals);
  Proxy facets = fast_proxy(world.surfaces, radius * finger.size_m(), Normals::facet);
  Witness witness(finger.size_m(), 0.07), facet_witness(finger.size_m(), 0);
  Findings found;
  double last_rad = 0;
  for (int k = 0; k < ticks; ++k) {
    const Vec3 goal = finger.next();
    const ProxyContact& c = shaded.move(goal, dt_s);
    found.step_excess = std::max(found.step_excess, witness.step_excess(goal, c));
    found.facet_step_excess =
        std::max(found.facet_step_excess, facet_witness.step_excess(goal, facets.move(goal, dt_s)));
    if (!c.touching()) {
      last_rad = 0;
      continue;
    }
    ++found.touched;
    found.several += c.hold_count > 1 ? 1 : 0;
    double cone_rad = 0;
    for (std::size_t h = 0; h < static_cast<std::size_t>(c.hold_count); ++h) {
      const ContactHold& hold = c.holds[h];
      if (hold.triangle >= 0)
        cone_rad = std::max(cone_rad, cones[static_cast<std::size_t>(hold.surface)](hold.triangle));
    }
    const double lean_rad = angle_between(c.normal_W, c.direction_W);
    found.cone_excess_rad = std::max(found.cone_excess_rad, lean_rad - std::max(cone_rad, last_rad));
    found.farthest_rad = std::max(found.farthest_rad, lean_rad);
    last_rad = lean_rad;
  }
  return found;
}

/// Points and balls, with `smooth` and `curved`, gently and hard.
void expect_promises_kept(const test::NastyWorld& world, int ticks) {
  std::vector<FacetCones> cones;
  static const Part no_part;
  for (const PlacedSurface& surface : world.surfaces)
    cones.emplace_back(surface.tree ? surface.tree->part() : no_part);
  int touched = 0;
  for (const Normals normals : {Normals::smooth, Normals::curved}) {
    for (const double radius : {0.0, 0.03}) {
      for (int seed = 0; seed < 2; ++seed) {
        SCOPED_TRACE(testing::Message() << normals->name << ", radius " << radius << ", seed " << seed);
        const Findings found = rub(world, cones, normals, radius, seed, ticks);
        touched += found.touched;
        // Rounding of unit vectors.
        EXPECT_LT(found.cone_excess_rad, 1e-7)
            << "leans by up to " << found.farthest_rad / degree << " degrees";
        EXPECT_LT(found.facet_step_excess, 1e-9);
        EXPECT_LT(found.step_excess, 1e-9) << "of the depth";
      }
    }
  }
  EXPECT_GT(touched, ticks / 25) << "of " << 8 * ticks << ": it flew past";
}

/// A drum of 24 facets over a plane, between which a cusp of 4 degrees opens to the right. There each wall's
/// share is 14 times the depth, and shading turns the drum's by up to 7.5 degrees.
TEST(ShadedProxy, IsPushedOutOfACuspAndNotIntoIt) {
  std::vector<Vec2> arc;
  for (double deg = 67.5; deg >= -67.5; deg -= 15)
    arc.emplace_back(std::sin(deg * degree), -std::cos(deg * degree));
  for (const double share : {0.05, 0.3, 0.5, 0.9}) {  // of the way along the facet at 15 degrees
    const Vec2 from = arc[5 - 1], to = arc[4 - 1], tip = (1 - share) * from + share * to;
    const Vec3 cusp(tip.x(), 0.1, tip.y());
    const double low = 11 * degree, middle = 13 * degree;  // the plane's slope, and half way to the facet's
    const Vec3 out(std::cos(middle), 0, std::sin(middle));
    for (const Normals normals : {Normals::smooth, Normals::curved}) {
      Proxy proxy = fast_proxy({test::creased_surface(test::drawn(arc, 4)),
                                test::plane_of(cusp, Vec3(-std::sin(low), 0, std::cos(low)))},
                               0, normals);
      ProxyContact c;
      for (int k = 0; k <= 400; ++k) c = proxy.move(cusp + (0.3 - 1e-3 * k) * out, dt_s);
      ASSERT_EQ(c.hold_count, 2) << share;
      EXPECT_LT(angle_between(c.direction_W, out), 1e-3) << share;
      EXPECT_LT(angle_between(c.normal_W, out), 7.5 * degree + 1e-3) << share;
    }
  }
}

TEST(ShadedProxy, LeansNoFartherThanFacetsMeetAndStepsNoFartherThanFacetsDo) {
  for (const test::NastyWorld& world : test::nasty_worlds()) {
    SCOPED_TRACE(world.name);
    expect_promises_kept(world, rub_ticks);
  }
}

/// Those that load faster than they are rubbed.
std::vector<std::filesystem::path> real_parts() {
  auto parts = test::real_parts();
  std::erase_if(parts, [](const auto& path) { return std::filesystem::file_size(path) > 1'000'000; });
  return parts;
}

class ShadedProxyOnRealPart : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ShadedProxyOnRealPart);

TEST_P(ShadedProxyOnRealPart, KeepsItsPromisesInConcavePlaces) {
  const ImportedPart imported = import_touchable(GetParam().string(), 1e-3, 30 * degree);
  const Part& part = *imported.part;
  const Vec3 above = part.centre_P + Vec3(0, 0, part.half_extent.z() + 0.02 * part.size_m());
  expect_promises_kept({"", {test::part_surface(imported.part)}, above}, real_rub_ticks);
}

INSTANTIATE_TEST_SUITE_P(SharedData, ShadedProxyOnRealPart, testing::ValuesIn(real_parts()),
                         [](const auto& info) {
                           std::string name = info.param.stem().string();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace fingerpad::proxy_shading_test
