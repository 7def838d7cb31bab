#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/types.hpp"
#include "study/cleaning_settings.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// One trial made clean: what the pad did in the plate's plane while it was pressed, in the pad's own axes (x
/// lateral, y longitudinal, as the friction laws take them). Samples without contact are left out.
struct MeasuredTrial {
  int subject = 0;
  std::string name;  ///< "FILE, subject 1, trial 3", for messages
  double rate_hz = 0;
  std::vector<double> t_s;       ///< of the recording, per sample
  std::vector<Vec2> position_m;  ///< of the finger
  std::vector<double> height_m;  ///< of the finger along the plate's normal; falls as the pad is pressed
  std::vector<double> normal_force_n;  ///< > 0
  std::vector<Vec2> force_ratio;       ///< q: tangential force on the finger over the normal force
  std::vector<bool> starts_anew;  ///< the sample does not follow the one before: samples or contact missed
  bool has_direction = false;     ///< else the axes are arbitrary
  double inclination_deg = 0;     ///< mean, finger against the plate; 0 without a direction
  double delay_unsure_s = 0;      ///< by which the delay that was taken out may be off: half its interval
  bool is_delay_told = true;      ///< else none was taken out, and delay_unsure_s is what one may be
  double light_share = usual_light_share;  ///< CleaningSettings'
  std::string lacks;  ///< "FILE: column fx_n missing": force_ratio is none; empty: it was measured
  std::vector<LineLeftIn> lines_left_in;
};

/// The finger's angle that a trial is run and drawn at [deg]: 45, where a pad's axes hold, if it says none.
inline double angle_deg(const MeasuredTrial& trial) noexcept {
  return trial.has_direction ? trial.inclination_deg : 45;
}

/// What cleaning did to one trial.
struct TrialCleaning {
  std::string name;
  long samples = 0, filled = 0, missing = 0;
  long free_samples = 0;       ///< without contact, that the tare rests on; 0: no tare was taken
  bool presses_on = false;     ///< where it presses least, by its height or friction: so no tare was taken
  bool falls_at_once = false;  ///< and there its force falls within one sample, as if it were lifted
  Vec3 tare_begin_n{0, 0, 0};  ///< taken off at the trial's begin, in W
  Vec3 tare_end_n{0, 0, 0};    ///< and at its end; straight in between
  double hum_hz = 0;           ///< of the mains hum taken off; 0: none was found
  double hum_n = 0;            ///< its greatest amplitude of an axis
  bool tells_contact = false;  ///< its positions are told from its torques
  bool is_tracked = false;     ///< its contact points are passed over for a finger that is tracked beside
  /// Then: how far those lie from the tracked finger, RMS; none where the finger never presses.
  std::optional<double> contact_off_m;
};

/// By how much force lags position. The interval is a bootstrap over the trials.
struct DelayEstimate {
  double delay_s = 0;
  std::optional<std::pair<double, double>> interval_s;  ///< 95 %
  double sample_s = 0;                                  ///< between samples, of the slowest clock
  double unsure_s = 0;    ///< of the interval, either way: what samples so far apart leave open
  long samples = 0;       ///< of stick, that it rests on
  long trials = 0;        ///< likewise
  bool by_parts = false;  ///< so few that the interval is drawn from parts of them
  std::string refusal;    ///< empty: the estimate holds
};

/// The delay of a file, or of several that do not tell theirs one by one.
struct FileDelay {
  std::vector<std::string> files;
  DelayEstimate estimate;  ///< whether or not it was taken out
};

/// Measurements of one or several subjects, ready for a fit.
struct Measurement {
  std::vector<MeasuredTrial> trials;       ///< with contact, by file and in the file's order
  std::vector<MeasuredTrial> pressed;      ///< likewise, of which the normal force alone was measured
  std::vector<TrialCleaning> cleanings;    ///< of every trial that was read, in that order, the pressed last
  bool looks_for_tare = true;              ///< else forces were taken as they are (--no-tare)
  bool knows_delay = false;                ///< it was given, or left in: the fit looks for no rest of it
  std::vector<FileDelay> delays;           ///< by file, those taken together last
  std::vector<std::string> untouched;      ///< names of trials whose finger never presses
  std::vector<std::string> without_force;  ///< as RecordedMeasurement
  std::vector<std::string> steps;          ///< what was done to the samples, in order, for people
  std::vector<std::string> contact_steps;  ///< of these, which places a six-axis sensor's fingers were given
};

/// Makes a recorded measurement clean. In this order, each step as `settings` has it and told in
/// Measurement::steps: missing samples, mains hum, tare, delay, low pass, and the turn into the pad's axes.
/// Where the normal force alone was measured, hum and delay are left in (a delay that is given is taken out).
/// The recording is used up.
Measurement clean(RecordedMeasurement recorded, const CleaningSettings& settings);

}  // namespace fingerpad
