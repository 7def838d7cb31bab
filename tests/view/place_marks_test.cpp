#include "view/place_marks.hpp"

#include <gtest/gtest.h>

namespace fingerpad::place_marks_test {
namespace {

struct Hit {
  Vec3 point_W;
};

TEST(PlaceMarks, TellAPlaceWithoutNegativeZerosAndTwoByTheirDistance) {
  PlaceMarks marks;
  EXPECT_EQ(marks.words(), "");
  EXPECT_TRUE(marks.mark(std::optional(Hit{{-0.0, 0.0125, -1e-9}})));
  EXPECT_EQ(marks.words(), "x 0.000, y 12.500, z 0.000 mm");
  marks.mark(std::optional(Hit{{0.003, 0.0125, -0.004}}));
  EXPECT_EQ(marks.words(), "5.000 mm");
}

}  // namespace
}  // namespace fingerpad::place_marks_test
