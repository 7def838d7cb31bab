#include "motion/open_layout.hpp"

// SENS3 (Balasubramanian, Kodak, Vardar 2024, "SENS3: Multisensory Database of Finger-Surface Interactions
// and Corresponding Sensations", arXiv:2401.01818; www.sens3.net): contact forces and torques, positions,
// accelerations, temperatures of bare fingers on fifty surfaces, recorded by sensors of different rates.
//
// From its description: a bare finger; forces in N and torques in N mm of a six-axis sensor, positions and
// speeds. Not verified, since no file was at hand: the names of files and columns, which of the axes is the
// normal one, the sense of the forces and torques, the point that torques are about (taken: the origin of the
// sensor's axes, which --sensor-at places), the unit of positions, whether height is recorded; of speeds
// whether they stand beside the positions (taken) and in their unit a second (held against the positions, and
// told where they do not agree). So columns and unit are asked for, and the sense is checked by the sign of
// the normal force.

namespace fingerpad {
namespace {

FieldRecording read_sens3(const std::string& path, const RecordingFormat& format) {
  return read_open_layout(path, format,
                          {.format = "sens3", .newton_metres_per_unit = 1e-3, .is_planar = true});
}

}  // namespace

FieldFormat sens3_format() noexcept {
  return {"sens3",
          "SENS3, finger-surface interactions; columns and unit to be said",
          "a bare finger",
          true,
          open_layout_files,
          read_sens3,
          open_layout_keys,
          true,
          true};
}

}  // namespace fingerpad
