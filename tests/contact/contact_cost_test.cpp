#include "contact/contact_cost.hpp"

#include <gtest/gtest.h>

#include "contact/contact_method_table.hpp"

namespace fingerpad::contact_cost_test {
namespace {

TEST(ContactCost, IsKnownOfAllThatAutoMayTakeAndOfNothingElse) {
  for (const ContactMethodEntry& method : contact_method_table()) {
    for (const Normals normals : normals_table()) {
      for (const bool has_radius : {false, true}) {
        const auto cost = contact_cost(method.name, normals->name, 5000, has_radius);
        ASSERT_TRUE(cost.has_value()) << method.name << " " << normals->name;
        EXPECT_GT(*cost, 0);
        EXPECT_LT(*cost, 100);
      }
    }
  }
  EXPECT_FALSE(contact_cost("brute-force", "facet", 5000, false));
  EXPECT_FALSE(contact_cost("proxy", "exact", 5000, false));
}

TEST(ContactCost, GoesStraightBetweenTheCountsOfItsTable) {
  const auto at = [](int count) { return *contact_cost("closest-point", "facet", count, false); };
  EXPECT_EQ(at(1024), 1) << "the unit";
  EXPECT_EQ(at(1), at(256));
  EXPECT_EQ(at(100000000), at(1048576));
  EXPECT_NEAR(at(8192), (at(4096) + at(16384)) / 2, 1e-12) << "half way in logarithms";
  EXPECT_GT(at(1048576), at(256));
}

}  // namespace
}  // namespace fingerpad::contact_cost_test
