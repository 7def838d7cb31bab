#include "study/silent_subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace fingerpad {

void tell_silent_subjects(const Measurement& measurement, ProfileFit& fit) {
  struct Teeth {
    std::string first_trial;
    long ruptures = 0, too_short = 0;
  };
  std::map<int, Teeth> subjects;
  for (std::size_t i = 0; i < fit.evidence.size(); ++i) {
    Teeth& teeth = subjects[fit.evidence[i].subject];
    if (teeth.first_trial.empty()) teeth.first_trial = measurement.trials[i].name;
    teeth.ruptures += fit.evidence[i].ruptures;
    teeth.too_short += fit.evidence[i].short_teeth;
  }
  const auto heard = std::count_if(subjects.begin(), subjects.end(),
                                   [](const auto& subject) { return subject.second.ruptures > 0; });
  if (heard == 0) return;  // then mu_static is refused, with the reason
  for (const auto& [number, teeth] : subjects) {
    if (teeth.ruptures > 0) continue;
    fit.steps.push_back(fmt::format(
        "mu_static and the stick axes are those of {} of {} subjects: of {}'s no rupture tells where it "
        "gave way{}: rub slower, or sample faster",
        heard, subjects.size(), teeth.first_trial,
        teeth.too_short > 0 ? fmt::format(" ({} teeth have too few samples)", teeth.too_short) : ""));
  }
}

}  // namespace fingerpad
