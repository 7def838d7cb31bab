#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"
#include "fingerpad/attitude.hpp"
#include "motion/recorded_table.hpp"
#include "motion/recording_format.hpp"

namespace fingerpad {

/// A recorded finger motion: where the finger point Q was, and optionally how the finger lay.
struct Motion {
  std::vector<double> t_s;  ///< n, strictly increasing, finite
  Points p_WQ;              ///< 3 x n, column i at t_s[i] [m]
  Points direction_W;       ///< 3 x n unit vectors towards the fingertip, or 3 x 0 where the motion has none
  Points push_W_n;          ///< 3 x n, what a hand pushed the finger with, or 3 x 0 [N]
  std::vector<Attitude> attitude;      ///< n, how the finger was turned, or none
  std::vector<double> normal_force_n;  ///< n, the normal force as it was measured, or none [N]
  Points force_W_n;                    ///< 3 x n, the measured force on the finger, or 3 x 0 [N]
  Points
      velocity_W;  ///< 3 x n, where the recording gives more of it than its positions' differences, or 3 x 0
};

/// Why a finger cannot be at `p_W` at `t_s`: numbers that are not finite, or larger than any recording's in
/// metres and seconds; empty where it can.
std::string sample_fault(double t_s, const Vec3& p_W);
/// Why a finger cannot press with such a normal force; empty where it can.
std::string force_fault(double normal_force_n);
/// Throws Error (refused) where a format says on what a force acts (forces_on_surface) or in what unit it is,
/// and names none.
void refuse_words_of_no_force(const std::string& path, const RecordingFormat& format);

/// The motion that a table has in its rows. A measured force is taken where the table has all of fx, fy, fz.
/// Throws Error (refused, at the row) as read_motion_csv.
Motion motion_of_table(const RecordedTable& recording, const RecordingFormat& format);

/// Reads a motion table: a header line naming t_s,x_m,y_m,z_m and optionally dx,dy,dz and qw,qx,qy,qz, or the
/// names that `format` gives them, in any order; other columns are passed over, so a trace written as CSV is
/// a motion too. What `format` names must be there; a measured force is read where it names all of fx, fy,
/// fz. Throws Error (refused, `file:line`) on a missing column, a word that is no number, numbers that are
/// not finite or beyond sample_fault's bounds, times that do not increase, or no rows.
/// A line of units below the header is read too ("s,mm,mm,mm"), and refused where it contradicts `format`.
/// @param format  given the separator and the units that the file has
Motion read_motion_csv(const std::string& path, RecordingFormat& format);
/// As above, of a table in the program's own form.
Motion read_motion_csv(const std::string& path);

}  // namespace fingerpad
