#include "study/law_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/sample_noise.hpp"
#include "study/trial_evidence.hpp"

namespace fingerpad {
namespace {

// RMS beyond what is expected, of the force ratio; and where stick may pass for slip, which bends its ends.
constexpr double most_left = 0.06, surely_left = 0.15;

/// What is left beyond what is expected, as a share.
double left_beyond(const ResidualPart& part) {
  return part.signal > 0 ? std::sqrt(std::max(0.0, (part.left - part.expected) / part.signal)) : 0;
}

/// One part of each trial, and all together.
struct TrialParts {
  std::vector<ResidualPart> each;
  ResidualPart all;

  void add(const ResidualPart& part) {
    each.push_back(part);
    all += part;
  }
  bool is_off(double most) const { return left_beyond(all) > most; }
  /// Whether the law leaves too much of most of the trials, each by its signal.
  bool are_most_off(double most) const {
    double off = 0;
    for (const ResidualPart& part : each) off += left_beyond(part) > most ? part.signal : 0;
    return 2 * off > all.signal;
  }
};

/// Beyond which a trial is odd: more than the law may leave, and further from the usual than the furthest of
/// so many trials is by chance. Of a few trials the usual is not told.
double odd_left(const std::vector<ResidualPart>& trials) {
  constexpr std::size_t fewest = 5;
  constexpr double beyond_chance = 2, per_deviation = 1 / 0.6745;
  std::vector<double> lefts, offs;
  for (const ResidualPart& part : trials)
    if (part.signal > 0) lefts.push_back(left_beyond(part));
  if (lefts.size() < fewest) return most_left;
  const double usual = median_of(lefts);
  for (const double left : lefts) offs.push_back(std::abs(left - usual));
  const double furthest = std::sqrt(2 * std::log(static_cast<double>(lefts.size()))) + beyond_chance;
  return std::max(most_left, usual + furthest * per_deviation * median_of(offs));
}

std::string off_words(const ResidualPart& part, const char* where) {
  return fmt::format(
      "it leaves {:.1f} % of the friction in stick{} (RMS), where noise and vibration explain {:.1f} %",
      100 * std::sqrt(part.left / part.signal), where, 100 * std::sqrt(part.expected / part.signal));
}

/// Whether stick gives way without a drop of the force: mostly, and mostly in most of the trials in which it
/// does.
bool trials_give_without_drops(const std::vector<TrialResidual>& trials) {
  long gives = 0, drops = 0, giving = 0, off = 0;
  for (const TrialResidual& trial : trials) {
    gives += trial.gives;
    drops += trial.drops;
    giving += trial.gives > 0 ? 1 : 0;
    off += 2 * trial.drops < trial.gives ? 1 : 0;
  }
  return gives_without_drops(gives, drops) && 2 * off > giving;
}

/// Where no slip is surely seen, stick alone is held against the law: where it surely does not give way; and
/// all of it, which teeth that are not seen bend by no more than they drop.
void judge_stick(const std::vector<TrialResidual>& trials, const HiddenStick& hidden, LawResidual& found) {
  TrialParts sure, whole;
  for (const TrialResidual& trial : trials) {
    sure.add(trial.sure_stick);
    whole.add(trial.stick);
  }
  for (const auto& [parts, most] :
       {std::pair(&sure, most_left), std::pair(&whole, most_left + hidden.unseen_drop)}) {
    if (!found.misfit.empty() || !parts->is_off(most) || !parts->are_most_off(most)) continue;
    found.misfit = off_words(parts->all, "");
    found.untold.clear();
  }
}

}  // namespace

LawResidual law_verdict(const std::vector<TrialResidual>& trials, const std::vector<std::string>& names,
                        const HiddenStick& hidden) {
  LawResidual found;
  TrialParts parts;
  for (const TrialResidual& trial : trials) {
    ResidualPart part = trial.stick;
    part += trial.slip;
    parts.add(part);
    found.gives += trial.gives;
    found.drops += trial.drops;
  }
  found.samples = parts.all.samples;
  found.untold = hidden.no_slip;
  if (!(parts.all.signal > 0)) return found;
  found.share = std::sqrt(parts.all.left / parts.all.signal);
  found.expected = std::sqrt(parts.all.expected / parts.all.signal);
  if (!hidden.no_slip.empty()) {
    judge_stick(trials, hidden, found);
    return found;
  }
  const char* where = " and about its ends";
  if (!hidden.is_likely) {
    if (parts.is_off(most_left) && parts.are_most_off(most_left)) found.misfit = off_words(parts.all, where);
    const double odd = odd_left(parts.each);
    for (std::size_t i = 0; i < parts.each.size(); ++i)
      if (left_beyond(parts.each[i]) > odd)
        found.odd_trials.push_back(names[i] + ": " + off_words(parts.each[i], where));
  }
  if (trials_give_without_drops(trials) && !hidden.is_stepped)
    found.misfit += fmt::format(
        "{}stick gives way without a drop of the force at {} of its {} ends (a pad whose mu_static is less "
        "than {:.0f} % above its mu_dynamic looks alike here)",
        found.misfit.empty() ? "" : "; ", found.gives - found.drops, found.gives, 100 * hidden.unseen_drop);
  if (found.misfit.empty() && hidden.is_likely && parts.is_off(surely_left) &&
      parts.are_most_off(surely_left))
    found.untold =
        off_words(parts.all, where) +
        ": more than stick that passes for slip mostly leaves, so that another law may be behind it; "
        "rub faster, or sample faster";
  if (!found.misfit.empty()) found.odd_trials.clear();
  return found;
}

}  // namespace fingerpad
