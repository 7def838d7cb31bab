#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/csv_cells.hpp"

namespace fingerpad {

/// What a column of a recording holds, and what its header calls it unless a scene says otherwise.
struct RecordingColumn {
  std::string_view key, header;
};
inline constexpr std::array<RecordingColumn, 17> recording_columns{{{"t", "t_s"},
                                                                    {"x", "x_m"},
                                                                    {"y", "y_m"},
                                                                    {"z", "z_m"},
                                                                    {"dx", "dx"},
                                                                    {"dy", "dy"},
                                                                    {"dz", "dz"},
                                                                    {"qw", "qw"},
                                                                    {"qx", "qx"},
                                                                    {"qy", "qy"},
                                                                    {"qz", "qz"},
                                                                    {"fx", "fx_n"},
                                                                    {"fy", "fy_n"},
                                                                    {"fz", "fz_n"},
                                                                    {"subject", "subject"},
                                                                    {"trial", "trial"},
                                                                    {"fn", "fn_n"}}};

/// How a recording's table is to be read; as it stands, the program's own.
struct RecordingFormat {
  std::array<std::string, recording_columns.size()> headers = {};  ///< per column, as the file calls it;
                                                                   ///< empty: as recording_columns says
  double metres_per_unit = 1;                                      ///< of positions
  double seconds_per_unit = 1;                                     ///< of times
  double newtons_per_unit = 1;                                     ///< of forces
  CsvDialect dialect = {found_separator, '.'};
  bool reads_normal_force = false;  ///< the column fn must be there; else it is passed over, if not named

  bool ends_each_row = false;      ///< its writer does: a last row without a line end was cut short
  std::string cut, above;          ///< of FieldRecording::read_as: as of CsvColumns
  std::vector<std::string> names;  ///< likewise
  std::string name;                ///< of a row of field_formats(); empty: a table of the program's own kind
  std::string positions_path;      ///< positions with a clock of their own; empty: in the file itself
  bool says_unit = false, says_time_unit = false;  ///< else a named format's own units hold
  std::optional<int> subject, trial;               ///< the rows of these alone, by the columns of their names
  bool forces_on_surface = false;  ///< fx,fy,fz are the load on the surface, not on the finger
  bool is_sensor_turned = false;   ///< fx,fy,fz are in a sensor's axes yet: which is normal is not known

  /// Of a layout that has them, as the file calls them; empty: not asked for. A motion has no use of them, a
  /// measurement has.
  std::array<std::string, 3> torque_headers;
  std::string speed_header;
  double newton_metres_per_unit = 1;  ///< of torques
  bool says_torque_unit = false;      ///< else a named format's own holds
  bool takes_torque = false;          ///< a measurement does, and a speed; a motion has no use of them
  bool says_force_unit = false;       ///< else newtons, or what the table says
};

}  // namespace fingerpad
