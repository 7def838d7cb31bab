#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// One trial of a measured finger on a flat plate: what the pad did in the plate's plane, in the pad's own
/// axes (x lateral, y longitudinal, as the friction laws take them).
struct MeasuredTrial {
  int subject = 0;
  std::string name;  ///< "FILE, trial 3", for messages
  double rate_hz = 0;
  std::vector<Vec2> position_m;   ///< of the finger
  std::vector<Vec2> force_ratio;  ///< q: tangential force on the finger over the normal force
  std::vector<bool> starts_anew;  ///< the sample does not follow the one before: samples or contact missed
  bool has_direction = false;     ///< else the axes are arbitrary
  double inclination_deg = 0;     ///< mean, finger against the plate
};

/// Measurements of one or several subjects.
struct Measurement {
  std::vector<MeasuredTrial> trials;   ///< with contact, by file and in the file's order
  std::vector<std::string> untouched;  ///< names of trials whose finger never presses
  std::vector<std::string>
      without_force;  ///< "FILE: column fx_n missing", of files that hold nothing for a fit
};

/// Reads CSV tables `t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n` (force on the finger) with optionally `nx,ny,nz`
/// (default 0,0,1), `dx,dy,dz` (finger direction, towards the tip), `subject` and `trial` (whole numbers). A
/// trial is a run of rows of one file, subject and trial. Throws Error (refused) as read_csv_columns, and
/// where times do not increase within a trial, or normals or directions have no length.
Measurement read_measurements(const std::vector<std::string>& paths);

}  // namespace fingerpad
