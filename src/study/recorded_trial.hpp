#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "base/unit_row.hpp"

namespace fingerpad {

/// Whether a sample was recorded. A gap of a few samples is filled with the straight line over it; of a
/// longer one nothing is known.
enum class SampleOrigin : unsigned char { recorded, filled, missing };

/// Where a six-axis sensor stands that tells the contact point on the plate.
struct ContactSensor {
  Vec3 origin_W = Vec3::Zero();  ///< of its axes [m]
  double plate_height_m = 0;     ///< of the plate's surface over W's origin, along the plate's normal
};

/// A line near a frequency of the mains, in a trial's forces, that is not taken out.
struct LineLeftIn {
  double nominal_hz = 0;   ///< 50 or 60
  double amplitude_n = 0;  ///< the greatest of the axes
};

/// One trial as the sensors recorded it: in SI units and the recording's own axes W, at even steps.
/// Sample i was taken at start_s + i / rate_hz.
struct RecordedTrial {
  std::string file;
  int subject = 0, number = 0;
  int piece = 0;  ///< from 1, of a trial that was read in several pieces; 0: it is whole
  double start_s = 0;
  double rate_hz = 0;
  Points position_W;                 ///< 3 x n, the fingertip [m]
  Points force_W;                    ///< 3 x n, on the finger [N]
  std::vector<SampleOrigin> origin;  ///< n
  /// Where positions are contact points that a sensor tells: they are told anew once its tare is off.
  std::optional<ContactSensor> sensor;
  Points torque_W_n_m;  ///< 3 x n, on the finger, about the sensor's origin; else empty
  Points tracked_W;     ///< 3 x n, of what is tracked beside: its height, and its place where nothing presses
  Vec3 normal_W = Vec3::UnitZ();    ///< of the plate, outward, unit: the trial's mean
  Vec3 direction_W = Vec3::Zero();  ///< of the finger, towards the tip, unit: the trial's mean; zero: unknown
  /// "column fx_n missing", where the force along z alone was measured: force_W has no more. Empty: it is
  /// whole.
  std::string lacks;
  std::vector<LineLeftIn> lines_left_in;
  double least_angle_deg = 0, most_angle_deg = 0;  ///< finger against plate within the trial

  Eigen::Index samples() const noexcept { return position_W.cols(); }
  bool has_direction() const noexcept { return direction_W.squaredNorm() > 0; }
  /// Where the finger was seen, which no sensor's zero moves: which of the points, and they. 3 x n
  Points RecordedTrial::*seen() const noexcept {
    return tracked_W.cols() > 0 ? &RecordedTrial::tracked_W : &RecordedTrial::position_W;
  }
  const Points& seen_W() const noexcept { return this->*seen(); }
};

/// "FILE, subject 1, trial 3", and ", piece 2" of one in pieces.
std::string trial_name(const RecordedTrial& trial);

/// What the readers of measurements yield, whatever the file's layout was.
struct RecordedMeasurement {
  std::vector<RecordedTrial> trials;  ///< by file, and in each file's order
  std::vector<std::string>
      without_force;       ///< "FILE: column fx_n missing", of files that hold nothing for a fit
  std::string force_mend;  ///< what to say of the last of them, where it has the force by another name
  std::vector<std::string> notes;               ///< how files were read, for people: "FILE: ..."
  std::vector<std::string> warnings;            ///< what in them is not as it should be
  std::map<std::string, ToldUnits> told_units;  ///< by file, of those whose tables tell them
};

}  // namespace fingerpad
