#include "contact/packet_tangents.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <limits>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/proxy_sweep.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"

// What rough half spaces tell of triangles, against what is told exactly.

namespace fingerpad::packet_tangents_test {
namespace {

constexpr double scale = 0.5;
constexpr float infinite = std::numeric_limits<float>::infinity();

Vec3 any_in(RandomStream& random, double half) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * half);
}

/// Triangles within a ball of about this size, some of them slender, the last without area.
Part eight_near(RandomStream& random, double size_m) {
  Points vertices(3, 3 * packet_width);
  IndexTriples triangles(3, packet_width);
  const Vec3 middle = any_in(random, 0.5);
  for (int t = 0; t < packet_width; ++t) {
    const Vec3 a = middle + any_in(random, size_m), ab = any_in(random, size_m);
    const double width = t % 2 == 0 ? std::pow(10.0, -7 * random.uniform()) : 1;
    vertices.col(3 * t) = a;
    vertices.col(3 * t + 1) = a + ab;
    vertices.col(3 * t + 2) =
        t == 7 ? Vec3(a + ab / 2) : Vec3(a + random.uniform() * ab + any_in(random, width * size_m));
    triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  Part part = test::bare_part(vertices, triangles);
  part.half_extent = Vec3::Ones();
  part.facet_normals.resize(3, packet_width);
  for (int t = 0; t < packet_width; ++t) {
    const Vec3 a = vertices.col(3 * t), ab = vertices.col(3 * t + 1) - a, ac = vertices.col(3 * t + 2) - a;
    part.facet_normals.col(t) = t == 7 ? Vec3::UnitZ().eval() : Vec3(ab.cross(ac).stableNormalized());
  }
  return part;
}

TrianglePacket packet_of(const Part& part) {
  const std::int32_t all[] = {0, 1, 2, 3, 4, 5, 6, 7};
  return make_packet(part, all, scale);
}

struct Relative {
  float r[3];
  Relative(const TrianglePacket& packet, const Vec3& q_m) {
    for (int i = 0; i < 3; ++i) r[i] = static_cast<float>(scale * q_m[i] - packet.origin[i]);
  }
};

float margin_at(const TrianglePacket& packet, const float* r) {
  return rough_margin * (std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2]) + 2 * packet.radius) + 1e-13F;
}

double outside(const PacketTangents& tangents, std::size_t lane, const float* r) {
  double sum = -static_cast<double>(tangents.level[lane]);
  for (std::size_t i = 0; i < 3; ++i)
    sum += static_cast<double>(r[i]) * static_cast<double>(tangents.towards[i][lane]);
  return sum;
}

double distance_to(const Part& part, int t, const Vec3& q) {
  double distance_m = 0;
  test::brute_closest_on(part.vertices.col(3 * t), part.vertices.col(3 * t + 1), part.vertices.col(3 * t + 2),
                         q, &distance_m);
  return scale * distance_m;
}

TEST(PacketTangents, NoTriangleReachesOutOfItsHalfSpaceAndFromWhereItWasMadeItTellsTheDistance) {
  RandomStream random(1);
  double nearest = 1, loosest = 0;
  for (int i = 0; i < test::samples(4000); ++i) {
    const double size_m = std::pow(10.0, -4 * random.uniform());
    const Part part = eight_near(random, 0.3 * size_m);
    const TrianglePacket packet = packet_of(part);
    const Vec3 middle = packet.origin / scale;
    const Vec3 from = i % 4 == 0 ? Vec3(part.vertices.col(i % 24)) : Vec3(middle + any_in(random, size_m));
    const Relative here(packet, from);
    PacketTangents plain = no_tangents(), fast = no_tangents();
    plain_tangent_maker()(packet, here.r, plain);
    fastest_tangent_maker()(packet, here.r, fast);
    ASSERT_EQ(plain.level, fast.level);
    ASSERT_EQ(plain.towards, fast.towards);
    for (int t = 0; t < packet_width; ++t) {
      if ((packet.always_exact >> t & 1) != 0) continue;
      const auto lane = static_cast<std::size_t>(t);
      const double margin = static_cast<double>(margin_at(packet, here.r));
      const double told = outside(plain, lane, here.r), distance = distance_to(part, t, from);
      ASSERT_LE(told, distance + margin);
      // A way that is known well is known to be as long.
      if (distance > 1000 * margin) {
        loosest = std::max(loosest, (distance - told) / margin);
      }
      for (int j = 0; j < 6; ++j) {
        const Vec3 q = from + any_in(random, size_m);
        const Relative there(packet, q);
        const double slack = distance_to(part, t, q) - outside(plain, lane, there.r);
        ASSERT_GE(slack, -static_cast<double>(margin_at(packet, there.r)));
        nearest = std::min(nearest, slack);
      }
    }
  }
  EXPECT_LT(nearest, 1e-3) << "places before the closest point were among them";
  EXPECT_LT(loosest, 1);
}

struct Way {
  Vec3 from, to;
  double clearance_m;
};

WayPastPacket past(const TrianglePacket& packet, const Way& way, double slack_m) {
  const Relative from(packet, way.from), to(packet, way.to);
  WayPastPacket past;
  for (int i = 0; i < 3; ++i) {
    past.from[i] = from.r[i];
    past.to[i] = to.r[i];
  }
  past.margin = margin_at(packet, from.r) + margin_at(packet, to.r);
  const float length = static_cast<float>(scale * (way.to - way.from).norm());
  past.touched = static_cast<float>(scale * way.clearance_m * (1 + 1e-6)) + past.margin;
  past.ends = static_cast<float>(scale * (way.clearance_m + slack_m)) + 1.001F * past.margin;
  past.begins = past.ends + length * (1 + 1e-6F);
  past.turn = 8 * past.margin * length;
  return past;
}

/// How the filters told of all triangles that a way was swept past exactly.
struct Told {
  int blocking = 0, swept_away = 0, left = 0, unseen = 0;
};

void compare(const Part& part, const TrianglePacket& packet, const Way& way, double slack_m, Told& sum) {
  const WayPastPacket rough = past(packet, way, slack_m);
  PacketTangents tangents = no_tangents();
  alignas(32) TrianglePacket::Lanes ends, plain_ends;
  WayPastPacket unmade = rough;
  unmade.ends = infinite;
  ASSERT_EQ(fastest_way_filter()(tangents, unmade, ends), 255U) << "nothing is known yet";
  fastest_tangent_maker()(packet, rough.from, tangents);
  const unsigned may = fastest_way_filter()(tangents, rough, ends);
  ASSERT_EQ(may, plain_way_filter()(tangents, rough, plain_ends));
  const unsigned swept = fastest_sweep_filter()(packet, tangents, rough, ends);
  ASSERT_EQ(swept, plain_sweep_filter()(packet, tangents, rough, plain_ends));
  ASSERT_EQ(ends, plain_ends);
  ASSERT_EQ(swept & ~may, 0U);
  for (int t = 0; t < packet_width; ++t) {
    if ((packet.always_exact >> t & 1) != 0) continue;
    const TriangleSweep exact =
        sweep_past_triangle(corners_of(part, t), way.from, way.to, way.clearance_m, 1e-9);
    const bool blocks = exact.blocked && exact.end_slack_m < slack_m;
    const bool is_left = (swept >> t & 1) != 0;
    ASSERT_TRUE(is_left || !blocks) << "slack " << exact.end_slack_m << " of " << slack_m;
    if (blocks) {
      ASSERT_LE(ends[static_cast<std::size_t>(t)],
                scale * (way.clearance_m + exact.end_slack_m) + 1.01 * static_cast<double>(rough.margin));
    }
    sum.blocking += blocks ? 1 : 0;
    sum.swept_away += (may & ~swept) >> t & 1;
    sum.left += is_left ? 1 : 0;
    sum.unseen += is_left ? 0 : 1;
  }
}

TEST(PacketTangents, WhatBlocksAWayMostIsLeft) {
  RandomStream random(2);
  Told sum;
  for (int i = 0; i < test::samples(6000); ++i) {
    const double size_m = std::pow(10.0, -3 * random.uniform());
    const Part part = eight_near(random, 0.2 * size_m);
    const TrianglePacket packet = packet_of(part);
    Way way;
    way.from = packet.origin / scale + any_in(random, size_m);
    way.to = packet.origin / scale + any_in(random, size_m);
    double nearest_m = infinite;
    for (int t = 0; t < packet_width; ++t)
      nearest_m = std::min(nearest_m, distance_to(part, t, way.from) / scale);
    // Free where it begins: far from all, or touching the nearest.
    way.clearance_m = i % 3 == 0 ? 0 : i % 3 == 1 ? nearest_m : random.uniform() * nearest_m;
    compare(part, packet, way, i % 2 == 0 ? -1e-9 : -0.1 * size_m * random.uniform(), sum);
  }
  EXPECT_GT(sum.blocking, test::samples(6000));
  EXPECT_GT(sum.swept_away, test::samples(1000));
  EXPECT_GT(sum.unseen, sum.left) << "speed is what they are for";
}

TEST(PacketTangents, WhatReachesNoFartherThanALimitReachesNoFartherThanThat) {
  RandomStream random(3);
  int within = 0, beyond = 0;
  for (int i = 0; i < test::samples(4000); ++i) {
    const Part part = eight_near(random, 0.1);
    const TrianglePacket packet = packet_of(part);
    const Vec3 along = any_in(random, 1).normalized();
    const float rough[3] = {static_cast<float>(along.x()), static_cast<float>(along.y()),
                            static_cast<float>(along.z())};
    const float limit = static_cast<float>(0.1 * (2 * random.uniform() - 1));
    const unsigned lanes = fastest_reach_filter()(packet, rough, limit);
    ASSERT_EQ(lanes, plain_reach_filter()(packet, rough, limit));
    for (int t = 0; t < packet_width; ++t) {
      double reach = -1;
      for (int k = 0; k < 3; ++k)
        reach = std::max(reach, along.dot(scale * part.vertices.col(3 * t + k) - packet.origin));
      const double margin = static_cast<double>(2 * rough_margin * packet.radius) + 1e-13;
      const bool is_within = (lanes >> t & 1) != 0;
      if (is_within) {
        ASSERT_LE(reach, static_cast<double>(limit) + margin);
        ASSERT_EQ(packet.always_exact >> t & 1, 0);
      } else if ((packet.always_exact >> t & 1) == 0) {
        ASSERT_GE(reach, static_cast<double>(limit) - margin);
      }
      within += is_within ? 1 : 0;
      beyond += is_within ? 0 : 1;
    }
  }
  EXPECT_GT(within, test::samples(1000));
  EXPECT_GT(beyond, test::samples(1000));
}

}  // namespace
}  // namespace fingerpad::packet_tangents_test
