#include "contact/packet_filter.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/packed_part.hpp"
#include "contact/packet_grouping.hpp"
#include "contact/triangle_tree.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::packet_filter_test {
namespace {

Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

/// Eight triangles in a box of half side 1: of any size and shape, needles, caps, and some without area.
Part eight_triangles(RandomStream& random) {
  Points vertices(3, 3 * packet_width);
  IndexTriples triangles(3, packet_width);
  const double spread = std::pow(10.0, -12 * random.uniform());
  const Vec3 middle = random_point(random, 1 - spread);
  for (int t = 0; t < packet_width; ++t) {
    const double size = spread * std::pow(10.0, -6 * random.uniform());
    const Vec3 a = middle + random_point(random, spread - size), ab = random_point(random, size / 2);
    const double width = std::pow(10.0, (t % 2 == 0 ? -8 : -1) * random.uniform());
    const double along = t % 3 == 0 ? 0 : t % 3 == 1 ? 1 : random.uniform();
    vertices.col(3 * t) = a;
    vertices.col(3 * t + 1) = a + ab;
    vertices.col(3 * t + 2) =
        t == 7 ? Vec3(a + ab / 2) : Vec3(a + ab * along + random_point(random, width * size / 2));
    triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  Part part = test::bare_part(vertices, triangles);
  part.half_extent = Vec3::Ones();
  return part;
}

/// In the box; near the packet; on a vertex, on an edge and on a face, exactly and almost.
Vec3 near_packet(const Part& part, const TrianglePacket& packet, RandomStream& random, int i) {
  const int t = static_cast<int>(random.uniform() * packet_width);
  const Vec3 a = part.vertices.col(3 * t), b = part.vertices.col(3 * t + 1), c = part.vertices.col(3 * t + 2);
  const Vec3 off = random_point(random, packet.radius * std::pow(10.0, -12 * random.uniform()));
  switch (i % 6) {
    case 0:
      return random_point(random, 1);
    case 1:
      return packet.origin / 0.5 + random_point(random, 4.0 * packet.radius);
    case 2:
      return a;
    case 3:
      return a + random.uniform() * (b - a) + off;
    case 4:
      return c + off;
    default:
      return a + 0.3 * (b - a) + 0.3 * (c - a) + off;
  }
}

TEST(PacketFilter, IsOffByNoMoreThanItsMargin) {
  RandomStream random(1);
  double worst = 0;
  long without_frame = 0;
  for (int i = 0; i < test::samples(20000); ++i) {
    const Part part = eight_triangles(random);
    constexpr double scale = 0.5;
    const std::int32_t all[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const TrianglePacket packet = make_packet(part, all, scale);
    without_frame += std::popcount(packet.always_exact);
    for (int j = 0; j < 12; ++j) {
      const Vec3 q = near_packet(part, packet, random, j), r = q * scale - packet.origin;
      const float rough_r[3] = {static_cast<float>(r.x()), static_cast<float>(r.y()),
                                static_cast<float>(r.z())};
      RoughDistances plain, fast;
      plain_packet_filter()(packet, rough_r, 1, plain);
      fastest_packet_filter()(packet, rough_r, 1, fast);
      ASSERT_EQ(plain.squared, fast.squared);
      for (int t = 0; t < packet_width; ++t) {
        if ((packet.always_exact >> t & 1) != 0) {
          ASSERT_GT(plain.squared[t], 1e30f);
          continue;
        }
        const double rough = std::sqrt(static_cast<double>(plain.squared[t]));
        double truth_m = 0;
        test::brute_closest_on(part.vertices.col(3 * t), part.vertices.col(3 * t + 1),
                               part.vertices.col(3 * t + 2), q, &truth_m);
        const double margin =
            rough_margin * (r.norm() + 2.0 * packet.radius) + 1e-14 * (1 + q.norm() * scale);
        worst = std::max(worst, std::abs(rough - truth_m * scale) / margin);
        ASSERT_LE(std::abs(rough - truth_m * scale), margin) << "triangle " << t << " at " << q.transpose();
      }
    }
  }
  // The margin is a bound, not a guess; were it never approached, the test would look in the wrong places.
  EXPECT_GT(worst, 0.02);
  EXPECT_GT(without_frame, test::samples(20000));  // those without area, and slivers
}

TEST(PacketFilter, ComparesWithItsLimit) {
  RandomStream random(2);
  const Part part = eight_triangles(random);
  const std::int32_t five[] = {0, 1, 2, 3, 4};
  const TrianglePacket packet = make_packet(part, five, 0.5);
  EXPECT_EQ(packet.used, 0b11111);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 r = random_point(random, 2.0 * packet.radius);
    const float rough_r[3] = {static_cast<float>(r.x()), static_cast<float>(r.y()),
                              static_cast<float>(r.z())};
    RoughDistances rough;
    const float limit2 = packet.radius * packet.radius * static_cast<float>(random.uniform());
    const unsigned within = fastest_packet_filter()(packet, rough_r, limit2, rough);
    for (int t = 0; t < packet_width; ++t) ASSERT_EQ(within >> t & 1, rough.squared[t] <= limit2 ? 1 : 0);
  }
}

/// A strip of thin triangles, bent or flat, that share edges and vertices.
Part strip(int count, double width, double bend) {
  Points vertices(3, count + 2);
  IndexTriples triangles(3, count);
  for (int i = 0; i < count + 2; ++i) {
    const double x = 2.0 * i / (count + 1) - 1;
    vertices.col(i) << x, (i % 2 == 0 ? -1 : 1) * width, bend * x * x;
  }
  for (int t = 0; t < count; ++t) triangles.col(t) << t, t + 1 + t % 2, t + 2 - t % 2;
  return test::bare_part(vertices, triangles);
}

/// A disc as the filter takes it, but that its centre is not rounded.
struct Disc {
  Vec3 centre;
  Eigen::Vector3f across;
  float radius, thick;

  double distance(const Vec3& q) const {
    const Vec3 normal = across.cast<double>();
    const double height = normal.dot(q - centre) / normal.norm();
    const double beside = (q - centre - height * normal.normalized()).norm() - static_cast<double>(radius);
    const double above = std::abs(height) - static_cast<double>(thick) / normal.norm();
    return Vec3(std::max(0.0, above), std::max(0.0, beside), 0).norm();
  }
};

TEST(DiscFilter, NamesTheDiscsWithinALimit) {
  RandomStream random(3);
  long within = 0, beyond = 0;
  for (int i = 0; i < test::samples(5000); ++i) {
    const double size = std::pow(10.0, -4 * random.uniform());
    std::array<PacketDiscs, 8> discs;
    std::array<Disc, 64> disc;
    double spread = 0;
    for (std::size_t k = 0; k < 64; ++k) {
      disc[k] = {random_point(random, size), random_point(random, 1).normalized().cast<float>(),
                 static_cast<float>(size * random.uniform()),
                 static_cast<float>(size * std::pow(10.0, -5 * random.uniform()))};
      for (int axis = 0; axis < 3; ++axis) {
        discs[k / 8].centre[axis][k % 8] = static_cast<float>(disc[k].centre[axis]);
        discs[k / 8].across[axis][k % 8] = disc[k].across[axis];
      }
      discs[k / 8].radius[k % 8] = disc[k].radius;
      discs[k / 8].thick[k % 8] = disc[k].thick;
      spread = std::max(spread, disc[k].centre.cwiseAbs().sum() + static_cast<double>(disc[k].radius));
    }
    const Vec3 q = random_point(random, 1.5 * size);
    const float point[3] = {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())};
    const int groups = 1 + i % 8;
    const auto all = static_cast<float>(spread + q.cwiseAbs().sum());
    // The limit is one disc's own distance.
    const double reach = disc[static_cast<std::size_t>(i % 64)].distance(q);
    const float limit = static_cast<float>(reach) + disc_margin * all, lost2 = disc_margin * all * all;
    const std::uint64_t named = fastest_disc_filter()(discs.data(), groups, point, limit, lost2);
    ASSERT_EQ(named, plain_disc_filter()(discs.data(), groups, point, limit, lost2));
    for (std::size_t k = 0; k < 64; ++k) {
      const bool asked = static_cast<int>(k) < 8 * groups, is_named = (named >> k & 1) != 0;
      if (asked && disc[k].distance(q) <= reach) {
        ASSERT_TRUE(is_named) << "disc " << k;
        ++within;
      }
      // The square of the way along the plane is off by lost2: its root by some 2e-3 at most.
      if (!asked || disc[k].distance(q) > reach + 3e-3 * static_cast<double>(all)) {
        ASSERT_FALSE(is_named) << "disc " << k;
        ++beyond;
      }
    }
  }
  EXPECT_GT(within, test::samples(5000));
  EXPECT_GT(beyond, test::samples(5000));
}

TEST(TrianglePacket, IsNoNearerThanItsDiscs) {
  RandomStream random(4);
  int nearly_met = 0, nearer_disc = 0;
  for (int i = 0; i < test::samples(5000); ++i) {
    const Part part = i % 2 == 0 ? eight_triangles(random) : strip(8, 0.01, 0.1 * random.uniform());
    constexpr double scale = 0.5;
    const std::int32_t all[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const TrianglePacket packet = make_packet(part, all, scale);
    const Vec3 q =
        packet.origin + random_point(random, packet.radius * std::pow(10.0, 2 - 4 * random.uniform()));
    double truth_m = std::numeric_limits<double>::infinity();
    for (int t = 0; t < packet_width; ++t) {
      double here_m = 0;
      const auto corner = [&](int k) { return Vec3(part.vertices.col(part.triangles(k, t))); };
      test::brute_closest_on(corner(0), corner(1), corner(2), q / scale, &here_m);
      truth_m = std::min(truth_m, here_m);
    }
    // A few roundings of the lengths in it.
    ASSERT_LE(packet.least_distance(q), truth_m * scale + 1e-14);
    nearly_met += packet.least_distance(q) > 0.9 * truth_m * scale ? 1 : 0;
    // Its own, in float, is the tighter one where the packet is more than a float's rounding wide.
    const PacketDisc disc = disc_around(part, packet, scale);
    ASSERT_LE(disc.least_distance(q), truth_m * scale + 1e-14);
    if (packet.radius > 1e-3F)
      nearer_disc += disc.least_distance(q) < packet.least_distance(q) - 1e-5 * packet.radius ? 1 : 0;
  }
  EXPECT_GT(nearly_met, test::samples(1500));
  EXPECT_LT(nearer_disc, test::samples(1500));
}

TEST(PackedPart, HoldsEachTriangleOnceInFullPackets) {
  for (const TriangleSoup& soup :
       {test::torus_soup(1, 0.4, 100, 63), test::square_soup(1, 70), test::box_soup({1, 2, 3})}) {
    const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
    const PackedPart packed = pack(part);
    std::set<int> seen;
    for (std::size_t i = 0; i < packed.packets.size(); ++i) {
      const TrianglePacket& packet = packed.packets[i];
      if (i + 1 < packed.packets.size()) {
        ASSERT_EQ(packet.used, 0xff);
      }
      for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
        const int t = packet.exact[static_cast<std::size_t>(lane)].triangle;
        ASSERT_TRUE(seen.insert(t).second);
        ASSERT_EQ(packed.packet_of(t), i);
        ASSERT_EQ(packed.lane_of(t), lane);
        ASSERT_EQ(lane_order(packet, lane), corner_order(*part, t));
        for (const Vec3& corner : exact_frame(*part, packet, lane).corner) {
          ASSERT_LE((corner * packed.scale - packet.origin).norm(), packet.radius);
        }
      }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(part->triangle_count()));
  }
}

TEST(PackedPart, IsTheSameEachTime) {
  const Part part = make_part(test::torus_soup(1, 0.4, 200, 150), 0.5);
  EXPECT_EQ(packet_order(part), packet_order(part));
}

TEST(PackedPart, TrianglesInOnePlaceAreGroupedToo) {
  constexpr int count = 3000;  // the heuristic has nothing to go by
  IndexTriples triangles(3, count);
  for (int t = 0; t < count; ++t) triangles.col(t) << 0, 1, 2;
  const TriangleTree tree(std::make_shared<const Part>(test::bare_part(Points::Identity(3, 3), triangles)));
  EXPECT_EQ(tree.closest({1, 1, 1}, -1, 10).triangle, 0);
  EXPECT_EQ(tree.closest({1, 1, 1}, count - 1, 10).triangle, 0);
}

TEST(TriangleTree, TakesNoMoreThan160BytesATriangle) {
  const auto part = std::make_shared<const Part>(make_part(test::torus_soup(1, 0.4, 400, 150), 0.5));
  const double bytes = static_cast<double>(TriangleTree(part).memory_bytes()) / part->triangle_count();
  RecordProperty("bytes_a_triangle", std::to_string(bytes));
  EXPECT_GT(bytes, 128);  // the packets alone: Embree's share must be in it
  EXPECT_LE(bytes, 160);
}

TEST(TriangleTree, IsExactOnAMillionAdversaries) {
  RandomStream random(3);
  long queries = 0;
  for (const double width : {1.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
    for (const double bend : {0.0, 1e-9, 0.5}) {
      const auto part = std::make_shared<const Part>(strip(60, width, bend));
      const TriangleTree tree(part);
      std::vector<TriangleFrame> frames;
      for (int t = 0; t < part->triangle_count(); ++t) frames.push_back(triangle_frame(*part, t));
      int seed = -1;
      for (int i = 0; i < test::samples(67000); ++i) {
        const int v = static_cast<int>(random.uniform() * (part->vertices.cols() - 1));
        const Vec3 a = part->vertices.col(v), b = part->vertices.col(v + 1);
        const double away = std::pow(10.0, -14 * random.uniform());
        Vec3 q = i % 4 == 0 ? a : Vec3(a + random.uniform() * (b - a));
        if (i % 3 != 0) q += random_point(random, away);
        if (i % 7 == 0) q.z() += away;
        const ClosestTriangle found = tree.closest(q, seed, std::numeric_limits<double>::infinity());
        ClosestTriangle best;
        const double tie_m = tie_distance_m(*part, q);
        for (int t = 0; t < part->triangle_count(); ++t) {
          const FramePoint p = closest_in(frames[static_cast<std::size_t>(t)], q, tie_m);
          if (best.triangle < 0 || p.distance2_m2 < best.at.distance2_m2) {
            best.triangle = t;
            best.at.distance2_m2 = p.distance2_m2;
          }
        }
        ASSERT_EQ(found.triangle, best.triangle) << width << " " << bend << " " << q.transpose();
        ASSERT_EQ(found.at.distance2_m2, best.at.distance2_m2);
        seed = found.triangle;
        ++queries;
      }
    }
  }
  EXPECT_GE(queries, test::samples(1000000));
}

}  // namespace
}  // namespace fingerpad::packet_filter_test
