#include "contact/proxy_memory.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <type_traits>

#include "contact/proxies.hpp"
#include "contact/proxy_report.hpp"
#include "part/import.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/wanderer.hpp"

// The proxy that remembers against the one that does not, tick by tick, each tick from the same state.

namespace fingerpad::proxy_memory_test {
namespace {

constexpr double crease_rad = 30 * M_PI / 180;
/// A whole walk, whose shares are bounded. The sanitizers, which make it ten times as slow, get its
/// beginning.
constexpr int whole_walk_ticks = 1600;
const int walk_ticks = test::sanitized() ? whole_walk_ticks / 4 : whole_walk_ticks;

/// How the two compare over a walk, in ticks.
struct Agreement {
  int touched = 0;
  int same = 0;
  int underway = 0;       ///< at least one of them is not settled, ...
  int underway_same = 0;  ///< ... and yet they are at the same place
  /// Two places as near to the finger as each other: settling ends within the tolerance, and of facets that
  /// lie so near to one plane either may hold.
  int ties = 0;
  /// Another place: a view, or a flight, ended a long step short, and the proxy went on from there.
  int elsewhere = 0;
  int told_otherwise = 0;  ///< the same place, but another depth, direction or number of holds
  /// The same place and walls, but shaded by another of the triangles that lie in one wall's plane: which of
  /// them blocks a step most is a matter of rounding.
  int shaded_otherwise = 0;
};

bool tell_the_same(const ProxyContact& a, const ProxyContact& b, double size_m) {
  if (a.touching() != b.touching()) return std::max(a.depth_m, b.depth_m) < 1e-9 * size_m;  // the skin
  if (!a.touching()) return true;
  return std::abs(a.depth_m - b.depth_m) < 1e-11 * size_m && (a.direction_W - b.direction_W).norm() < 1e-6 &&
         a.hold_count == b.hold_count;
}

bool name_the_same_triangles(const ProxyContact& a, const ProxyContact& b) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.hold_count); ++k) {
    if (a.holds[k].triangle != b.holds[k].triangle) return false;
  }
  return true;
}

void compare(const ProxyState& fast, const ProxyState& plain, double size_m, Agreement& sum) {
  sum.touched += plain.contact.touching() ? 1 : 0;
  const bool is_same = (fast.place_O - plain.place_O).norm() <= 1e-12 * size_m;
  if (!fast.contact.settled || !plain.contact.settled) {
    // How far a view shows may yet decide which wall a step comes upon.
    ++sum.underway;
    sum.underway_same += is_same ? 1 : 0;
  } else if (is_same) {
    ++sum.same;
    const ProxyContact &a = fast.contact, &b = plain.contact;
    if (!tell_the_same(a, b, size_m)) {
      ++sum.told_otherwise;
    } else if (a.touching() && b.touching() && (a.normal_W - b.normal_W).norm() > 1e-6) {
      ++(name_the_same_triangles(a, b) ? sum.told_otherwise : sum.shaded_otherwise);
    }
  } else {
    const double fast_m = (fast.place_O - fast.goal_O).norm(),
                 plain_m = (plain.place_O - plain.goal_O).norm();
    // The tolerance is 2^-34 of the size.
    ++(std::abs(fast_m - plain_m) < 16 * std::ldexp(size_m, -34) ? sum.ties : sum.elsewhere);
  }
}

Agreement walk(const std::shared_ptr<const TriangleTree>& tree, double radius_m, Normals normals) {
  PlacedSurface surface;
  surface.tree = tree;
  Proxy fast = fast_proxy({surface}, radius_m, normals), plain({surface}, radius_m, normals);
  test::Wanderer finger(tree->part());
  Agreement sum;
  for (int k = 0; k < walk_ticks; ++k) {
    // Straight through it, over its facets, and within one.
    const double paces[] = {1, 0.1, 0.01};
    const Vec3 p_WQ = finger.next(paces[k < walk_ticks / 4 ? 0 : k / 40 % 3]);
    if (fast.state().placed) plain.resume(fast.state());
    fast.move(p_WQ, 1e-3);
    plain.move(p_WQ, 1e-3);
    compare(fast.state(), plain.state(), tree->part().size_m(), sum);
  }
  return sum;
}

void expect_agreement(const std::shared_ptr<const TriangleTree>& tree, const std::string& name) {
  for (const double radius_m : {0.0, 0.01 * tree->part().size_m()}) {
    for (const Normals normals : {Normals::facet, Normals::smooth}) {
      const Agreement a = walk(tree, radius_m, normals);
      SCOPED_TRACE(testing::Message() << name << " radius " << radius_m);
      EXPECT_EQ(a.told_otherwise, 0);
      if (walk_ticks == whole_walk_ticks) {
        EXPECT_LE(a.shaded_otherwise, normals == Normals::facet ? 0 : walk_ticks / 8);
        EXPECT_LE(a.elsewhere, walk_ticks / 200);
        EXPECT_LE(a.ties, walk_ticks / 5);
        EXPECT_LE(a.underway - a.underway_same, walk_ticks / 16);
        EXPECT_LE(a.underway, walk_ticks / 2);
        EXPECT_GT(a.same, walk_ticks / 3);
      }
      const double percent = 100.0 / walk_ticks;
      fmt::print(
          "{}, {}, {}: {:.1f} % touching; same place {:.2f} % (shaded otherwise {:.2f} %), on its way {:.2f} "
          "% (of these {:.2f} % elsewhere), ties {:.2f} %, elsewhere {:.2f} %\n",
          name, radius_m > 0 ? "ball" : "point", normals->name, percent * a.touched, percent * a.same,
          percent * a.shaded_otherwise, percent * a.underway, percent * (a.underway - a.underway_same),
          percent * a.ties, percent * a.elsewhere);
    }
  }
}

class ProxyMemoryOnRealPart : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProxyMemoryOnRealPart);

TEST_P(ProxyMemoryOnRealPart, AnswersAsTheProxyAloneDoes) {
  const ImportedPart imported = import_part(GetParam().string(), 1e-3, crease_rad);
  if (!imported.part) GTEST_SKIP() << imported.verdict.error;
  expect_agreement(std::make_shared<const TriangleTree>(imported.part), GetParam().filename().string());
}

INSTANTIATE_TEST_SUITE_P(SharedData, ProxyMemoryOnRealPart, testing::ValuesIn(test::real_parts()),
                         [](const auto& info) {
                           std::string name = info.param.stem().string();
                           const auto bad = [](char c) {
                             return std::isalnum(static_cast<unsigned char>(c)) == 0;
                           };
                           std::replace_if(name.begin(), name.end(), bad, '_');
                           return name;
                         });

TEST(ProxyMemory, AnswersAsTheProxyAloneDoesOnShapesThatHopRollAndWedge) {
  const TriangleSoup crossing =
      test::joined(test::box_soup(Vec3(0.04, 0.03, 0.02)),
                   test::moved(test::torus_soup(0.02, 0.006, 24, 12), Vec3(0, 0, 0.012)));
  expect_agreement(surface_of(crossing).tree, "box and ring");
  expect_agreement(surface_of(test::sphere_soup(0.1, 4)).tree, "sphere");
  expect_agreement(surface_of(test::roof_soup(0.05, -0.4)).tree, "valley");
}

static_assert(!std::is_constructible_v<ProxyViews, ProxyWorld, Looks>, "without a memory it sees no edges");

TEST(ProxyMemory, StepsAsThePlainSightFromItsMakingOn) {
  const ProxyWorld world({surface_of(test::box_soup(Vec3(0.1, 0.1, 0.02)))}, 0.001, Normals::facet);
  ProxyState state;
  state.place_O = Vec3(0.01, 0.02, 0.0112);
  state.goal_O = Vec3(0.0102, 0.02, 0.01);
  const StepTerms terms{std::numeric_limits<double>::infinity()};
  const ProxyStep fast = ProxyMemory(world, Looks(Looks::unlimited)).step(state, terms),
                  plain = ProxySight(world).step(state, terms);
  EXPECT_EQ(plain.wall_count, 1);
  EXPECT_EQ(fast.wall_count, 1);
  EXPECT_LT((fast.z - plain.z).norm(), 1e-15);  // rounding of 1e-2
}

TEST(ProxyMemory, OneWallHoldsWithoutItsSkinWhereTheProjectionSaysSo) {
  const ProxyWorld world({surface_of(test::box_soup(Vec3(0.1, 0.1, 0.02)))}, 0.001, Normals::facet);
  const Vec3 normal = Vec3(1, 2, -2) / 3;
  const Vec3 goal = 0.3 * Vec3(2, -1, 0.5);
  int held = 0;
  for (int k = -40; k <= 40; ++k) {
    ProxyWall wall;
    wall.normal = normal;
    wall.least_m = normal.dot(goal) + world.skin_m() + (0.1 * k + 0.05) * world.slack_m();
    ProxyStep hold;
    hold.wall_count = 1;
    hold.walls[0] = wall;
    const auto one = held_without_skin(world, hold, goal);
    wall.least_m -= world.skin_m();
    const ProxyProjection any = project_onto_walls(goal, std::span(&wall, 1), world.slack_m());
    ASSERT_TRUE(one && any.found);
    ASSERT_EQ(one->wall_count, any.wall_count) << k;
    held += one->wall_count;
    if (one->wall_count > 0) {
      ASSERT_EQ(one->share_m[0], any.share_m[0]);
    }
  }
  EXPECT_EQ(held, 31) << "from a slack on";
}

}  // namespace
}  // namespace fingerpad::proxy_memory_test
