#include "motion/open_layout.hpp"

// Finger friction at 4TU.ResearchData (Balasubramanian, Pool, Vardar 2025, "Data underlying the publication:
// Sliding Speed Influences Electrovibration-Induced Finger Friction Dynamics on Touchscreens",
// doi:10.4121/d9f05363-d7d3-411a-9f3a-d78e49b4d3c5): contact forces of ten bare index fingers that slid over
// a touchscreen at 20 to 100 mm/s with 0.2 to 0.6 N.
//
// From its description: CSV, a bare finger, forces. Not verified, since no file was at hand: the names of
// files and columns, units, axes and the sense of the forces, and where positions are recorded, if they are.
// So columns and unit are asked for. (An electrovibration that is switched on is no friction of the finger's
// own: choose trials without.)

namespace fingerpad {
namespace {

FieldRecording read_finger_friction(const std::string& path, const RecordingFormat& format) {
  return read_open_layout(path, format,
                          {.format = "4tu-finger-friction", .metres_per_unit = 0, .is_planar = true});
}

}  // namespace

FieldFormat finger_friction_4tu_format() noexcept {
  return {"4tu-finger-friction",
          "finger friction on touchscreens at 4TU.ResearchData; columns and unit to be said",
          "a bare finger",
          true,
          open_layout_files,
          read_finger_friction,
          open_layout_keys,
          true,
          true};
}

}  // namespace fingerpad
