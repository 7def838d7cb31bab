#include "base/nearest_word.hpp"

#include <gtest/gtest.h>

namespace fingerpad::nearest_word_test {
namespace {

const std::vector<std::string> words{"law",        "closest-point", "proxy",
                                     "finger-pad", "stick-slip",    "stick-pad"};

TEST(NearestWord, CountsSwappedLettersAsOneMistake) {
  EXPECT_EQ(nearest_word("lwa", words), "law");
  EXPECT_EQ(nearest_word("lw", words), "law");
  EXPECT_EQ(nearest_word("wal", words), "") << "no neighbours are swapped";
  EXPECT_EQ(nearest_word("rpoxy", words), "proxy");
  EXPECT_EQ(nearest_word("PROXY", words), "") << "five letters of the other case count as two and a half";
}

TEST(NearestWord, KnowsAWordByItsPart) {
  EXPECT_EQ(nearest_word("point", words), "closest-point");
  EXPECT_EQ(nearest_word("slip", words), "stick-slip");
  EXPECT_EQ(nearest_word("pad", words), "") << "two words have it";
  EXPECT_EQ(nearest_word("poin", words), "") << "no whole part";
  EXPECT_EQ(nearest_word("", words), "");
}

TEST(NearestWord, KnowsAQuantityWithoutItsUnit) {
  const std::vector<std::string> columns{"t_s", "nx", "fn_n", "fx_n", "ffx_n", "rfx_n", "mu", "hx_n", "hx_m"};
  EXPECT_EQ(nearest_word("fx", columns), "fx_n") << "not nx, which is one letter away";
  EXPECT_EQ(nearest_word("t", columns), "t_s");
  EXPECT_EQ(nearest_word("fn", columns), "fn_n");
  EXPECT_NE(nearest_word("hx", columns), "hx_n") << "two go on so";
}

TEST(NearestWord, NamesBothUnitsOfAQuantity) {
  const std::vector<std::string> keys{"law", "stick_stiffness_per_m", "stick_stiffness_n_per_m"};
  EXPECT_EQ(near_miss_hint("stick_stiffness", keys),
            "; did you mean 'stick_stiffness_per_m' or 'stick_stiffness_n_per_m'?");
}

TEST(NearestWord, KnowsAQuantityByItsNameWithAUnit) {
  const std::vector<std::string> headers{"t", "x", "y", "fx", "fx_raw"};
  EXPECT_EQ(nearest_word("x_m", headers), "x");
  EXPECT_EQ(nearest_word("t_s", headers), "t");
  EXPECT_EQ(nearest_word("z_m", headers), "");
}

TEST(NearestWord, KnowsAMisspeltQuantityWithoutItsUnit) {
  const std::vector<std::string> keys{"point_m", "stiffness_n_per_m", "damping_n_s_per_m", "mu_static",
                                      "mu_dynamic"};
  EXPECT_EQ(nearest_word("stifness", keys), "stiffness_n_per_m");
  EXPECT_EQ(nearest_word("dampng", keys), "damping_n_s_per_m");
  EXPECT_EQ(nearest_word("stifness", {"stiffness_n_per_m", "stiffness_per_m"}), "") << "two are as near";
  EXPECT_EQ(nearest_word("nonsense", keys), "");
}

TEST(NearestWord, KnowsAWordByItsStart) {
  EXPECT_EQ(nearest_word("closes", words), "closest-point");
  EXPECT_EQ(nearest_word("stick-p", words), "stick-pad");
  EXPECT_EQ(nearest_word("sti", words), "") << "two begin so";
  EXPECT_EQ(nearest_word("frict", {"friction", "friction.law", "finger"}), "friction") << "and what is in it";
  EXPECT_EQ(nearest_word("fr", {"friction"}), "") << "too little";
}

}  // namespace
}  // namespace fingerpad::nearest_word_test
