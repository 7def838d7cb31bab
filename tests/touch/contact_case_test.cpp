#include "touch/contact_case.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"

namespace fingerpad::contact_case_test {
namespace {

struct OneCase {
  PartMeasures measures;
  std::vector<ContactCase> cases{{"part.stl", {measures}, {}, 0.1, 0.05, 0.01}};

  OneCase() { cases[0].contact.force_tolerance = 0.03; }
  OneCase(const OneCase&) = delete;
  OneCase& operator=(const OneCase&) = delete;
};

/// With the same error under each force.
ContactPair pair_of(Normals normals, double force_share, double mean_tilt_rad = 0) {
  ReckonedError error;
  error.force_share = force_share;
  error.force_shares.fill(force_share);
  error.mean_tilts_rad.fill(mean_tilt_rad);
  return {&contact_method_table().back(), normals, 1, {error}, {""}};
}

TEST(ContactPair, MissesByWhatIsReckonedAndTellsNoMoreThanCouldBeKept) {
  const OneCase one;
  const std::vector<ContactCase>& cases = one.cases;
  EXPECT_NEAR(pair_of(Normals::curved, 0.06).misses(cases), 2, 1e-12);
  EXPECT_NEAR(pair_of(Normals::curved, 0.06).told_misses(cases), 2, 1e-12);
  EXPECT_NEAR(pair_of(Normals::curved, 1.5).misses(cases), 50, 1e-12);
  EXPECT_NEAR(pair_of(Normals::curved, 1.5).told_misses(cases), 1 / 0.09, 1e-12) << "a third of the force";
  EXPECT_NEAR(pair_of(Normals::curved, 0, 1).misses(cases), 100, 1e-12);
  EXPECT_NEAR(pair_of(Normals::curved, 0, 1).told_misses(cases), 20, 1e-12)
      << "an error of mu as large as mu";
  EXPECT_EQ(pair_of(Normals::curved, 0.01).misses(cases), 1) << "it is kept";
}

TEST(ContactPair, GetsNotRoundOnFacetsThatItFallsBehindOn) {
  const OneCase one;
  const std::vector<ContactCase>& cases = one.cases;
  for (const auto& [normals, behind_share, gets_round] :
       {std::tuple(Normals::facet, 0.5, false), {Normals::facet, 0.02, true}, {Normals::curved, 0.5, true}}) {
    ContactPair pair = pair_of(normals, 1);
    pair.errors[0].behind_share = behind_share;
    EXPECT_EQ(pair.gets_round(cases), gets_round) << behind_share;
  }
}

}  // namespace
}  // namespace fingerpad::contact_case_test
