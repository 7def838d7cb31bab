#include "study/file_delays.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "study/pad_axes.hpp"
#include "study/position_delay.hpp"

namespace fingerpad {
namespace {

bool is_of(const FileDelay& delay, const RecordedTrial& trial) {
  return std::find(delay.files.begin(), delay.files.end(), trial.file) != delay.files.end();
}

/// What each trial says; nothing of those without stick.
std::vector<DelaySums> delay_sums_of(const std::vector<RecordedTrial>& trials) {
  std::vector<DelaySums> sums(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const MeasuredTrial measured = in_pad_axes(trials[i]);
    if (measured.position_m.size() >= fewest_touching_samples)
      sums[i] = delay_sums(measured, stick_segments(measured));
  }
  return sums;
}

DelayEstimate estimate_of(const FileDelay& delay, const std::vector<RecordedTrial>& trials,
                          const std::vector<DelaySums>& sums) {
  std::vector<DelaySums> own;
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (sums[i].samples > 0 && is_of(delay, trials[i])) own.push_back(sums[i]);
  return estimate_delay(own, 1);
}

/// Each file's own estimate, and one for all those that do not tell theirs.
std::vector<FileDelay> estimates_of_files(const std::vector<RecordedTrial>& trials) {
  std::vector<FileDelay> told;
  for (const RecordedTrial& trial : trials) {
    const auto is_known = [&trial](const FileDelay& delay) { return is_of(delay, trial); };
    if (std::none_of(told.begin(), told.end(), is_known)) told.push_back({{trial.file}, {}});
  }
  const std::vector<DelaySums> sums = delay_sums_of(trials);
  FileDelay others;
  for (FileDelay& delay : told) {
    delay.estimate = estimate_of(delay, trials, sums);
    if (delay.estimate.refusal.empty()) continue;
    others.files.push_back(delay.files.front());
    others.estimate = delay.estimate;
  }
  if (others.files.empty()) return told;
  std::erase_if(told, [](const FileDelay& delay) { return !delay.estimate.refusal.empty(); });
  if (others.files.size() > 1) others.estimate = estimate_of(others, trials, sums);
  told.push_back(std::move(others));
  return told;
}

void move_positions(const FileDelay& delay, double by_s, std::vector<RecordedTrial>& trials) {
  for (RecordedTrial& trial : trials)
    if (is_of(delay, trial)) shift_positions(trial, by_s);
}

/// An estimate of what is left where so much has been taken out, as one of the whole.
void count_moved(double moved_s, DelayEstimate& estimate) {
  estimate.delay_s += moved_s;
  if (!estimate.interval_s) return;
  estimate.interval_s->first += moved_s;
  estimate.interval_s->second += moved_s;
}

std::string estimate_text(const DelayEstimate& delay) {
  constexpr double slow_s = 1.5e-3;
  if (!delay.refusal.empty())
    return fmt::format("the delay of force behind position cannot be told: {}", delay.refusal);
  std::string told = fmt::format("force lags position by {:.3f} ms", 1e3 * delay.delay_s);
  if (!delay.interval_s) return told;
  told += fmt::format(" (95 %: {:.3f} .. {:.3f} ms, {} samples of stick", 1e3 * delay.interval_s->first,
                      1e3 * delay.interval_s->second, delay.samples);
  if (delay.sample_s > slow_s)
    told += fmt::format("; samples that are {} ms apart leave {} ms either way of it open",
                        rounded_text(1e3 * delay.sample_s, 3), rounded_text(1e3 * delay.unsure_s, 2));
  return told + ")";
}

}  // namespace

std::vector<FileDelay> settle_delays(std::vector<RecordedTrial>& trials, const CleaningSettings& settings) {
  if (settings.delay_s)
    for (RecordedTrial& trial : trials) shift_positions(trial, *settings.delay_s);
  std::vector<FileDelay> delays = estimates_of_files(trials);
  if (settings.delay_s)
    for (FileDelay& delay : delays) count_moved(*settings.delay_s, delay.estimate);
  if (!settings.takes_delay || settings.delay_s) return delays;
  for (const FileDelay& delay : delays)
    if (delay.estimate.refusal.empty()) move_positions(delay, delay.estimate.delay_s, trials);
  const std::vector<DelaySums> sums = delay_sums_of(trials);
  for (FileDelay& delay : delays) {
    if (!delay.estimate.refusal.empty()) continue;
    DelayEstimate rest = estimate_of(delay, trials, sums);
    if (!rest.refusal.empty()) continue;  // what was found before is out all the same
    move_positions(delay, rest.delay_s, trials);
    count_moved(delay.estimate.delay_s, rest);
    delay.estimate = rest;
  }
  return delays;
}

double delay_unsure_s(const std::vector<FileDelay>& delays, const std::string& file) {
  for (const FileDelay& delay : delays) {
    const bool is_its = std::find(delay.files.begin(), delay.files.end(), file) != delay.files.end();
    const auto& interval_s = delay.estimate.interval_s;
    if (is_its && interval_s) return (interval_s->second - interval_s->first) / 2;
  }
  return 0;
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
  if (settings.delay_s) return text;
  if (!settings.takes_delay) return text + "; left in (off)";
  if (delays.empty() || takes_all) return takes_any ? text + "; taken out" : text;
  return text + fmt::format("; {} taken out: where it is known, give it (--delay 7ms)",
                            takes_any ? "what is told was" : "none was");
}

}  // namespace fingerpad
