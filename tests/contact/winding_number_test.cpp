#include "contact/winding_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random_stream.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"

namespace fingerpad::winding_number_test {
namespace {

Vec3 random_in_box(const Part& part, double times, RandomStream& random) {
  const Vec3 share(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
  return times * share.cwiseProduct(part.half_extent);
}

TEST(WindingNumber, IsTheSumOverAllTriangles) {
  const TriangleSoup torus = test::torus_soup(1, 0.4, 200, 80);
  const TriangleSoup box = test::box_soup(Vec3(1, 2, 3));  // one packet sees more than half of all around
  for (const TriangleSoup& soup :
       {torus, test::reversed(torus), test::joined(torus, torus), test::sphere_soup(1, 6), box,
        test::reversed(box), test::sphere_soup(1, 0)}) {
    const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
    const PackedPart packed = pack(part);
    const WindingNumber winding(packed);
    RandomStream random(3);
    for (int k = 0; k < test::samples(300); ++k) {
      const Vec3 q = random_in_box(*part, k % 3 == 0 ? 3 : 1.05, random);
      const double expected = test::winding_number(*part, q);
      ASSERT_NEAR(winding.about(packed, q), expected, 0.05) << q.transpose();
      ASSERT_EQ(winding.encloses(packed, q), std::abs(expected) > 0.5);
    }
    EXPECT_LE(winding.memory_bytes(), 4096 + 9 * static_cast<std::size_t>(part->triangle_count()));
  }
}

// Half of each triangle's angle is a quarter turn, exactly: the sum of both ends where a round is counted or
// not.
TEST(WindingNumber, OfAnglesThatAddUpToHalfATurnCountsNoRoundTooMany) {
  for (const bool turned : {false, true}) {
    TriangleSoup soup;
    soup.vertices_P.resize(3, 6);
    soup.triangles.resize(3, 2);
    soup.vertices_P << 0, 1, -2, -1, 0, 1, 1, 0, -1, 0, 1, -2, 0, 0, 2, 0, 0, 2;
    for (int k = 0; k < 2; ++k) {
      soup.triangles.col(k) << 3 * k, 3 * k + (turned ? 2 : 1), 3 * k + (turned ? 1 : 2);
    }
    const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
    const PackedPart packed = pack(part);
    const Vec3 q = -part->centre_P;
    EXPECT_NEAR(std::abs(test::winding_number(*part, q)), 0.5, 1e-12);
    EXPECT_NEAR(WindingNumber(packed).about(packed, q), test::winding_number(*part, q), 1e-6);
  }
}

// A start inside pays for it out of a tick's looks, of which it took most where clusters four radii away were
// the nearest that counted as dipoles.
TEST(WindingNumber, OfMostPlacesARoughSumTellsWhetherTheyAreEnclosed) {
  const auto part = std::make_shared<const Part>(make_part(test::torus_soup(1, 0.25, 192, 96), 0.5));
  const PackedPart packed = pack(part);
  const WindingNumber winding(packed);
  RandomStream random(5);
  const int places = test::samples(200);
  int dear = 0;
  for (int k = 0; k < places; ++k) {
    const Vec3 q = random_in_box(*part, 1, random);
    WindingWalk walk;
    Looks looks(Looks::unlimited);
    const auto inside = winding.encloses(packed, q, walk, looks);
    ASSERT_EQ(inside, std::abs(test::winding_number(*part, q)) > 0.5);
    dear += looks.spent() > 3000 ? 1 : 0;
  }
  EXPECT_LE(dear, places / 20);
}

TEST(WindingNumber, FarOffItVanishes) {
  const auto part = std::make_shared<const Part>(make_part(test::sphere_soup(1, 4), 0.5));
  const PackedPart packed = pack(part);
  const WindingNumber winding(packed);
  for (const double far : {10.0, 1e6, 1e50}) EXPECT_NEAR(winding.about(packed, Vec3(far, far, 0)), 0, 1e-3);
}

TEST(WindingNumber, AnOpenBowlEnclosesWhereMoreThanHalfOfTheSightIsWall) {
  // A sphere without its cap: the border is where brute force has it, however flat the number is there.
  TriangleSoup bowl = test::sphere_soup(1, 5);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < bowl.triangles.cols(); ++t) {
    if (bowl.vertices_P(2, bowl.triangles(0, t)) < 0.3) bowl.triangles.col(kept++) = bowl.triangles.col(t);
  }
  bowl.triangles.conservativeResize(3, kept);
  const auto part = std::make_shared<const Part>(make_part(bowl, 0.5));
  const TriangleTree tree(part);
  RandomStream random(4);
  int inside = 0;
  for (int k = 0; k < test::samples(300); ++k) {
    const Vec3 q = random_in_box(*part, 1.2, random);
    const double expected = std::abs(test::winding_number(*part, q));
    if (std::abs(expected - 0.5) < 1e-9) continue;
    ASSERT_EQ(tree.encloses(q), expected > 0.5) << q.transpose() << ": " << expected;
    inside += expected > 0.5 ? 1 : 0;
  }
  EXPECT_GT(inside, test::samples(300) / 10);
}

TEST(WindingNumber, OfRealPartsIsTheSumOverAllTriangles) {
  const auto files = test::real_parts();
  if (files.empty()) GTEST_SKIP() << "no real parts beside the project";
  for (const auto& file : files) {
    const ImportedPart imported = import_part(file.string(), 1e-3, 0.5);
    if (!imported.part) continue;
    const PackedPart packed = pack(imported.part);
    const WindingNumber winding(packed);
    RandomStream random(5);
    for (int k = 0; k < test::samples(20); ++k) {
      const Vec3 q = random_in_box(*imported.part, 1.1, random);
      const double expected = test::winding_number(*imported.part, q);
      EXPECT_NEAR(winding.about(packed, q), expected, 0.05) << file << " " << q.transpose();
      EXPECT_EQ(winding.encloses(packed, q), std::abs(expected) > 0.5);
    }
  }
}

}  // namespace
}  // namespace fingerpad::winding_number_test
