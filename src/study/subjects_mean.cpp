#include "study/subjects_mean.hpp"

#include <map>
#include <utility>

namespace fingerpad {

PadValue subjects_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                       EvidenceSum sum, EvidenceCount count, double enough, const std::string& refusal) {
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const long here = times[i] * trials[i].*count;
    if (here == 0) continue;
    auto& [total, weight] = subjects[trials[i].subject];
    const auto count_here = static_cast<double>(trials[i].*count);
    const double own = times[i] * count_here / (count_here + enough);
    total += own * trials[i].*sum / count_here;
    weight += own;
    found.samples += here;
    found.trials += times[i];
  }
  for (const auto& [subject, mean] : subjects)
    found.value += mean.first / mean.second / static_cast<double>(subjects.size());
  if (subjects.empty()) found.refusal = refusal;
  return found;
}

PadValue slip_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  constexpr double enough_samples = 500;
  return subjects_mean(trials, times, &TrialEvidence::slip_ratio, &TrialEvidence::slip_samples,
                       enough_samples, "no slip was found");
}

}  // namespace fingerpad
