#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "motion/recording.hpp"
#include "scene/scene.hpp"
#include "scene/scene_change.hpp"

namespace fingerpad {

/// A file on its way to what the finger follows, and what is to be told of it.
struct MotionReading {
  const Scene& scene;
  const MotionSettings& settings;
  Motion motion;
  RecordingClock clock;
  bool says_time_unit = false;   ///< the scene does, its layout, its line of units, or it is a trace
  bool says_force_unit = false;  ///< likewise
  std::vector<SceneChange> changes;
  std::vector<std::string> notes, warnings;

  /// Files are named as the scene names them: what a trace keeps holds no path of one machine.
  void note(const std::string& what) { notes.push_back(fmt::format("{}: {}", settings.file, what)); }
  void warn(const std::string& what) { warnings.push_back(fmt::format("{}: {}", settings.file, what)); }
};

/// Reads the file: a table of text, or a trace.
void read_file(MotionReading& reading);

/// Whether positions are to be rounded, or smoothed.
bool is_refined(const MotionSettings& settings);
/// Does so.
/// @pre its clock is known
void refine(MotionReading& reading);

/// What is refused there is refused at the file.
template <typename Work>
auto in_file(const MotionSettings& settings, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw refused(settings.file_path, error.what());
  }
}

}  // namespace fingerpad
