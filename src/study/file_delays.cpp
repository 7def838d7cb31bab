#include "study/file_delays.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "study/delay_estimate.hpp"
#include "study/moved_trials.hpp"
#include "study/position_delay.hpp"

namespace fingerpad {
namespace {

constexpr double longest_delay_s = delay_lags_each_way * delay_step_s;
constexpr double most_rest_s = 5e-3;  // that a second look may tell beside the first

/// Each file's own estimate, and one for all those that do not tell theirs.
std::vector<FileDelay> estimates_of_files(const std::vector<RecordedTrial>& trials,
                                          const MovedTrials& moved) {
  std::vector<FileDelay> told;
  for (const RecordedTrial& trial : trials) {
    const auto is_known = [&trial](const FileDelay& delay) { return is_of(delay, trial); };
    if (std::none_of(told.begin(), told.end(), is_known)) told.push_back({{trial.file}, {}});
  }
  FileDelay others;
  for (FileDelay& delay : told) {
    delay.estimate = moved.estimate_of(delay);
    if (delay.estimate.refusal.empty()) continue;
    others.files.push_back(delay.files.front());
    others.estimate = delay.estimate;
  }
  if (others.files.empty()) return told;
  std::erase_if(told, [](const FileDelay& delay) { return !delay.estimate.refusal.empty(); });
  if (others.files.size() > 1) others.estimate = moved.estimate_of(others);
  told.push_back(std::move(others));
  return told;
}

/// An estimate of what is left where so much has been taken out, as one of the whole.
void count_moved(double moved_s, DelayEstimate& estimate) {
  estimate.delay_s += moved_s;
  if (!estimate.interval_s) return;
  estimate.interval_s->first += moved_s;
  estimate.interval_s->second += moved_s;
}

/// Stick is told better where the first estimate is out, and with it what is left. What both come to is to be
/// a delay that sensors have; one that few trials tell, by teeth of stick and slip as like as not, no more
/// than their filters'.
void tell_rest(const MovedTrials& moved, FileDelay& delay) {
  const double first_s = delay.estimate.delay_s;
  DelayEstimate rest = moved.estimate_of(delay);
  const double rest_s = rest.delay_s;
  count_moved(first_s, rest);
  delay.estimate = rest;
  if (!rest.refusal.empty()) return;
  const double most_s = rest.by_parts ? usual_delay_s : longest_delay_s;
  if (std::abs(rest.delay_s) > most_s) {
    delay.estimate.refusal =
        fmt::format("it would be {} ms, longer than {} ms, which {}", rounded_text(1e3 * rest.delay_s, 3),
                    rounded_text(1e3 * most_s, 3),
                    rest.by_parts ? "no one or two trials tell for sure" : "is as far as it is looked for");
  } else if (std::abs(rest_s) > most_rest_s) {
    delay.estimate.refusal = fmt::format("a first look tells {} ms, and a second one {} ms",
                                         rounded_text(1e3 * first_s, 3), rounded_text(1e3 * rest.delay_s, 3));
  }
}

std::string estimate_text(const DelayEstimate& delay) {
  constexpr double slow_s = 1.5e-3;
  if (!delay.refusal.empty())
    return fmt::format("the delay of force behind position cannot be told: {}", delay.refusal);
  std::string told = fmt::format("force lags position by {} ms", fixed_text(1e3 * delay.delay_s, 3));
  if (!delay.interval_s) return told;
  told +=
      fmt::format(" (95 %: {} .. {} ms, {} samples of stick", fixed_text(1e3 * delay.interval_s->first, 3),
                  fixed_text(1e3 * delay.interval_s->second, 3), delay.samples);
  if (delay.by_parts)
    told += fmt::format(" of {} trial{} alone, by whose stretches it may be so far off", delay.trials,
                        delay.trials == 1 ? "" : "s");
  if (delay.sample_s > slow_s)
    told += fmt::format("; samples that are {} ms apart leave {} ms either way of it open",
                        rounded_text(1e3 * delay.sample_s, 3), rounded_text(1e3 * delay.unsure_s, 2));
  return told + ")";
}

/// What to say where a delay that was given is none of those that a file's measurement allows for.
std::string beside_given_text(const std::vector<FileDelay>& delays, double given_s) {
  std::vector<std::string> files;
  for (const FileDelay& delay : delays) {
    const auto& interval_s = delay.estimate.interval_s;
    if (interval_s && (given_s < interval_s->first || given_s > interval_s->second) &&
        delay.estimate.refusal.empty())
      files.insert(files.end(), delay.files.begin(), delay.files.end());
  }
  if (files.empty()) return "";
  return fmt::format("; the one that was given is not among those of {}: are its unit and its sign right?",
                     fmt::join(files, ", "));
}

}  // namespace

std::vector<FileDelay> settle_delays(std::vector<RecordedTrial>& trials, const CleaningSettings& settings) {
  if (settings.delay_s)
    for (RecordedTrial& trial : trials) shift_positions(trial, *settings.delay_s);
  MovedTrials moved(trials, settings);
  std::vector<FileDelay> delays = estimates_of_files(trials, moved);
  if (settings.delay_s)
    for (FileDelay& delay : delays) count_moved(*settings.delay_s, delay.estimate);
  if (!settings.takes_delay || settings.delay_s) return delays;
  for (FileDelay& delay : delays) {
    if (!delay.estimate.refusal.empty()) continue;
    moved.move(delay, delay.estimate.delay_s);
    tell_rest(moved, delay);
    if (!delay.estimate.refusal.empty()) continue;
    for (RecordedTrial& trial : trials)
      if (is_of(delay, trial)) shift_positions(trial, delay.estimate.delay_s);
  }
  return delays;
}

double delay_unsure_s(const std::vector<FileDelay>& delays, const std::string& file) {
  for (const FileDelay& delay : delays) {
    if (std::find(delay.files.begin(), delay.files.end(), file) == delay.files.end()) continue;
    const auto& interval_s = delay.estimate.interval_s;
    if (delay.estimate.refusal.empty()) return interval_s ? (interval_s->second - interval_s->first) / 2 : 0;
    return usual_delay_s;
  }
  return 0;
}

bool is_delay_told(const std::vector<FileDelay>& delays, const std::string& file) {
  return std::none_of(delays.begin(), delays.end(), [&](const FileDelay& delay) {
    return !delay.estimate.refusal.empty() &&
           std::find(delay.files.begin(), delay.files.end(), file) != delay.files.end();
  });
}

std::string delay_text(const std::vector<FileDelay>& delays, const CleaningSettings& settings) {
  std::string text = "delay: ";
  if (settings.delay_s) text += fmt::format("{:.3f} ms as given was taken out; ", 1e3 * *settings.delay_s);
  bool takes_any = false, takes_all = true;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    const FileDelay& delay = delays[i];
    takes_any = takes_any || delay.estimate.refusal.empty();
    takes_all = takes_all && delay.estimate.refusal.empty();
    if (i > 0) text += "; ";
    if (delay.files.size() > 1) {
      text += fmt::format("{} files together: ", delay.files.size());
    } else if (delays.size() > 1) {
      text += delay.files.front() + ": ";
    }
    text += estimate_text(delay.estimate);
  }
  if (delays.empty()) text += "no trial";
  if (settings.delay_s) return text + beside_given_text(delays, *settings.delay_s);
  if (!settings.takes_delay) return text + "; left in (off)";
  if (delays.empty() || takes_all) return takes_any ? text + "; taken out" : text;
  return text + fmt::format("; {} taken out: where it is known, give it (--delay 7ms)",
                            takes_any ? "what is told was" : "none was");
}

}  // namespace fingerpad
