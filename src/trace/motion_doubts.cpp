#include "trace/motion_doubts.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>

#include "base/nearest_word.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"
#include "base/unit_row.hpp"
#include "motion/driving_share.hpp"
#include "motion/force_unit_doubt.hpp"
#include "motion/pressed_force.hpp"
#include "motion/recorded_table.hpp"

namespace fingerpad {
namespace {

double way_m(const Motion& motion) {
  double way_m = 0;
  for (Eigen::Index i = 1; i < motion.p_WQ.cols(); ++i)
    way_m += (motion.p_WQ.col(i) - motion.p_WQ.col(i - 1)).norm();
  return way_m;
}

/// A unit that a scene says for some columns, in SI.
struct SaidUnit {
  Quantity quantity;
  double si_per_unit;
  std::initializer_list<std::size_t> places;
};

/// The one of these columns whose name ends in another unit than was said; empty where none does.
std::string other_unit_in_name(const RecordingFormat& format, const SaidUnit& said) {
  for (const std::size_t k : said.places) {
    const std::string& header = format.headers[k];
    const std::string name = header.empty() && k == place_of_fn && format.reads_normal_force
                                 ? std::string(recording_columns[k].header)
                                 : header;
    if (unit_in_name(said.quantity, name).value_or(said.si_per_unit) != said.si_per_unit)
      return printable(name, 60);
  }
  return {};
}

std::string other_force_unit_in_name(const RecordingFormat& format) {
  if (!format.says_force_unit) return {};
  return other_unit_in_name(format, {Quantity::force,
                                     format.newtons_per_unit,
                                     {place_of_fn, place_of_fx, place_of_fx + 1, place_of_fx + 2}});
}

/// "q0", "Q3", "q_w", "quat_x", "roll", "yaw [deg]".
bool names_a_turn(std::string_view name) {
  // Without its unit; more words behind it say that it is something else, as a rate.
  const std::string_view bare = trimmed(name.substr(0, name.find_first_of("[(")));
  std::string word;
  for (const char c : bare)
    if (c != '_' && c != '.') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view angle : {"roll", "pitch", "yaw"})
    for (const std::string_view unit : {"", "deg", "rad"})
      if (word == std::string(angle).append(unit)) return true;
  if (word.starts_with("rotation")) return true;
  return (word.size() == 2 && word[0] == 'q' &&
          std::string_view("01234wxyz").find(word[1]) != std::string_view::npos) ||
         word.starts_with("quat");
}

}  // namespace

void refuse_wild_rate(const MotionReading& reading, double least_hz) {
  const RecordingClock& clock = reading.clock;
  constexpr double most_hz = 1e6;
  if (clock.rate_hz == 0 || (clock.rate_hz >= least_hz && clock.rate_hz <= most_hz)) return;
  throw refused(
      reading.settings.file_path,
      fmt::format("its own rate is {}, and ticks go at 1 to {:.0f} Hz: give rate_hz (is its time in "
                  "seconds? if not, say time_unit)",
                  clock_text(clock), most_hz));
}

void warn_of_named_units(MotionReading& reading) {
  const RecordingFormat& format = reading.settings.format;
  const auto warn = [&reading](const std::string& name, const char* key) {
    if (!name.empty())
      reading.warn(
          fmt::format("its column '{}' says by its name another unit than {} in [motion], which is "
                      "taken: is that meant?",
                      name, key));
  };
  if (format.says_time_unit)
    warn(other_unit_in_name(format, {Quantity::time, format.seconds_per_unit, {0}}), "time_unit");
  if (format.says_unit)
    warn(
        other_unit_in_name(
            format, {Quantity::length, format.metres_per_unit, {place_of_x, place_of_x + 1, place_of_x + 2}}),
        "unit");
}

void note_unread_attitude(MotionReading& reading, const std::vector<std::string>& names) {
  const Motion& motion = reading.motion;
  if (!motion.attitude.empty() || motion.direction_W.cols() > 0) return;
  std::vector<std::string> turns;
  for (const std::string& name : names)
    if (names_a_turn(name)) turns.push_back(printable(name, 60));
  if (turns.empty()) return;
  reading.note(fmt::format(
      "{} {} not read: an orientation is read of qw, qx, qy and qz, or dx, dy and dz; where they are called "
      "otherwise, say columns = {{ qw = \"NAME\", ... }} in [motion]",
      word_list(turns), turns.size() == 1 ? "is" : "are"));
}

void note_unread_trials(MotionReading& reading, const std::vector<std::string>& names) {
  const RecordingFormat& format = reading.settings.format;
  const auto is_read = [&format](const std::string& name) {
    return (format.trial && name == header_of(format, place_of_trial)) ||
           (format.subject && name == header_of(format, place_of_subject));
  };
  for (const std::string& name : trial_names(names)) {
    if (is_read(name)) continue;
    reading.note(fmt::format(
        "the column '{}' is not read: its rows of all numbers are one motion; say trial = N (or subject = N) "
        "to take one, and columns = {{ trial = \"NAME\" }} where it is called otherwise, in [motion]",
        name));
  }
}

void warn_of_leaps(MotionReading& reading) {
  constexpr double quick_m_per_s = 3, times_usual = 20;
  const Motion& motion = reading.motion;
  std::vector<double> moving, all;
  for (std::size_t i = 1; i < motion.t_s.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const double speed_m_per_s =
        (motion.p_WQ.col(column) - motion.p_WQ.col(column - 1)).norm() / (motion.t_s[i] - motion.t_s[i - 1]);
    all.push_back(speed_m_per_s);
    if (speed_m_per_s > 0) moving.push_back(speed_m_per_s);
  }
  if (moving.empty()) return;
  const auto middle = moving.begin() + static_cast<std::ptrdiff_t>(moving.size() / 2);
  std::nth_element(moving.begin(), middle, moving.end());
  const double least_m_per_s = std::max(quick_m_per_s, times_usual * *middle);
  const auto leaps = std::ranges::count_if(all, [&](double speed) { return speed > least_m_per_s; });
  if (leaps == 0 || 20 * leaps > static_cast<std::ptrdiff_t>(all.size())) return;
  const auto first = static_cast<std::size_t>(
      std::ranges::find_if(all, [&](double speed) { return speed > least_m_per_s; }) - all.begin());
  reading.warn(fmt::format(
      "its finger leaps by {} mm within {} ms at t = {} s{}: are rows wrong there, as where a tracker has "
      "lost it? Leave such rows out",
      rounded_text(1e3 * all[first] * (motion.t_s[first + 1] - motion.t_s[first]), 3),
      rounded_text(1e3 * (motion.t_s[first + 1] - motion.t_s[first]), 3),
      rounded_text(motion.t_s[first + 1], 6),
      leaps == 1 ? "" : fmt::format(", and at {} more of its steps", leaps - 1)));
}

void warn_of_one_sample(MotionReading& reading) {
  if (reading.motion.t_s.size() != 1) return;
  const auto& format = reading.settings.format;
  reading.warn(fmt::format("has one row{}{}: the finger is there for one tick, and goes nowhere",
                           format.subject ? fmt::format(" of subject {}", *format.subject) : "",
                           format.trial ? fmt::format(" of trial {}", *format.trial) : ""));
}

void warn_of_odd_steps(MotionReading& reading) {
  const RecordingClock& clock = reading.clock;
  if (clock.odd_steps == 0) return;
  reading.warn(
      fmt::format("its clock is irregular: {} of {} steps are off by more than half, the longest "
                  "is {} ms at t = {} s; in between the finger goes straight",
                  clock.odd_steps, clock.steps, rounded_text(1e3 * clock.longest_s, 3),
                  rounded_text(clock.longest_at_s, 6)));
}

void warn_of_slow_clock(MotionReading& reading) {
  constexpr long fewest_steps = 20;
  constexpr double slowest_recorder_hz = 10, least_likely_hz = 20, most_likely_hz = 20e3, quick_m_per_s = 2;
  const RecordingClock& clock = reading.clock;
  if (reading.says_time_unit || clock.steps < fewest_steps || clock.rate_hz >= slowest_recorder_hz) return;
  const double duration_s = reading.motion.t_s.back() - reading.motion.t_s.front();
  const double speed_m_per_s = way_m(reading.motion) / duration_s;
  for (const TimeUnit& unit : time_units) {
    const double likely_hz = clock.rate_hz / unit.seconds;
    if (likely_hz < least_likely_hz || likely_hz > most_likely_hz) continue;
    if (speed_m_per_s / unit.seconds > quick_m_per_s) continue;
    reading.warn(fmt::format(
        "its samples are {} s apart, {} s in all, if its time is in seconds; time_unit = \"{}\" in "
        "[motion] makes it {} Hz and {} s (time_unit = \"s\" if it is right)",
        rounded_text(1 / clock.rate_hz, 3), rounded_text(duration_s, 4), unit.name,
        rounded_text(likely_hz, 4), rounded_text(duration_s * unit.seconds, 4)));
    return;
  }
}

void warn_of_quick_clock(MotionReading& reading) {
  constexpr long fewest_steps = 20;
  constexpr double quick_hz = 5e3, quick_m_per_s = 2, seconds_per_minute = 60, too_quick_m_per_s = 10;
  const RecordingClock& clock = reading.clock;
  if (clock.steps < fewest_steps) return;
  const double duration_s = reading.motion.t_s.back() - reading.motion.t_s.front();
  const double speed_m_per_s = way_m(reading.motion) / duration_s;
  if (reading.says_time_unit || clock.rate_hz < quick_hz) {
    if (speed_m_per_s > too_quick_m_per_s)
      reading.warn(
          fmt::format("its finger goes at {} m/s on average, as none does: are its positions and "
                      "its times in the units that they are taken in?",
                      rounded_text(speed_m_per_s, 3)));
    return;
  }
  if (!(speed_m_per_s > quick_m_per_s)) return;
  reading.warn(fmt::format(
      "its finger goes at {} m/s on average, {} samples a second, if its time is in seconds, as none does; "
      "time_unit = \"min\" in [motion] makes it {} m/s and {} Hz (time_unit = \"s\" if it is right)",
      rounded_text(speed_m_per_s, 3), rounded_text(clock.rate_hz, 4),
      rounded_text(speed_m_per_s / seconds_per_minute, 3),
      rounded_text(clock.rate_hz / seconds_per_minute, 4)));
}

void warn_of_odd_force(MotionReading& reading) {
  const std::vector<double>& forces_n = reading.motion.normal_force_n;
  if (forces_n.empty()) return;
  const double usual_n = pressed_median_n(forces_n);
  if (usual_n < 0)
    reading.warn(
        fmt::format("its measured normal force is {} N where it presses, and one below 0 presses nothing: "
                    "the finger feels no force there, nor friction; where it is the force on the surface, as "
                    "a plate measures it, say force_on = \"plate\" in [motion]",
                    rounded_text(usual_n, 3)));
  if (usual_n == 0)
    reading.warn(
        "its measured normal force is 0 throughout, so that no force acts: is its column the right one?");
}

void warn_of_force_unit(MotionReading& reading) {
  const Motion& motion = reading.motion;
  const bool is_normal = !motion.normal_force_n.empty();
  if (!is_normal && motion.force_W_n.cols() == 0) return;
  const Eigen::RowVectorXd sizes_n = motion.force_W_n.colwise().norm();
  const double usual_n =
      std::abs(is_normal ? pressed_median_n(motion.normal_force_n)
                         : pressed_median_n({sizes_n.data(), static_cast<std::size_t>(sizes_n.size())}));
  const auto doubt = force_unit_doubt(usual_n, reading.says_force_unit);
  if (!doubt) return;
  // Who has said the unit is believed, unless the table itself says another.
  const std::string name = other_force_unit_in_name(reading.settings.format);
  if (reading.settings.format.says_force_unit && name.empty()) return;
  std::string words = doubt->words(
      is_normal ? "measured normal force" : "measured force",
      [](std::string_view unit) { return fmt::format("force_unit = \"{}\" in [motion]", unit); });
  if (!name.empty())
    words += fmt::format(" (the name of its column '{}' says another than force_unit)", name);
  reading.warn(words);
}

void warn_of_driving_force(MotionReading& reading) {
  const Motion& motion = reading.motion;
  if (motion.force_W_n.cols() == 0 || reading.clock.rate_hz == 0) return;
  if (driving_share(motion.p_WQ, motion.force_W_n, reading.clock.rate_hz) > most_driving_share)
    reading.warn(fmt::format(
        "its measured force drives the finger along its way, and friction holds a finger back: {}",
        reading.settings.format.forces_on_surface
            ? "force_on = \"plate\" turned it round; was it that on the finger already?"
            : "is it that on the surface (force_on = \"plate\")?"));
}

}  // namespace fingerpad
