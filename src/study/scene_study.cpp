#include "study/scene_study.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "scene/scene.hpp"
#include "touch/rate_choice.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// The model's runs, one a stretch.
struct Model {
  std::vector<MotionStretch> stretches;
  std::vector<StretchRun> runs;
};

/// How long a choice takes, as a share of all: its ticks.
double all_ticks_hz(const std::vector<TouchChoice>& choices) {
  return std::accumulate(choices.begin(), choices.end(), model_rate_hz,
                         [](double sum, const TouchChoice& choice) { return sum + choice.rate_hz; });
}

/// Few ticks are timed again, so that the caches' first filling is not taken for the choice's.
constexpr std::size_t enough_ticks = 10000;
constexpr int most_passes = 4;

/// The choice over all stretches once. @returns the ticks' times [ns]
std::vector<float> pass(const SceneStudyInput& input, const TouchChoice& choice, const Model& model,
                        ForceComparison& comparison) {
  std::vector<float> times_ns;
  for (std::size_t i = 0; i < model.stretches.size(); ++i) {
    const StretchRun run = run_stretch(input.world, input.scene, input.path, choice, model.stretches[i]);
    comparison.add(run, model.runs[i]);
    times_ns.insert(times_ns.end(), run.tick_ns.begin(), run.tick_ns.end());
  }
  return times_ns;
}

ChoicePrice price_of(const SceneStudyInput& input, const TouchChoice& choice, const Model& model) {
  const Promises promises(input.scene.contact);
  ChoicePrice price{choice, {}, rate_figures(model.runs, choice.rate_hz), 0, 0, {}};
  ForceComparison comparison(promises);
  const std::vector<float> times_ns = pass(input, choice, model, comparison);
  price.figures = comparison.figures();
  const double tick_ns = 1e9 / choice.rate_hz;
  price.late_ticks = std::count_if(times_ns.begin(), times_ns.end(),
                                   [&](float took_ns) { return static_cast<double>(took_ns) > tick_ns; });
  price.tick_ns = mean_tick_ns(times_ns);
  for (int passes = 1;
       passes < most_passes && times_ns.size() * static_cast<std::size_t>(passes) < enough_ticks; ++passes) {
    ForceComparison same(promises);
    price.tick_ns = std::min(price.tick_ns, mean_tick_ns(pass(input, choice, model, same)));
  }
  price.broken = broken_promises(price.figures, price.rate, promises);
  const std::string unstable = unstable_because(input.scene, choice.rate_hz);
  if (!unstable.empty()) price.broken.push_back(unstable);
  return price;
}

Model run_model(const SceneStudyInput& input, SceneStudy& study) {
  Model model{motion_stretches(input.world, input.scene, input.path), {}};
  std::vector<float> times_ns;
  double touched = 0;
  for (const MotionStretch& stretch : model.stretches) {
    model.runs.push_back(run_stretch(input.world, input.scene, input.path, study.model, stretch));
    const StretchRun& run = model.runs.back();
    times_ns.insert(times_ns.end(), run.tick_ns.begin(), run.tick_ns.end());
    for (const float n : run.normal_n) touched += n > 0 ? 1 : 0;
    for (const Vec3& friction_n : run.friction_W_n) study.has_friction |= friction_n != Vec3::Zero();
    study.compared_s += stretch.end_s - stretch.counted_s;
  }
  study.model_ticks = static_cast<long>(times_ns.size());
  study.model_tick_ns = mean_tick_ns(std::move(times_ns));
  if (touched == 0) {
    throw refused(
        input.scene.path,
        "its finger touches nothing in what was looked at of its motion, so that there is nothing to "
        "compare; is a unit wrong? (replay says how near it comes)");
  }
  return model;
}

}  // namespace

SceneStudy study_scene(const SceneStudyInput& input, const SceneStudyProgress& progress) {
  const std::vector<TouchChoice> choices = touch_choices(input.scene, *input.world);
  SceneStudy study;
  study.model = model_choice();
  study.has_events = std::any_of(choices.begin(), choices.end(),
                                 [](const TouchChoice& choice) { return choice.events == Events::tick; });
  study.has_meshes = !needs_no_method(*input.world);
  prepare_normals(*input.world);
  progress(0, "the model: " + study.model.name());
  const Model model = run_model(input, study);
  const double all_hz = all_ticks_hz(choices);
  double done_hz = model_rate_hz;
  for (const TouchChoice& choice : choices) {
    progress(done_hz / all_hz, choice.name());
    study.prices.push_back(price_of(input, choice, model));
    done_hz += choice.rate_hz;
  }
  progress(1, "done");
  return study;
}

}  // namespace fingerpad
