// What a run comes to, from records made by hand.
#include "replay/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "replay/residual_warnings.hpp"

namespace fingerpad::figures_test {
namespace {

TickRecord slipping(double normal_force_n, double mu) {
  TickRecord record;
  record.phase = Phase::slip;
  record.contact_W = record.normal_W = Vec3::UnitZ();
  record.normal_force_n = normal_force_n;
  record.mu = mu;
  return record;
}

TEST(Figures, MeanSlipMuIsOfPressedSlipAndNoNumberWithoutIt) {
  Figures figures;
  figures.observe(TickRecord());
  figures.observe(slipping(0, 0));  // as where a measured force is below 0
  EXPECT_TRUE(std::isnan(Figures::of(figures.values(), "mean_slip_mu")));
  figures.observe(slipping(1, 0.25));
  figures.observe(slipping(2, 0.35));
  TickRecord stuck = slipping(1, 0.9);
  stuck.phase = Phase::stick;
  figures.observe(stuck);
  EXPECT_DOUBLE_EQ(Figures::of(figures.values(), "mean_slip_mu"), 0.3);
  EXPECT_EQ(Figures::of(figures.values(), "slip_ticks"), 3);
}

// A finger that spins faster than it goes is pushed on by friction, which takes energy from its turning all
// the same: 1 N on an arm of 8 mm against 0.5 rad, and 1 mm with it.
TEST(Figures, WorkOfFrictionIsThatOfATurningToo) {
  Figures figures;
  TickRecord record = slipping(1, 1);
  record.friction_W_n = record.force_W_n = Vec3(1, 0, 0);
  record.torque_W_n_m = Vec3(0, -8e-3, 0);
  figures.observe(record);
  record.p_WQ = Vec3(1e-3, 0, 0);
  record.turn_W = Vec3(0, 0.5, 0);
  record.friction_W_n = record.force_W_n = Vec3(-7, 0, 0);  // is held after this tick, and not yet
  figures.observe(record);
  EXPECT_DOUBLE_EQ(Figures::of(figures.values(), "friction_work_j"), 1e-3 - 4e-3);
  EXPECT_EQ(Figures::of(figures.values(), "energy_made_j"), 0);
}

/// A rub's force of two frequencies, which is not the same at any two shifts below a second.
Vec3 force_at(double t_s) {
  return {0.3 * std::sin(2 * M_PI * 2 * t_s), 0.2 * std::sin(2 * M_PI * 3 * t_s), 1 + 0.1 * std::cos(t_s)};
}

/// @param late_s  of the measured force, which is weaker than the model's and off by `off_n`
ResidualFigures compared(double late_s, const Vec3& off_n = Vec3::Zero(), double rate_hz = 1000,
                         double free_s = 0) {
  ResidualFigures figures;
  for (int k = 0; k < 2 * rate_hz; ++k) {
    TickRecord record;
    record.t_s = 100 + k / rate_hz;
    const bool touches = record.t_s >= 100 + free_s;
    record.phase = touches ? Phase::slip : Phase::free;
    if (touches) record.force_W_n = force_at(record.t_s);
    Vec3 measured_n = off_n;
    if (touches) measured_n += 0.8 * force_at(record.t_s - late_s);
    record.residual_W_n = record.force_W_n - measured_n;
    figures.observe(record);
  }
  return figures;
}

TEST(ResidualFigures, TellHowLateTheMeasuredForceIs) {
  for (const double late_s : {0.0125, -0.0062, 0.031}) {
    EXPECT_NEAR(compared(late_s).lag_s(), late_s, 2e-4) << "to a fifth of a step";
    EXPECT_NEAR(compared(late_s, Vec3(0.5, 0, 2)).lag_s(), late_s, 2e-4) << "whatever the sensor's zero";
    EXPECT_NEAR(compared(late_s, Vec3::Zero(), 5000).lag_s(), late_s, 2e-4) << "steps are of a millisecond";
    EXPECT_NEAR(compared(late_s, Vec3::Zero(), 250).lag_s(), late_s, 8e-4) << "or a tick";
  }
  EXPECT_EQ(compared(0).lag_s(), 0);
  EXPECT_TRUE(std::isnan(compared(0.08).lag_s())) << "more than is looked for";
  EXPECT_TRUE(std::isnan(ResidualFigures().lag_s()));
}

TEST(ResidualFigures, OfAQuickRubTellTheNearerOfTwoShiftsThatFitAlike) {
  for (const double late_s : {-0.005, 0.005}) {
    ResidualFigures figures;
    for (int k = 0; k < 2000; ++k) {
      const auto force_n = [](double t_s) { return Vec3(0.3 * std::sin(2 * M_PI * 25 * t_s), 0, 1); };
      TickRecord record;
      record.t_s = k / 1000.0;
      record.phase = Phase::slip;
      record.force_W_n = force_n(record.t_s);
      record.residual_W_n = record.force_W_n - force_n(record.t_s - late_s);
      figures.observe(record);
    }
    EXPECT_NEAR(figures.lag_s(), late_s, 2e-4) << "not a period of 40 ms on";
  }
}

TEST(ResidualFigures, TellASensorThatWasNotTared) {
  const Vec3 off_n(0.1, 0, -0.2);
  EXPECT_NEAR(compared(0, off_n, 1000, 0.5).bias_n(), off_n.norm(), 1e-12);
  EXPECT_EQ(compared(0, Vec3::Zero(), 1000, 0.5).bias_n(), 0)
      << "a model that is too strong is no such sensor";
  EXPECT_NEAR(compared(0, off_n).bias_n(), (0.2 * Vec3(0, 0, 1.05) - off_n).norm(), 0.02) << "never free";
  EXPECT_TRUE(std::isnan(ResidualFigures().bias_n()));
}

}  // namespace
}  // namespace fingerpad::figures_test
