#include "study/law_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// What is left by the trials but the odd ones.
ResidualPart of_rest(const TrialParts& parts, double odd) {
  ResidualPart rest;
  for (const ResidualPart& part : parts.each)
    if (!(left_beyond(part) > odd)) rest += part;
  return rest;
}

/// Whether a law leaves so much more than is expected that it may be another: too much, and several times
/// that. Where friction steps over the speed, less says so: slip above the step and stick that surely holds
/// are judged alone, and of them the pad's law leaves next to nothing.
bool may_be_another(const ResidualPart& rest, const HiddenStick& hidden) {
  constexpr double most_times = 2, stepped_left = 0.03, stepped_times = 1.3;
  const double most = hidden.is_stepped  ? stepped_left
                      : hidden.is_likely ? surely_left
                                         : most_left,
               times = hidden.is_stepped ? stepped_times : most_times;
  return left_beyond(rest) > most && rest.left > times * times * rest.expected;
}

constexpr const char* ends_too = " and about its ends";

std::string off_words(const ResidualPart& part, const char* where) {
  return fmt::format(
      "it leaves {:.1f} % of the friction in stick{} (RMS), where noise and vibration explain {:.1f} %",
      100 * std::sqrt(part.left / part.signal), where, 100 * std::sqrt(part.expected / part.signal));
}

/// Why another law may be behind what does not say that the pad's does not fit; empty where nothing does.
std::string another_law_words(const TrialParts& parts, const HiddenStick& hidden, const LawResidual& found) {
  const double odd = hidden.is_likely ? std::numeric_limits<double>::infinity() : odd_left(parts.each);
  const ResidualPart rest = of_rest(parts, odd);
  const bool hardly_drops = hidden.is_stepped && found.gives >= fewest_gives && 4 * found.drops < found.gives;
  if (!hardly_drops && !may_be_another(rest, hidden)) return {};
  const std::string words = off_words(rest, ends_too);
  if (!hidden.is_stepped)
    return words +
           ": of some trials the law leaves much more than of others, so that another may be behind it; add "
           "trials, rubbed alike";
  const std::string drops =
      hardly_drops ? fmt::format(", and stick drops the force at {} of its {} ends", found.drops, found.gives)
                   : "";
  return fmt::format(
      "{}{}: another law may be behind it, as that of LuGre, whose friction rises as the finger slows; rub "
      "faster, or sample faster",
      words, drops);
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
  if (!hidden.is_likely) {
    if (parts.is_off(most_left) && parts.are_most_off(most_left))
      found.misfit = off_words(parts.all, ends_too);
    const double odd = odd_left(parts.each);
    for (std::size_t i = 0; i < parts.each.size(); ++i)
      if (left_beyond(parts.each[i]) > odd)
        found.odd_trials.push_back(names[i] + ": " + off_words(parts.each[i], ends_too));
  }
  if (trials_give_without_drops(trials) && !hidden.is_stepped)
    found.misfit += fmt::format(
        "{}stick gives way without a drop of the force at {} of its {} ends (a pad whose mu_static is less "
        "than {:.0f} % above its mu_dynamic looks alike here)",
        found.misfit.empty() ? "" : "; ", found.gives - found.drops, found.gives, 100 * hidden.unseen_drop);
  if (found.misfit.empty() && hidden.is_likely && parts.is_off(surely_left) &&
      parts.are_most_off(surely_left))
    found.untold =
        off_words(parts.all, ends_too) +
        ": more than stick that passes for slip mostly leaves, so that another law may be behind it; "
        "rub faster, or sample faster";
  if (found.misfit.empty() && found.untold.empty()) found.untold = another_law_words(parts, hidden, found);
  if (!found.misfit.empty()) found.odd_trials.clear();
  return found;
}

}  // namespace fingerpad
