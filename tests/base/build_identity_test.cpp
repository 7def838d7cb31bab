#include "base/build_identity.hpp"

#include <gtest/gtest.h>

namespace fingerpad::build_identity_test {
namespace {

TEST(BuildIdentity, IsThatOfTheProgramAndStays) {
  const std::string id = build_identity();
  EXPECT_GE(id.size(), 16u) << "linked without a build id";
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(build_identity(), id);
}

}  // namespace
}  // namespace fingerpad::build_identity_test
