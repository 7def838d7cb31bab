#include "contact/way_sieve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/packed_part.hpp"
#include "contact/proxies.hpp"
#include "contact/tree_trials.hpp"
#include "support/shapes.hpp"

// What a look at a part passes over, against looking at all of it.

namespace fingerpad::way_sieve_test {
namespace {

Vec3 any(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

/// Triangles of every shape, half of them too slender for a rough frame.
TriangleSoup sliver_soup() {
  const auto part = test::soup_of_slivers(400);
  TriangleSoup soup;
  soup.vertices_P = 0.02 * part->vertices;
  soup.triangles = part->triangles;
  return soup;
}

std::vector<PlacedSurface> trial_surfaces() {
  return {surface_of(test::torus_soup(0.02, 0.008, 48, 24)), surface_of(test::sphere_soup(0.03, 3)),
          surface_of(test::joined(test::box_soup(Vec3(0.05, 0.04, 0.01)),
                                  test::moved(test::torus_soup(0.01, 0.003, 24, 12), Vec3(0, 0, 0.006))))};
}

std::vector<PlacedSurface> trial_surfaces_and_slivers() {
  std::vector<PlacedSurface> surfaces = trial_surfaces();
  surfaces.push_back(surface_of(sliver_soup()));
  return surfaces;
}

/// A ball somewhere about a part, its way, and a wall found before.
struct Stand {
  ProxyWorld world;
  PartWay way;
  PartWalls before;
  WorstWall worst;

  Stand(const PlacedSurface& surface, RandomStream& random)
      : world({surface}, random.uniform() < 0.3 ? 0 : 0.02 * random.uniform(), Normals::facet),
        way(world, 0, start(surface, world.clearance_m(), random),
            std::pow(10, -4 + 2 * random.uniform()) * any(random)),
        before(walls(random)),
        worst{std::nullopt, -world.tolerance_m() - (random.uniform() < 0.5 ? 0 : 0.01 * random.uniform())} {}

  /// Clear of the surface, or touching it.
  static Vec3 start(const PlacedSurface& surface, double clearance_m, RandomStream& random) {
    const Vec3 q = 0.03 * any(random);
    const ClosestTriangle near = surface.tree->closest(q, -1, HUGE_VAL);
    const Vec3 out = (q - near.at.point).normalized();
    return near.at.point + (clearance_m + (random.uniform() < 0.5 ? 0 : 1e-3 * random.uniform())) * out;
  }
  PartWalls walls(RandomStream& random) const {
    std::array<ProxyWall, PartWalls::most_walls> some;
    for (ProxyWall& wall : some) {
      wall.normal = any(random).normalized();
      wall.least_m = -0.01 * random.uniform();
    }
    const auto count = static_cast<std::size_t>(random.uniform() < 0.5 ? 0 : 1 + 3 * random.uniform());
    return {world, 0, std::span(some).first(count), way.from_P};
  }

  /// Whether a triangle is a wall that matters.
  bool matters(int t) const {
    const TriangleCorners corners = corners_of(world.part(0), t);
    if (before.hide(corners)) return false;
    WorstWall other = worst;
    return other.offer_triangle(world, way, corners, t,
                                FirstApproach(approach_triangle(corners, way.from_P)));
  }
};

TEST(WaySieve, LeavesOutNothingThatMatters) {
  RandomStream random(31);
  long passed_over = 0, left_out = 0, matter = 0, slivers = 0, slivers_that_matter = 0;
  for (const PlacedSurface& surface : trial_surfaces_and_slivers()) {
    const PackedPart packed = pack(std::make_shared<const Part>(surface.tree->part()));
    for (int k = 0; k < 300; ++k) {
      const Stand s(surface, random);
      const WaySieve sieve(s.world, s.way, s.before, s.worst, packed.scale);
      for (std::size_t i = 0; i < packed.packets.size(); ++i) {
        const TrianglePacket& packet = packed.packets[i];
        const bool is_passed_over = sieve.passes_over(packed.discs[i]);
        passed_over += is_passed_over ? 1 : 0;
        const unsigned lanes = sieve.lanes_left(packet);
        for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
          const bool is_left_out = is_passed_over || (lanes >> lane & 1) == 0;
          left_out += is_left_out ? 1 : 0;
          const bool is_sliver = (packet.always_exact >> lane & 1) != 0;
          slivers += is_sliver && (lanes >> lane & 1) == 0 ? 1 : 0;
          const bool does_matter = s.matters(packet.exact[static_cast<std::size_t>(lane)].triangle);
          matter += does_matter ? 1 : 0;
          slivers_that_matter += is_sliver && does_matter ? 1 : 0;
          ASSERT_FALSE(is_left_out && does_matter) << k;
        }
      }
    }
  }
  EXPECT_GT(matter, 1000);
  EXPECT_GT(left_out, 20 * matter) << "most of a part";
  EXPECT_GT(passed_over, 10 * matter);
  EXPECT_GT(slivers, 1000);
  EXPECT_GT(slivers_that_matter, 50);
}

/// Of a wall that is worse than the worst by a hair, and of one of which a hair stands before another wall,
/// no float can tell that it matters.
TEST(WaySieve, KeepsWhatMattersByAHair) {
  RandomStream random(35);
  long by_slack = 0, by_wall = 0;
  for (const PlacedSurface& surface : trial_surfaces_and_slivers()) {
    const PackedPart packed = pack(std::make_shared<const Part>(surface.tree->part()));
    for (int k = 0; k < 300; ++k) {
      Stand s(surface, random);
      s.before = PartWalls(s.world, 0, {}, s.way.from_P);
      const double hair_m = 1e-13 * surface.tree->part().size_m();
      for (const TrianglePacket& packet : packed.packets) {
        for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
          const int t = packet.exact[static_cast<std::size_t>(lane)].triangle;
          const TriangleCorners f = corners_of(s.world.part(0), t);
          WorstWall alone{std::nullopt, -s.world.tolerance_m()};
          if (!alone.offer_triangle(s.world, s.way, f, t, FirstApproach(approach_triangle(f, s.way.from_P))))
            continue;
          const auto is_kept = [&](const PartWalls& before, double worst_m) {
            const WorstWall worst{std::nullopt, worst_m};
            return (WaySieve(s.world, s.way, before, worst, packed.scale).lanes_left(packet) >> lane & 1) !=
                   0;
          };
          ++by_slack;
          ASSERT_TRUE(is_kept(s.before, alone.slack_m + hair_m)) << k << ", triangle " << t;
          ProxyWall wall;
          wall.normal = any(random).normalized();
          const double highest_m =
              std::max({wall.normal.dot(f.a), wall.normal.dot(f.b), wall.normal.dot(f.c)});
          wall.least_m = highest_m - hair_m - wall.normal.dot(s.way.from_P) + s.world.clearance_m() -
                         s.world.tolerance_m();
          const PartWalls before(s.world, 0, std::span(&wall, 1), s.way.from_P);
          if (before.hide(f)) continue;
          ++by_wall;
          ASSERT_TRUE(is_kept(before, -s.world.tolerance_m())) << k << ", triangle " << t;
        }
      }
    }
  }
  EXPECT_GT(by_slack, 10000);
  EXPECT_GT(by_wall, by_slack / 2);
}

TEST(WaySieve, PassesOverNoPacketThatTheWayGoesThrough) {
  const PlacedSurface surface = trial_surfaces().front();
  const PackedPart packed = pack(std::make_shared<const Part>(surface.tree->part()));
  const ProxyWorld world({surface}, 0.002, Normals::facet);
  for (const PacketDisc& disc : packed.discs) {
    const Vec3 centre_m = Vec3(disc.centre[0], disc.centre[1], disc.centre[2]) / packed.scale;
    for (const Vec3& half_m : {Vec3(0.001, 0, 0), Vec3(0, 0, -0.01)}) {
      const PartWay way(world, 0, centre_m - half_m, 2 * half_m);
      const PartWalls none(world, 0, {}, way.from_P);
      const WorstWall worst{std::nullopt, -world.tolerance_m()};
      ASSERT_FALSE(WaySieve(world, way, none, worst, packed.scale).passes_over(disc));
    }
  }
}

/// A way past a packet as no search makes it: of any length, from any place, with any walls.
RoughWay any_way(RandomStream& random, const TrianglePacket& packet) {
  const auto some = [&random](double size) { return static_cast<float>(size * random.normal()); };
  const double size = std::pow(10, -4 + 5 * random.uniform());
  RoughWay way{};
  for (std::size_t i = 0; i < 3; ++i) {
    way.start[i] = some(size);
    way.way[i] = some(size);
    for (RoughWay::Wall& wall : way.walls) wall.normal[i] = some(1);
  }
  for (RoughWay::Wall& wall : way.walls)
    wall.offset = some(static_cast<double>(packet.radius)) - packet.radius;
  way.length = std::hypot(way.way[0], way.way[1], way.way[2]);
  way.clearance = random.uniform() < 0.2 ? 0 : static_cast<float>(size * random.uniform());
  way.worst = static_cast<float>(-size * std::pow(10, -8 * random.uniform()));
  way.margin = way_margin * static_cast<float>(size);
  way.wall_count = static_cast<std::size_t>(4 * random.uniform());
  return way;
}

TEST(WayFilter, NamesTheSameLanesOnEveryMachine) {
  RandomStream random(34);
  long lanes = 0, all = 0;
  for (const PlacedSurface& surface : trial_surfaces()) {
    const PackedPart packed = pack(std::make_shared<const Part>(surface.tree->part()));
    for (int k = 0; k < 30; ++k) {
      for (const TrianglePacket& packet : packed.packets) {
        const RoughWay way = any_way(random, packet);
        const unsigned named = plain_way_filter()(packet, way);
        ASSERT_EQ(named, fastest_way_filter()(packet, way));
        lanes += std::popcount(named & packet.used);
        all += std::popcount(unsigned{packet.used});
      }
    }
  }
  EXPECT_GT(lanes, all / 50);
  EXPECT_LT(lanes, all / 2);
}

TEST(FacetSide, ClearsNoTriangleThatMatters) {
  RandomStream random(32);
  long cleared = 0, matter = 0;
  for (const PlacedSurface& surface : trial_surfaces()) {
    for (int k = 0; k < 300; ++k) {
      const Stand s(surface, random);
      for (int t = 0; t < s.world.part(0).triangle_count(); ++t) {
        const bool is_cleared = is_cleared_by_facet(s.world, s.way, corners_of(s.world.part(0), t), s.worst);
        const bool does_matter = s.matters(t);
        cleared += is_cleared ? 1 : 0;
        matter += does_matter ? 1 : 0;
        ASSERT_FALSE(is_cleared && does_matter) << k;
      }
    }
  }
  EXPECT_GT(matter, 1000);
  EXPECT_GT(cleared, 2 * matter);
}

TEST(SearchLimit, OfManyTellsNoMoreThanATrianglesDistance) {
  RandomStream random(33);
  struct Told {
    const TriangleTree* tree;
    const SearchLimit* limit;
    Vec3 q;
    long count = 0, close = 0;
  };
  for (const PlacedSurface& surface : trial_surfaces()) {
    Told told{surface.tree.get(), nullptr, {}, 0, 0};
    const auto hold = [](void* any_told, int t) {
      Told& to = *static_cast<Told*>(any_told);
      const double distance_m = approach_triangle(to.tree->part(), t, to.q).distance_m;
      EXPECT_LE(to.limit->at_least_m, distance_m);
      ++to.count;
      to.close += to.limit->at_least_m > distance_m - 1e-4 * to.tree->part().size_m() ? 1 : 0;
    };
    for (int k = 0; k < 100; ++k) {
      told.q = 0.03 * any(random);
      SearchLimit limit{1 << 20, 1 << 20};
      told.limit = &limit;
      const KeptPoint* none = nullptr;
      ASSERT_TRUE(surface.tree->each_within(told.q, 0.05 * random.uniform(), none, limit, hold, &told));
    }
    EXPECT_GT(told.count, 1000);
    EXPECT_GT(told.close, told.count - told.count / 100) << "and little less";
  }
}

}  // namespace
}  // namespace fingerpad::way_sieve_test
