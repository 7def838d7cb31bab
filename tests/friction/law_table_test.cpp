#include "friction/law_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/plane_contact.hpp"

namespace fingerpad::law_table_test {
namespace {

/// Others may stand among them.
TEST(LawTable, HoldsTheLawsOfTheContractInOrder) {
  const std::vector<std::string_view> wanted = {
      "none", "coulomb", "stick-slip",     "finger-pad",       "salisbury",     "salcudean-vlaar", "karnopp",
      "dahl", "lugre",   "elasto-plastic", "max-displacement", "friction-cone", "contact-area",    "kikuuwe"};
  std::vector<std::string_view> found;
  for (const LawEntry& entry : law_table()) {
    EXPECT_EQ(find_law(entry.name), &entry) << "two of a name";
    if (std::find(wanted.begin(), wanted.end(), entry.name) != wanted.end()) found.push_back(entry.name);
  }
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(find_law("no such law"), nullptr);
}

TEST(LawTable, EveryDefaultIsAllowed) {
  for (const LawEntry& entry : law_table()) {
    for (const LawParameter& parameter : entry.parameters) {
      EXPECT_EQ(refusal(parameter, parameter.default_value), "") << entry.name << ": " << parameter.key;
      EXPECT_FALSE(parameter.meaning.empty());
    }
  }
}

TEST(LawTable, AKeyMeansTheSameInEveryLaw) {
  for (const LawEntry& one : law_table()) {
    for (const LawEntry& other : law_table()) {
      for (const LawParameter& a : one.parameters) {
        for (const LawParameter& b : other.parameters) {
          if (a.key != b.key) continue;
          EXPECT_EQ(a.meaning, b.meaning) << a.key;
        }
      }
    }
  }
}

TEST(LawTable, SaysOfTheLawsThatHoldNoFingerBackThatTheyDoNot) {
  for (const LawEntry& entry : law_table()) {
    const auto law = entry.make({});
    test::PlaneContact contact{*law, test::pressed(1, 1000)};
    double most_n = 0;
    for (int k = 0; k < 1000; ++k) most_n = std::max(most_n, contact.move_to({1e-4 * k, 0}).force_n.norm());
    EXPECT_EQ(most_n > 0, entry.rubs) << entry.name;
  }
}

TEST(LawTable, RefusesWhatAParameterCannotBe) {
  const LawParameter parameter{"x", 1, 0, false, "", 2};
  EXPECT_EQ(refusal(parameter, 1), "");
  EXPECT_EQ(refusal(parameter, 0), "must be larger than 0");
  EXPECT_EQ(refusal(parameter, -1), "must be at least 0");
  EXPECT_EQ(refusal(parameter, 3), "must be at most 2");
  EXPECT_EQ(refusal(parameter, std::nan("")), "must be a finite number");
}

}  // namespace
}  // namespace fingerpad::law_table_test
