#include "study/press_fit.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <map>

namespace fingerpad {

PressFit fit_press(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, double about) {
  // Height that the force does not explain says nothing of the pad: the hand moves, or the plate is not
  // square.
  constexpr double least_explained = 0.5, least_rms_m = 5e-5;
  PressFit fit;
  std::map<int, Mat3> subjects;
  double height2 = 0, explained = 0, groups = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (times[i] == 0 || trials[i].press_samples == 0) continue;
    const auto [place, is_new] = subjects.try_emplace(trials[i].subject, Mat3::Zero());
    place->second += times[i] * trials[i].press;
    fit.samples += times[i] * trials[i].press_samples;
    fit.trials += times[i];
    groups += static_cast<double>(times[i] * trials[i].press_groups);
  }
  for (const auto& [subject, m] : subjects) {
    const Eigen::Matrix2d normal = m.bottomRightCorner<2, 2>();
    const Vec2 right = m.bottomLeftCorner<2, 1>();
    const Vec2 found = normal.ldlt().solve(right);
    height2 += m(0, 0);
    explained += found.dot(right);
    if (!(found[0] > 0)) continue;
    fit.depth_at_1_n_m += found[0] / static_cast<double>(subjects.size());
    fit.exponent += (about + found[1] / found[0]) / static_cast<double>(subjects.size());
  }
  if (subjects.empty() || !(height2 > least_rms_m * least_rms_m * groups)) {
    fit.refusal = "the finger does not move along the plate's normal: no depth is measured";
  } else if (!(explained > least_explained * height2) || !(fit.depth_at_1_n_m > 0) || !(fit.exponent > 0)) {
    fit.refusal = "the finger's height does not follow the normal force";
  }
  return fit;
}

}  // namespace fingerpad
