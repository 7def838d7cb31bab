#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/types.hpp"
#include "motion/recording_format.hpp"

namespace fingerpad {

/// Columns of a measurement's table: what `columns` calls them, and the headers they have unless it says
/// otherwise. Time, place and direction are those of a recorded motion.
inline constexpr std::array<RecordingColumn, 26> measurement_columns{{
    {"t", "t_s"},
    {"x", "x_m"},
    {"y", "y_m"},
    {"z", "z_m"},  // the fingertip
    {"fx", "fx_n"},
    {"fy", "fy_n"},
    {"fz", "fz_n"},  // force on the finger
    {"nx", "nx"},
    {"ny", "ny"},
    {"nz", "nz"},  // the plate's normal
    {"dx", "dx"},
    {"dy", "dy"},
    {"dz", "dz"},  // the finger's direction
    {"m1x", "m1x_m"},
    {"m1y", "m1y_m"},
    {"m1z", "m1z_m"},  // marker on the proximal segment
    {"m2x", "m2x_m"},
    {"m2y", "m2y_m"},
    {"m2z", "m2z_m"},  // and on the distal one
    {"tx", "tx_n_m"},
    {"ty", "ty_n_m"},
    {"tz", "tz_n_m"},  // torque of a six-axis sensor
    {"subject", "subject"},
    {"trial", "trial"},
    {"fn", "fn_n"},              // fn: normal force alone
    {"speed", "speed_m_per_s"},  // of a published layout that records it
}};

/// Where the fingertip is beside two markers on the finger's back (paper, fig. 3).
struct TwoMarkers {
  double tip_beyond_m = 0;  ///< from the distal marker on, along the line from the proximal to the distal one
  double tip_below_m = 0;   ///< and from there towards the plate, square to that line
};

/// How a six-axis sensor stands in W. Its force and torque are turned into W; where torque is recorded, the
/// contact point on the plate is told from both.
struct SixAxisSensor {
  Mat3 rotation_WS = Mat3::Identity();
  Vec3 origin_W = Vec3::Zero();  ///< of its axes [m]
  double plate_height_m = 0;     ///< of the plate's surface over W's origin, along the plate's normal
  bool says_place = false;       ///< the origin was said, which torque alone makes use of
};

/// How a measurement's files are to be read; as it stands, the program's own tables.
struct MeasurementFormat {
  std::array<std::string, measurement_columns.size()> headers = {};  ///< per column; empty: as the table says
  double metres_per_unit = 1;                                        ///< of positions and markers
  double seconds_per_unit = 1;                                       ///< of times
  double newtons_per_unit = 1;                                       ///< of forces
  double newton_metres_per_unit = 1;                                 ///< of torques
  CsvDialect dialect = {found_separator, '.'};
  std::string positions_path;  ///< of a layout that has positions in a file of their own; else empty
  bool says_unit = false, says_time_unit = false;  ///< else a published layout's own units hold
  bool says_force_unit = false, says_torque_unit = false;
  bool force_on_plate = false;        ///< forces are those on the plate: the finger's, turned round
  std::optional<TwoMarkers> markers;  ///< positions and direction come from them
  std::optional<SixAxisSensor> sensor;
};

}  // namespace fingerpad
