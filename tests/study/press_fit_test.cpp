#include "study/press_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random_stream.hpp"

namespace fingerpad::press_fit_test {
namespace {

/// A trial that is pressed from `from_n` to `to_n`, of a pad that goes depth_m in at 1 N.
MeasuredTrial pressed(double from_n, double to_n, double depth_m, double exponent, double noise_m,
                      RandomStream& random) {
  MeasuredTrial trial;
  trial.rate_hz = 1000;
  constexpr int samples = 2000;
  for (int i = 0; i < samples; ++i) {
    const double load_n = from_n + (to_n - from_n) * i / samples;
    trial.normal_force_n.push_back(load_n);
    trial.height_m.push_back(0.01 - depth_m * std::pow(load_n, 1 / exponent) + noise_m * random.normal());
    trial.starts_anew.push_back(false);
  }
  return trial;
}

/// As `fit` settles it.
PressFit settled(const std::vector<MeasuredTrial>& measured, const std::vector<int>& subjects) {
  PressFit fit;
  double about = 0.5;
  for (int k = 0; k < 30; ++k) {
    std::vector<TrialEvidence> trials;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      trials.push_back(press_evidence(measured[i], about));
      trials.back().subject = subjects[i];
    }
    fit = fit_press(trials, std::vector<int>(trials.size(), 1), about);
    if (fit.exponent > 0) about = fit.exponent;
  }
  return fit;
}

TEST(PressFit, TrialsOfUnlikeStiffnessAtUnlikeLoadsHaveOneExponent) {
  for (const double exponent : {1.5, 2.0, 3.0}) {
    RandomStream random(3);
    std::vector<MeasuredTrial> trials;
    std::vector<int> subjects;
    for (int i = 0; i < 24; ++i) {
      const double from_n = i % 2 == 0 ? 0.2 : 0.5, to_n = i % 2 == 0 ? 0.6 : 3;
      const double depth_m = 1e-3 * (i % 2 == 0 ? 0.8 : 1.1);  // a soft finger presses more
      trials.push_back(pressed(from_n, to_n, depth_m, exponent, 2e-6, random));
      subjects.push_back(i % 3);
    }
    const PressFit fit = settled(trials, subjects);
    EXPECT_EQ(fit.refusal, "");
    EXPECT_NEAR(1 / fit.exponent, exponent, 0.01 * exponent);
    EXPECT_GT(fit.depth_at_1_n_m, 0.8e-3);
    EXPECT_LT(fit.depth_at_1_n_m, 1.1e-3);
  }
}

TEST(PressFit, OneTrialThatIsStifferLeavesTheOthersExponent) {
  RandomStream random(4);
  std::vector<MeasuredTrial> trials;
  for (int i = 0; i < 5; ++i)
    trials.push_back(pressed(0.3, 1 + 0.5 * i, i == 4 ? 0.7e-3 : 1e-3, 2, 2e-6, random));
  const PressFit fit = settled(trials, {1, 1, 1, 1, 1});
  EXPECT_EQ(fit.refusal, "");
  EXPECT_NEAR(1 / fit.exponent, 2, 0.02);
}

}  // namespace
}  // namespace fingerpad::press_fit_test
