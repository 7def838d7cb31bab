#include "study/pulled_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/effort.hpp"

namespace fingerpad::pulled_block_test {
namespace {

constexpr double rate_hz = 10000;
constexpr double tooth_n = 1;  // F_s - F_d

/// The cycle of a block whose stick is rigid, stepped through in time: an oracle that shares no formula with
/// rigid_cycle.
StickSlipCycle integrated_cycle(const PulledBlock& block) {
  const double h = 1e-6, stretch_m = block.static_n() / block.spring_n_per_m;
  double x = 0, v = 0, t = 0;
  const auto acceleration = [&](double x_, double v_, double t_) {
    const double pull = block.spring_n_per_m * (stretch_m + block.speed_m_per_s * t_ - x_);
    return (pull - block.dynamic_n() - block.damping_n_s_per_m * v_) / block.mass_kg;
  };
  do {  // midpoint rule: at this step its error is far below every tolerance here
    const double xm = x + h / 2 * v, vm = v + h / 2 * acceleration(x, v, t);
    v += h * acceleration(xm, vm, t + h / 2);
    x += h * vm;
    t += h;
  } while (v > 0);
  const double pull = block.spring_n_per_m * (stretch_m + block.speed_m_per_s * t - x);
  const double stuck_s = (block.static_n() - pull) / (block.spring_n_per_m * block.speed_m_per_s);
  return {t + stuck_s, block.static_n(), pull, 1};
}

StickSlipCycle measured(const std::string& law) {
  const PulledBlock block = block_for({}, law);
  return cycle_of(pull_of_block(block, law, block_settings(law), rate_hz, 45), rate_hz, tooth_n);
}

TEST(PulledBlock, ClosedFormMeetsTheTextbookAndTheIntegrator) {
  const PulledBlock undamped{.damping_n_s_per_m = 0, .speed_m_per_s = 0.05};
  // SCIENCE 3, to the digits given there; the fall to 2 F_d - F_s is exact.
  EXPECT_NEAR(rigid_cycle(undamped).period_s, 2.80086, 5e-6);
  EXPECT_NEAR(rigid_cycle(undamped).least_n, 2 * undamped.dynamic_n() - undamped.static_n(), 1e-9);
  for (const PulledBlock& block : {undamped, PulledBlock{}}) {
    // The integrator stops up to one step late, while the pull moves slowly: 1e-6 s and microns of it.
    EXPECT_NEAR(rigid_cycle(block).period_s, integrated_cycle(block).period_s, 1e-5);
    EXPECT_NEAR(rigid_cycle(block).least_n, integrated_cycle(block).least_n, 1e-5);
  }
}

TEST(PulledBlock, ThePapersStickSlipMeetsTheRigidOracle) {
  const double period_s = integrated_cycle({}).period_s;
  for (const char* law : {"stick-slip", "finger-pad"}) {
    // SCIENCE 3: within 0.3 % at k_f = 500 1/m and 10 kHz; 0.5 % is what the issue asks.
    EXPECT_NEAR(measured(law).period_s, period_s, 0.005 * period_s) << law;
  }
}

TEST(PulledBlock, EveryLawWithAStaticLimitMeetsItsOracle) {
  // friction-cone and contact-area: the same spring, entered at F_d (contact-area's mu is raised to hold at
  // 10 N). lugre and elasto-plastic creep in the bristle before they yield and so break early: by up to 47 %
  // at a bristle of 5000 N/m, by 1 % at the 5e5 N/m taken here. salcudean-vlaar's slip is a damper, not
  // Coulomb's force: its oracle is the block with F_d = 0 and that damper beside its own.
  std::vector<const char*> laws = {"stick-slip", "finger-pad",     "friction-cone",  "contact-area",
                                   "lugre",      "elasto-plastic", "salcudean-vlaar"};
  if (test::samples(10) == 1) laws = {"finger-pad", "lugre"};  // a minute of ticks each
  for (const char* law : laws) {
    const StickSlipCycle expected = reference_cycle({}, law);
    const StickSlipCycle found = measured(law);
    ASSERT_GT(found.cycles, 1) << law;
    EXPECT_NEAR(found.period_s, expected.period_s, 0.03 * expected.period_s) << law;
    EXPECT_NEAR(found.peak_n, expected.peak_n, 0.03 * expected.peak_n) << law;
  }
}

TEST(PulledBlock, KarnoppHoldsASpeedNotAPlaceAndSoBreaksEarly) {
  // In its band the force answers the push in full: what speed is left (up to 0.001 m/s) stays, the block
  // creeps on and leaves the band long before F_s. Its first tooth, entered from true rest, is the oracle's.
  const std::vector<double> pull = pull_of_block({}, "karnopp", block_settings("karnopp"), rate_hz, 14);
  const StickSlipCycle expected = rigid_cycle({});
  const auto first_peak = std::max_element(pull.begin(), pull.begin() + 80000);
  EXPECT_NEAR(*first_peak, expected.peak_n, 0.03 * expected.peak_n);
  const auto first_fall = std::min_element(first_peak, pull.begin() + 90000);
  EXPECT_NEAR(*first_fall, expected.least_n, 0.03 * expected.least_n);
  const double second_peak = *std::max_element(first_fall, pull.end());
  EXPECT_LT(second_peak, 0.9 * expected.peak_n);
}

TEST(PulledBlock, SalisburysSawtoothDragsAtTheMeanOfItsLimits) {
  // It re-sticks at every jump, so it has no Coulomb slip: teeth of 0.2 mm at any speed, whose mean force the
  // block follows. The pull settles at (F_s + F_d)/2 + b V, here within a tooth's ripple.
  const PulledBlock block;
  const std::vector<double> pull =
      pull_of_block(block, "salisbury", block_settings("salisbury"), rate_hz, 45);
  double sum = 0;
  const std::size_t last = 100000;
  for (std::size_t k = pull.size() - last; k < pull.size(); ++k) sum += pull[k];
  const double mean_n =
      (block.static_n() + block.dynamic_n()) / 2 + block.damping_n_s_per_m * block.speed_m_per_s;
  EXPECT_NEAR(sum / static_cast<double>(last), mean_n, 0.01 * mean_n);
  EXPECT_EQ(measured("salisbury").cycles, 0);
}

TEST(PulledBlock, ThePapersUndampedStickRingsAndBreaksAtTheSlidingForce) {
  // Entered at F_d while the pull has fallen to 2 F_d - F_s, the stick's spring rings by F_s - F_d about the
  // pull and passes F_s when the pull is F_d, whatever its stiffness. The pull still rises until the block is
  // as fast as the pulling end, by V sqrt(k m) = 0.22 N at most.
  const PulledBlock undamped{.damping_n_s_per_m = 0, .speed_m_per_s = 0.05};
  const double rise_n = undamped.speed_m_per_s * std::sqrt(undamped.spring_n_per_m * undamped.mass_kg);
  for (const double stiffness_per_m : {50.0, 100.0, 200.0}) {
    LawSettings settings = block_settings("stick-slip");
    settings.numbers["stick_stiffness_per_m"] = stiffness_per_m;
    const double fast_hz = 40000;  // a held spring without any damper gains energy: less of it at short ticks
    const std::vector<double> pull = pull_of_block(undamped, "stick-slip", settings, fast_hz, 12);
    const auto first_end = pull.begin() + static_cast<long>(4.3 * fast_hz);
    EXPECT_NEAR(*std::max_element(pull.begin(), first_end), undamped.static_n(), 0.05);  // at rest before
    const double second_peak = *std::max_element(first_end, pull.end());
    EXPECT_GT(second_peak, undamped.dynamic_n()) << stiffness_per_m;
    EXPECT_LT(second_peak, undamped.dynamic_n() + 1.05 * rise_n) << stiffness_per_m;
  }
}

}  // namespace
}  // namespace fingerpad::pulled_block_test
