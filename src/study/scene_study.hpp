#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/choice_price.hpp"
#include "study/motion_stretches.hpp"
#include "study/report.hpp"

namespace fingerpad {

/// Told how far a study is, 0 .. 1, and what it does.
using SceneStudyProgress = std::function<void(double share_done, const std::string& what)>;

/// What a scene is to be studied with.
struct SceneStudyInput {
  const Scene& scene;                         ///< with a rate
  std::shared_ptr<const World> world;         ///< of it
  const FingerPath& path;                     ///< what its finger follows
  std::optional<TouchChoice> automatic = {};  ///< what `auto` takes for all that it can choose, to be marked
};

/// What every choice costs and loses over a scene's own motion.
struct SceneStudy {
  std::vector<ChoicePrice> prices;  ///< in the order of touch_choices()
  TouchChoice model;
  double model_tick_ns = 0;
  long model_ticks = 0;
  double compared_s = 0;  ///< of the motion
  bool has_friction = false, has_events = false, has_meshes = false;
};

/// Runs every choice over the scene's motion (motion_stretches), one after the other on this thread, so that
/// their times are those of a quiet machine. All but the times is the same at every run.
/// Throws Error (refused) where the model touches nothing: then nothing can be compared.
SceneStudy study_scene(const SceneStudyInput& input, const SceneStudyProgress& progress);

/// choices.csv: a row a choice, the model's the last.
StudyTable choices_table(const SceneStudyInput& input, const SceneStudy& study);
/// The chart "choices".
Chart scene_chart(const SceneStudyInput& input, const SceneStudy& study);

/// The cheapest choice that keeps the scene's tolerances, as the lines of a scene file to paste, below
/// comments that say why and what the next cheaper one would have lost.
std::string scene_lines(const SceneStudyInput& input, const SceneStudy& study);

/// The same in a line for a person.
std::string scene_verdict(const SceneStudyInput& input, const SceneStudy& study);

}  // namespace fingerpad
