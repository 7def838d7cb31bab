#include "study/cleaning_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "study/file_delays.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// Where contact points come from; empty where none are told from torques.
std::string contact_text(const std::vector<TrialCleaning>& trials) {
  std::size_t told = 0, untared = 0;
  for (const TrialCleaning& trial : trials) {
    told += trial.tells_contact ? 1 : 0;
    untared += trial.tells_contact && trial.free_samples == 0 ? 1 : 0;
  }
  if (told == 0) return {};
  return fmt::format(
      "contact points: told from force and torque in {} trial{}{}", told, told == 1 ? "" : "s",
      untared == 0
          ? ", after the tare"
          : fmt::format("; in {} of them no tare was taken off, and a sensor that was not zeroed moves "
                        "them",
                        untared));
}

/// What contact points are beside a finger that was tracked; empty where none was.
std::string tracked_text(const std::vector<TrialCleaning>& trials) {
  std::size_t tracked = 0;
  std::vector<double> off_m;
  for (const TrialCleaning& trial : trials) {
    tracked += trial.is_tracked ? 1 : 0;
    if (trial.contact_off_m) off_m.push_back(*trial.contact_off_m);
  }
  if (tracked == 0) return {};
  const std::string how_far =
      off_m.empty()
          ? "where they lie is not told, as the finger presses in none"
          : fmt::format(
                "they lie {} mm from the tracked finger (RMS, median of {}), where centimetres would "
                "tell of another --sensor-at, --sensor-turned or --plate-height",
                rounded_text(1e3 * median_of(off_m), 2),
                off_m.size() == tracked ? "the trials"
                                        : fmt::format("the {} in which it presses", off_m.size()));
  return fmt::format(
      "contact points: passed over in {} trial{} whose finger is tracked along the plate: the skin holds on "
      "there in stick, while the finger moves on; {}",
      tracked, tracked == 1 ? "" : "s", how_far);
}

/// What was taken off for the sensor's zero, and why from no more.
std::string tare_text(const std::vector<TrialCleaning>& trials) {
  std::size_t tared = 0, press_on = 0, at_once = 0;
  double most_n = 0;
  for (const TrialCleaning& trial : trials) {
    tared += trial.free_samples > 0 ? 1 : 0;
    press_on += trial.presses_on ? 1 : 0;
    at_once += trial.falls_at_once ? 1 : 0;
    most_n = std::max({most_n, trial.tare_begin_n.norm(), trial.tare_end_n.norm()});
  }
  std::string text =
      fmt::format("tare: taken off {} of {} trial{}", tared, trials.size(), trials.size() == 1 ? "" : "s");
  if (tared > 0) text += fmt::format(", at most {} N", rounded_text(most_n, 3));
  if (tared == trials.size()) return text;
  text += tared == 0 ? "; none has a moment" : "; the others have no moment";
  text += " that is surely without contact";
  if (press_on > 0)
    text += fmt::format(
        " (in {} of them height or friction tell that the finger presses on where it is lightest)", press_on);
  if (at_once > 0)
    text += fmt::format(
        "; in {} of them the force falls or rises there within one sample: a finger that is lifted so fast "
        "and then keeps its height looks like one that presses on",
        at_once);
  return text + ": record a second in the air in each trial, or zero the sensor before it";
}

}  // namespace

std::string hum_text(const std::vector<MainsHum>& taken, const std::vector<std::string>& left_in,
                     bool of_forces, std::string_view of_what) {
  long humming = 0;
  MainsHum most;
  for (const MainsHum& hum : taken) {
    humming += hum.frequency_hz > 0 ? 1 : 0;
    if (hum.amplitude > most.amplitude) most = hum;
  }
  std::string text = fmt::format("mains hum{}: ", of_forces ? of_what : " of torques");
  if (humming > 0) {
    text += fmt::format(
        "taken out of {} of {} trial{}, at most {} at {:.2f} Hz", humming, taken.size(),
        taken.size() == 1 ? "" : "s",
        of_forces ? rounded_text(most.amplitude, 3) + " N" : rounded_text(1e3 * most.amplitude, 3) + " N mm",
        most.frequency_hz);
  } else {
    text += left_in.empty() ? "none stands out" : "none is taken out";
  }
  for (const std::string& line : left_in) text += "; " + line;
  return text;
}

std::vector<std::string> contact_steps(const std::vector<TrialCleaning>& trials) {
  std::vector<std::string> steps;
  for (const std::string& step : {contact_text(trials), tracked_text(trials)})
    if (!step.empty()) steps.push_back(step);
  return steps;
}

std::vector<std::string> steps_text(const Measurement& measurement, const CleaningSettings& settings,
                                    const std::vector<std::string>& hum) {
  long samples = 0, filled = 0, missing = 0;
  for (const TrialCleaning& trial : measurement.cleanings) {
    samples += trial.samples;
    filled += trial.filled;
    missing += trial.missing;
  }
  std::vector<std::string> steps;
  steps.push_back(
      fmt::format("missing samples: of {}, {} filled with straight lines (gaps up to {} ms), {} left out",
                  samples, filled, rounded_text(1e3 * settings.longest_fill_s, 3), missing));
  const std::size_t pressed = measurement.pressed.size();
  if (pressed > 0)
    steps.push_back(fmt::format("normal force alone: in {} trial{}{}", pressed, pressed == 1 ? "" : "s",
                                measurement.knows_delay ? "" : ", of which the delay is left in"));
  steps.insert(steps.end(), hum.begin(), hum.end());
  steps.push_back(settings.takes_tare ? tare_text(measurement.cleanings) : "tare: left as it is (off)");
  steps.insert(steps.end(), measurement.contact_steps.begin(), measurement.contact_steps.end());
  if (!measurement.delays.empty() || pressed == 0 || settings.delay_s)
    steps.push_back(delay_text(measurement.delays, settings));
  steps.push_back(settings.smoothing_hz > 0
                      ? fmt::format("low pass: Butterworth, 2nd order, forth and back, {} Hz halved",
                                    rounded_text(settings.smoothing_hz, 6))
                      : "low pass: off; the fit averages over windows itself");
  return steps;
}

}  // namespace fingerpad
