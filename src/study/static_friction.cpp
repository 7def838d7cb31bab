#include "study/static_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/number_text.hpp"
#include "study/subjects_mean.hpp"

namespace fingerpad {
namespace {

/// Sums over one subject's trials.
struct SubjectFriction {
  double ruptures = 0, their_slip = 0, pairs = 0;  ///< by ruptures, of trials that tell slip too

  void add(const TrialEvidence& trial, int times) {
    if (times == 0 || trial.ruptures == 0 || !trial.tells_slip()) return;
    const auto count = static_cast<double>(trial.ruptures);
    const double weight = times * count / (count + enough_ruptures);
    ruptures += weight * trial.rupture_ratio / count;
    their_slip += weight * trial.mean_slip();
    pairs += weight;
  }
};

std::map<int, SubjectFriction> subject_frictions(const std::vector<TrialEvidence>& trials,
                                                 const std::vector<int>& times) {
  std::map<int, SubjectFriction> subjects;
  for (std::size_t i = 0; i < trials.size(); ++i) subjects[trials[i].subject].add(trials[i], times[i]);
  return subjects;
}

/// The subject's trials alone, each as often.
std::vector<int> times_of(int subject, const std::vector<TrialEvidence>& trials,
                          const std::vector<int>& times) {
  std::vector<int> own = times;
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (trials[i].subject != subject) own[i] = 0;
  return own;
}

PadValue ruptures_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  return subjects_mean(trials, times, &TrialEvidence::rupture_ratio, &TrialEvidence::ruptures,
                       enough_ruptures, "no rupture from stick was found");
}

double log_load(const TrialEvidence& trial) {
  return trial.slip_log_load / static_cast<double>(trial.slip_samples);
}

/// Whether trials are enough, of loads enough, to tell that their friction goes with the load: a line goes
/// through any two.
bool tell_loads(const std::vector<const TrialEvidence*>& trials) {
  constexpr std::size_t fewest_trials = 5, fewest_loads = 3;
  constexpr double alike = 0.1;  // of ln n
  std::vector<double> loads;
  loads.reserve(trials.size());
  for (const TrialEvidence* trial : trials) loads.push_back(log_load(*trial));
  std::sort(loads.begin(), loads.end());
  std::size_t unlike = loads.empty() ? 0 : 1;
  for (std::size_t i = 1; i < loads.size(); ++i) unlike += loads[i] - loads[i - 1] > alike ? 1 : 0;
  return trials.size() >= fewest_trials && unlike >= fewest_loads;
}

/// How mu_dynamic of trials goes with their load; nothing is explained of too few.
struct LoadLine {
  double slope = 0, explained = 0;

  explicit LoadLine(const std::vector<const TrialEvidence*>& trials) {
    if (!tell_loads(trials)) return;
    double load = 0, mu = 0, load_2 = 0, mu_2 = 0, both = 0;
    const auto count = static_cast<double>(trials.size());
    for (const TrialEvidence* trial : trials) {
      const double x = log_load(*trial), y = std::log(trial->mean_slip());
      load += x / count, mu += y / count;
      load_2 += x * x / count, mu_2 += y * y / count, both += x * y / count;
    }
    load_2 -= load * load, mu_2 -= mu * mu, both -= load * mu;
    if (!(load_2 > 0) || !(mu_2 > 0)) return;
    slope = both / load_2;
    explained = both * both / (load_2 * mu_2);
  }
};

std::string load_text(const TrialEvidence& trial) {
  return rounded_text(std::exp(log_load(trial)), 2);
}

}  // namespace

PadValue static_friction(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                         bool is_paired) {
  PadValue found = ruptures_mean(trials, times);
  if (!is_paired || !found.refusal.empty()) return found;
  double sum = 0, subjects = 0;
  for (const auto& [subject, friction] : subject_frictions(trials, times)) {
    const std::vector<int> own = times_of(subject, trials, times);
    const PadValue plain = ruptures_mean(trials, own);
    if (!plain.refusal.empty()) continue;
    ++subjects;
    sum += friction.pairs > 0 ? friction.ruptures / friction.their_slip * slip_mean(trials, own).value
                              : plain.value;
  }
  found.value = sum / subjects;
  return found;
}

bool is_friction_unlike(const std::vector<TrialEvidence>& trials) {
  constexpr double most_share = 0.05;
  const std::vector<int> once(trials.size(), 1);
  const PadValue plain = static_friction(trials, once, false), paired = static_friction(trials, once, true);
  return plain.refusal.empty() && std::abs(paired.value - plain.value) > most_share * plain.value;
}

std::vector<OwnFriction> own_frictions(const std::vector<TrialEvidence>& trials) {
  const std::vector<int> once(trials.size(), 1);
  std::vector<OwnFriction> own;
  for (const auto& [subject, friction] : subject_frictions(trials, once)) {
    const auto place = static_cast<std::size_t>(std::max(subject, 0));
    if (own.size() <= place) own.resize(place + 1);
    const PadValue mean = ruptures_mean(trials, times_of(subject, trials, once));
    if (!mean.refusal.empty()) continue;
    own[place].mu_static = mean.value;
    own[place].mu_dynamic = friction.pairs > 0 ? friction.their_slip / friction.pairs : 0;
  }
  return own;
}

bool contradicts_law(const PadValues& found) {
  const PadValue &mu_static = value_of(found, PadNumber::mu_static),
                 &mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  return mu_static.refusal.empty() && mu_dynamic.refusal.empty() && mu_static.value < mu_dynamic.value;
}

std::string unlike_trials_words(const std::vector<std::string>& names,
                                const std::vector<TrialEvidence>& trials, double least_times) {
  constexpr double mostly = 0.7;
  std::map<int, std::pair<std::size_t, std::size_t>> subjects;  // the least and the most
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i].tells_slip()) continue;
    auto& [least, most] = subjects.try_emplace(trials[i].subject, i, i).first->second;
    if (trials[i].mean_slip() < trials[least].mean_slip()) least = i;
    if (trials[i].mean_slip() > trials[most].mean_slip()) most = i;
  }
  double times = least_times;
  std::size_t least = 0, most = 0;
  for (const auto& [subject, ends] : subjects) {
    const double own = trials[ends.second].mean_slip() / trials[ends.first].mean_slip();
    if (own > times) times = own, least = ends.first, most = ends.second;
  }
  if (least == most) return {};
  std::set<int> all;
  std::vector<const TrialEvidence*> together;
  for (const TrialEvidence& trial : trials) {
    all.insert(trial.subject);
    if (trial.subject == trials[least].subject && trial.tells_slip()) together.push_back(&trial);
  }
  const LoadLine line(together);
  const char* why =
      line.explained > mostly
          ? (line.slope < 0 ? "it falls with the trials' loads: fit those of each load by themselves"
                            : "it rises with the trials' loads: fit those of each load by themselves")
      : all.size() < 2
          ? "where they are several people's, say whose in a column subject (--columns subject=NAME); else "
            "leave out what went wrong (--leave-out)"
          : "is one of them another person's, or of another plate? Say whose in the column subject, or leave "
            "it out (--leave-out)";
  return fmt::format("unlike one another: {} slips with {} of its load ({} N), {} with {} ({} N); {}",
                     names[least], rounded_text(trials[least].mean_slip(), 3), load_text(trials[least]),
                     names[most], rounded_text(trials[most].mean_slip(), 3), load_text(trials[most]), why);
}

}  // namespace fingerpad
