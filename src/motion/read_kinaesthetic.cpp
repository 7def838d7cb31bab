#include "motion/open_layout.hpp"

// Kinaesthetic recordings of the IEEE 1918.1.1 reference software (IEEE Std 1918.1.1, "Haptic Codecs for the
// Tactile Internet"; opensource.ieee.org/haptic-codecs/kinesthetic): positions, velocities and forces of a
// haptic device's handle, as CSV.
//
// Not verified, since neither the standard's annex nor a file was at hand: the names and the order of
// columns, units, rate, and whether the force is that on the hand. So columns and unit are asked for, and the
// sense is checked by the sign of the normal force. Velocities are not read: the positions give them, and a
// speed that is named is held against these.

namespace fingerpad {
namespace {

FieldRecording read_kinaesthetic(const std::string& path, const RecordingFormat& format) {
  return read_open_layout(path, format, {.format = "ieee-1918-kinaesthetic"});
}

}  // namespace

FieldFormat kinaesthetic_format() noexcept {
  return {"ieee-1918-kinaesthetic",
          "kinaesthetic CSV of the IEEE 1918.1.1 reference software; columns and unit to be said",
          "a haptic device's handle",
          false,
          open_layout_files,
          read_kinaesthetic,
          open_layout_keys,
          true,
          true};
}

}  // namespace fingerpad
