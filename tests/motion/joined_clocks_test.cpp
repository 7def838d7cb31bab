#include "motion/joined_clocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"

namespace fingerpad::joined_clocks_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// x(t) = 0.01 sin(7 t) along the first row, 2 t along the second.
ClockedValues recorded(const std::string& what, double from_s, double to_s, double rate_hz) {
  ClockedValues values{what, {}, {}};
  for (long i = 0; from_s + static_cast<double>(i) / rate_hz <= to_s; ++i)
    values.t_s.push_back(from_s + static_cast<double>(i) / rate_hz);
  values.values.resize(2, static_cast<Eigen::Index>(values.t_s.size()));
  for (std::size_t i = 0; i < values.t_s.size(); ++i) {
    values.values.col(static_cast<Eigen::Index>(i)) << 0.01 * std::sin(7 * values.t_s[i]), 2 * values.t_s[i];
  }
  return values;
}

TEST(JoinedClocks, TakesTheSlowerAtTheTimesOfTheQuickerInEitherOrder) {
  const ClockedValues slow = recorded("positions", 0.0003, 1.0, 100),
                      quick = recorded("forces", 0, 1.2, 6000);
  for (const bool slow_first : {true, false}) {
    const JoinedClocks joined = slow_first ? join_clocks(slow, quick, "a") : join_clocks(quick, slow, "a");
    const Eigen::MatrixXd &positions = slow_first ? joined.first : joined.second,
                          &forces = slow_first ? joined.second : joined.first;
    ASSERT_GT(joined.t_s.size(), 5900u);
    EXPECT_GE(joined.t_s.front(), slow.t_s.front());
    EXPECT_LE(joined.t_s.back(), slow.t_s.back());
    for (std::size_t i = 0; i < joined.t_s.size(); ++i) {
      const double t_s = joined.t_s[i];
      const auto column = static_cast<Eigen::Index>(i);
      EXPECT_EQ(forces(1, column), 2 * t_s);
      EXPECT_NEAR(positions(1, column), 2 * t_s, 1e-12);  // straight
      // The chord of a curve is off by at most h^2/8 of its curvature.
      EXPECT_NEAR(positions(0, column), 0.01 * std::sin(7 * t_s), 0.01 * 49 * 1e-4 / 8 * 1.01);
    }
    EXPECT_THAT(joined.note, AllOf(HasSubstr("positions, about 100 Hz"), HasSubstr("forces, about 6000 Hz")));
  }
}

TEST(JoinedClocks, LeavesOutWhatTheSlowerHasNotRecorded) {
  ClockedValues slow = recorded("positions", 0, 1, 100);
  const ClockedValues quick = recorded("forces", 0, 1, 1000);
  // Thirty samples are lost, those after 0.3 s up to 0.6 s.
  ClockedValues gappy{"positions", {}, Eigen::MatrixXd(2, 0)};
  for (std::size_t i = 0; i < slow.t_s.size(); ++i) {
    if (slow.t_s[i] > 0.3001 && slow.t_s[i] < 0.6001) continue;
    gappy.t_s.push_back(slow.t_s[i]);
    gappy.values.conservativeResize(Eigen::NoChange, gappy.values.cols() + 1);
    gappy.values.rightCols(1) = slow.values.col(static_cast<Eigen::Index>(i));
  }
  const JoinedClocks joined = join_clocks(gappy, quick, "a");
  for (const double t_s : joined.t_s) EXPECT_FALSE(t_s > 0.3001 && t_s < 0.6099) << t_s;
  EXPECT_THAT(joined.note, HasSubstr("in gaps of theirs"));
  EXPECT_LT(joined.t_s.size(), quick.t_s.size() - 300);
}

TEST(JoinedClocks, RefusesClocksThatCannotBeJoined) {
  const ClockedValues one = recorded("positions", 0, 1, 100), later = recorded("forces", 5, 6, 1000);
  EXPECT_THAT(test::why_not([&] { join_clocks(one, later, "a.csv"); }),
              AllOf(HasSubstr("a.csv"), HasSubstr("no time in common"), HasSubstr("positions from 0 to")));
  ClockedValues back = one;
  back.t_s[5] = back.t_s[4];
  EXPECT_THAT(test::why_not([&] { join_clocks(back, one, "a.csv"); }), HasSubstr("does not come after"));
  ClockedValues lone{"forces", {0}, Eigen::MatrixXd::Zero(1, 1)};
  EXPECT_THAT(test::why_not([&] { join_clocks(one, lone, "a.csv"); }),
              HasSubstr("the forces have 1 samples"));
}

}  // namespace
}  // namespace fingerpad::joined_clocks_test
