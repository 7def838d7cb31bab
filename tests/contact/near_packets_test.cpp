#include "contact/near_packets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random_stream.hpp"
#include "part/import.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::near_packets_test {
namespace {

using Near = WindingNumber::NearPackets;

struct Packets {
  std::shared_ptr<const Part> part;
  PackedPart packed = pack(part);
  WindingNumber winding{packed};

  explicit Packets(const TriangleSoup& soup) : part(std::make_shared<const Part>(make_part(soup, 0.5))) {}

  std::vector<std::size_t> all() const {
    std::vector<std::size_t> every(packed.packets.size());
    std::iota(every.begin(), every.end(), std::size_t{0});
    return every;
  }
  Vec3 random_scaled(RandomStream& random) const {
    const Vec3 share(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    return 1.2 * packed.scale * share.cwiseProduct(part->half_extent);
  }
  /// Whether a corner of a packet's triangles comes within a radius of a segment. All scaled.
  bool is_corner_near(std::size_t packet, const Vec3& at, const Vec3& half, double radius) const {
    for (const TrianglePacket::Exact& exact : packed.packets[packet].exact) {
      for (const std::int32_t vertex : exact.vertex) {
        const Vec3 off = packed.scale * part->vertices.col(vertex) - at;
        const double length2 = half.squaredNorm();
        const double share = length2 > 0 ? std::clamp(off.dot(half) / length2, -1.0, 1.0) : 0;
        if ((off - share * half).norm() <= radius) return true;
      }
    }
    return false;
  }
};

std::vector<std::size_t> rest_of(Near near) {
  std::vector<std::size_t> found;
  for (std::size_t packet = 0; near.next(packet);) found.push_back(packet);
  return found;
}

TEST(NearPackets, MissNoneThatIsNear) {
  for (const TriangleSoup& soup : {test::torus_soup(1, 0.4, 200, 80), test::box_soup(Vec3(1, 2, 3))}) {
    const Packets packets(soup);
    RandomStream random(5);
    std::size_t near_point = 0, near_way = 0, near_box = 0;
    for (int k = 0; k < test::samples(300); ++k) {
      const Vec3 at = packets.random_scaled(random), half = 0.5 * packets.random_scaled(random);
      const double radius = std::pow(10.0, -3 * random.uniform());
      const auto about_point = rest_of(Near(packets.winding, at, radius));
      const auto about_way = rest_of(Near(packets.winding, at, radius, half, Near::About::way));
      const auto about_box = rest_of(Near(packets.winding, at, radius, half.cwiseAbs()));
      for (std::size_t packet = 0; packet < packets.packed.packets.size(); ++packet) {
        const auto is_in = [packet](const std::vector<std::size_t>& found) {
          return std::binary_search(found.begin(), found.end(), packet);
        };
        ASSERT_TRUE(is_in(about_point) || !packets.is_corner_near(packet, at, Vec3::Zero(), radius));
        ASSERT_TRUE(is_in(about_way) || !packets.is_corner_near(packet, at, half, radius));
      }
      ASSERT_TRUE(std::includes(about_box.begin(), about_box.end(), about_way.begin(), about_way.end()));
      near_point += about_point.size();
      near_way += about_way.size();
      near_box += about_box.size();
    }
    EXPECT_GT(near_point, 0U);
    // A box has too few packets to leave any out.
    if (packets.packed.packets.size() > 2) {
      EXPECT_LT(4 * near_way, 3 * near_box);
    }
  }
}

TEST(NearPackets, GoOnFromAnyOfThem) {
  const Packets packets(test::torus_soup(1, 0.4, 200, 80));
  RandomStream random(6);
  for (int k = 0; k < test::samples(100); ++k) {
    const Vec3 at = packets.random_scaled(random), half = 0.2 * packets.random_scaled(random);
    const auto all = rest_of(Near(packets.winding, at, 0.1, half, Near::About::way));
    for (std::size_t from = 0; from <= packets.packed.packets.size() + 20; from += 7) {
      const auto rest = rest_of(Near(packets.winding, at, 0.1, half, Near::About::way, from));
      const auto first = std::lower_bound(all.begin(), all.end(), from);
      ASSERT_TRUE(std::equal(first, all.end(), rest.begin(), rest.end())) << from;
    }
  }
}

TEST(NearPackets, LookAtNoClusterTwice) {
  const Packets packets(test::torus_soup(1, 0.4, 200, 80));
  Near near(packets.winding, Vec3::Zero(), 10);
  for (std::size_t packet = 0; near.next(packet);) {
  }
  const auto count = static_cast<long>(packets.packed.packets.size());
  // Fours of packets, of fours, and so on: a third of the packets, and a rest a level.
  EXPECT_LE(near.tests(), count / 3 + 10);
  // Along a way each is held against its box and against the way.
  Near beside(packets.winding, Vec3::Zero(), 10, Vec3(0.1, 0, 0), Near::About::way);
  for (std::size_t packet = 0; beside.next(packet);) {
  }
  EXPECT_LE(beside.tests(), 2 * (count / 3 + 10));
}

TEST(NearPackets, PassOverWhatAShrunkBallHasLeft) {
  const Packets packets(test::torus_soup(1, 0.4, 200, 80));
  const Vec3 at = packets.packed.scale * Vec3(packets.part->vertices.col(0));
  const auto count = [&](double then) {
    Near near(packets.winding, at, 10);
    std::size_t next = 0;
    long found = 0;
    while (near.next(next)) {
      near.shrink(then);
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count(10), static_cast<long>(packets.packed.packets.size()));
  EXPECT_LT(count(0.1), static_cast<long>(packets.packed.packets.size()) / 4);
}

TEST(NearPackets, FarOffAllCount) {
  const Packets packets(test::torus_soup(1, 0.4, 200, 80));
  const Vec3 far(1e200, 0, 0);
  EXPECT_EQ(rest_of(Near(packets.winding, far, 1e200)), packets.all());
  EXPECT_EQ(rest_of(Near(packets.winding, far, 1e200, 0.1 * far, Near::About::way)), packets.all());
  EXPECT_EQ(rest_of(Near(packets.winding, Vec3::Zero(), 1, far, Near::About::way)), packets.all());
  Near shrunk(packets.winding, far, 1e200);
  shrunk.shrink(1);
  EXPECT_EQ(rest_of(shrunk), packets.all());
}

}  // namespace
}  // namespace fingerpad::near_packets_test
