#include "part/unit_hint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fingerpad::unit_hint_test {
namespace {

std::string hint(double length_m, double metres_per_unit, const std::string& format = "binary STL") {
  Verdict verdict;
  verdict.touchable = true;
  verdict.format = format;
  verdict.bounds_m.max = Vec3(length_m / 2, length_m, length_m / 3);
  return unit_hint(verdict, metres_per_unit);
}

TEST(UnitHint, NamesMetresForAScanThatIsAGrainOfSandInMillimetres) {
  EXPECT_EQ(hint(0.3e-3, 1e-3), "is 0.3 mm long; --unit m (in a scene: unit = \"m\") reads it as 300 mm");
}

TEST(UnitHint, NamesMillimetresForAPartAsLongAsAStreet) {
  EXPECT_THAT(hint(120, 1), testing::HasSubstr("is 120 m long; --unit mm"));
}

TEST(UnitHint, NamesMicrometresForAPartAsLongAsATown) {
  EXPECT_THAT(hint(300, 1e-3),
              testing::HasSubstr("--unit um (in a scene: unit = \"um\") reads it as 300 mm"));
}

/// Of a part that was drawn about a metre long.
TEST(UnitHint, NamesMetresForAMillimetre) {
  EXPECT_EQ(hint(1.00158e-3, 1e-3), "is 1 mm long; --unit m (in a scene: unit = \"m\") reads it as 1 m");
}

TEST(UnitHint, LeavesUsualSizesAlone) {
  for (const double length_m : {2e-3, 0.02, 0.3, 4.6, 20.0}) EXPECT_EQ(hint(length_m, 1e-3), "") << length_m;
  EXPECT_EQ(hint(0.3e-3, 1e-3, "STEP"), "") << "knows its own";
  EXPECT_EQ(hint(1e-9, 1e-3), "") << "no unit makes that a part";
}

}  // namespace
}  // namespace fingerpad::unit_hint_test
