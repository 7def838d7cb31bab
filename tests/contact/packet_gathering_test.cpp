#include "contact/packet_gathering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/packed_part.hpp"
#include "contact/tree_trials.hpp"
#include "support/effort.hpp"

namespace fingerpad::packet_gathering_test {
namespace {

using test::samples;

/// Packets of a part drawn by chance, and a piece of way near one of them.
struct Trial {
  PathPiece way;
  PacketGathering gathering;

  Trial(const PackedPart& packed, RandomStream& random) {
    gathering.count = 1 + static_cast<std::size_t>(random.uniform() * (PacketGathering::most - 1));
    for (std::size_t i = 0; i < gathering.count; ++i)
      gathering.packet[i] =
          static_cast<std::uint32_t>(random.uniform() * static_cast<double>(packed.packets.size()));
    const Vec3 at = packed.packets[gathering.packet[0]].origin;
    way.middle = at + test::random_point(random, std::pow(10.0, -4 * random.uniform()));
    way.half = random.uniform() < 0.1 ? Vec3(Vec3::Zero())
                                      : test::random_point(random, std::pow(10.0, -4 * random.uniform()));
  }
};

/// From the nearest of some places of a way, scaled.
double distance(const PackedPart& packed, std::uint32_t index, const PathPiece& way) {
  const TrianglePacket& packet = packed.packets[index];
  double least2 = std::numeric_limits<double>::infinity();
  for (int place = -4; place <= 4; ++place) {
    const Vec3 q = (way.middle + place / 4.0 * way.half) / packed.scale;
    for (std::size_t lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane)
      least2 =
          std::min(least2, closest_on_triangle(*packed.part, packet.exact[lane].triangle, q).distance2_m2);
  }
  return std::sqrt(least2) * packed.scale;
}

TEST(PacketGathering, MeasuresNoPacketFartherOffThanItIs) {
  RandomStream random(21);
  for (const auto& part : {test::torus(60, 40), test::torus(64, 8, 1e-4), test::soup_of_slivers(1000)}) {
    const PackedPart packed = pack(part);
    int tight = 0;
    for (int trial = 0; trial < samples(200); ++trial) {
      Trial t(packed, random);
      plain_disc_measure()(packed.discs.data(), t.way, t.gathering);
      for (std::size_t i = 0; i < t.gathering.count; ++i) {
        const double true_distance = distance(packed, t.gathering.packet[i], t.way),
                     told = std::sqrt(t.gathering.distance2[i]);
        // Roundings of lengths near 1.
        ASSERT_LE(told, true_distance + 1e-14) << trial;
        tight += told > 0.5 * true_distance ? 1 : 0;
      }
    }
    EXPECT_GT(tight, samples(4000));
  }
}

TEST(PacketGathering, IsMeasuredAlikeOnEveryMachine) {
  RandomStream random(22);
  const PackedPart packed = pack(test::torus(60, 40));
  for (int trial = 0; trial < samples(500); ++trial) {
    Trial plain(packed, random), fast = plain;
    plain_disc_measure()(packed.discs.data(), plain.way, plain.gathering);
    fastest_disc_measure()(packed.discs.data(), fast.way, fast.gathering);
    ASSERT_EQ(std::memcmp(plain.gathering.distance2.data(), fast.gathering.distance2.data(),
                          plain.gathering.count * sizeof(double)),
              0);
  }
}

TEST(PacketGathering, LeavesNothingNearerOutOfAList) {
  RandomStream random(23);
  const PackedPart packed = pack(test::torus(60, 40));
  int full = 0;
  for (int trial = 0; trial < samples(500); ++trial) {
    Trial t(packed, random);
    plain_disc_measure()(packed.discs.data(), t.way, t.gathering);
    const PacketGathering all = t.gathering;
    const Vec3 anchor = t.way.middle.cast<float>().cast<double>();
    const double within = random.uniform();
    PacketList list;
    const double clear = put_into(list, packed.discs.data(), anchor, within, t.gathering);
    ASSERT_LE(clear, within);
    full += clear < within ? 1 : 0;
    const std::uint32_t *begin = list.packet.data(), *end = begin + list.count;
    for (std::size_t i = 0; i < all.count; ++i) {
      const std::uint32_t* at = std::find(begin, end, all.packet[i]);
      // But for the rounding of a root.
      ASSERT_TRUE(at != end || all.distance2[i] >= clear * clear * (1 - 1e-15)) << trial;
      if (at == end) continue;
      const auto place = static_cast<std::size_t>(at - begin);
      const PacketDisc& disc = packed.discs[*at];
      const PacketDiscs& discs = list.discs[place / packet_width];
      const std::size_t lane = place % packet_width;
      float reaches = disc.radius + disc.thick;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const float centre = static_cast<float>(static_cast<double>(disc.centre[k]) - anchor[axis]);
        ASSERT_EQ(discs.centre[k][lane], centre);
        ASSERT_EQ(discs.across[k][lane], disc.across[k]);
        reaches += std::abs(centre);
      }
      ASSERT_EQ(discs.radius[lane], disc.radius);
      ASSERT_EQ(discs.thick[lane], disc.thick);
      ASSERT_LE(reaches, list.spread * (1 + 1e-6F));
    }
  }
  EXPECT_GT(full, samples(20));
}

}  // namespace
}  // namespace fingerpad::packet_gathering_test
