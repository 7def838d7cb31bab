#include "study/judged_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <set>

#include "base/error.hpp"
#include "contact/part_measures.hpp"
#include "part/import.hpp"
#include "scene/scene_file.hpp"
#include "study/contact_runs.hpp"
#include "study/touch_choice.hpp"
#include "touch/closed_loop.hpp"
#include "touch/contact_case.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

constexpr double judged_ball_m = 0.007;
/// Bad places of a real part are often small: with fewer strokes one alone would decide the 99 %.
constexpr int part_trial_strokes = 96;
/// Parts less wide are touched to their scale.
constexpr double whole_scale_m = 0.02;

Scene open_scene(const std::string& name, double radius_m) {
  Scene scene;
  scene.name = name;
  scene.contact.method = automatic_method;
  scene.contact.automatic_normals = true;
  scene.friction.law = "none";
  scene.finger.radius_m = radius_m;
  return scene;
}

/// A world of one part, measured once for all scenes.
struct MeasuredWorld {
  std::shared_ptr<const World> world;
  PartMeasures measures;

  explicit MeasuredWorld(std::shared_ptr<const World> one_part)
      : world(std::move(one_part)),
        measures(measure_part(*world->surfaces[0].part, *world->surfaces[0].tree)) {}
  /// With the choice for a scene.
  std::shared_ptr<const World> chosen_for(const Scene& scene) const {
    auto chosen = std::make_shared<World>(*world);
    settle_contact(*chosen, scene, {&measures, 1});
    return chosen;
  }
};

/// Pressed with the lightest force that the promise speaks of, with four times as much, and with the greatest
/// where the surface is known so deep.
JudgedCase exact_case(const ExactSurface& surface, const MeasuredWorld& measured, double radius_m) {
  const double stiffness_n_per_m = measured.world->surfaces[0].properties.stiffness_n_per_m;
  const std::string name =
      fmt::format("{} of {} facets, {}", surface.name, measured.world->surfaces[0].part->triangle_count(),
                  radius_m > 0 ? "a ball" : "a point");
  const Scene scene = open_scene(name, radius_m);
  JudgedCase judged{name, scene, measured.chosen_for(scene)};
  for (const double share : {0.1, 0.4, 1.0}) {
    const double under_m = share * scene.contact.greatest_force_n / stiffness_n_per_m - radius_m;
    if (under_m > surface.deepest_m) continue;
    judged.ways.push_back(way_through(rub_under(surface, under_m, radius_m).positions, scene));
  }
  const double greatest_under_m = scene.contact.greatest_force_n / stiffness_n_per_m - radius_m;
  judged.is_exact_all_over = surface.is_whole && greatest_under_m <= surface.deepest_m;
  judged.exact_force_n = [foot = surface.foot, radius_m, stiffness_n_per_m](const Vec3& p) -> Vec3 {
    const ExactFoot at = foot(p);
    return stiffness_n_per_m * std::max(0.0, radius_m - at.signed_distance_m) * at.normal;
  };
  return judged;
}

/// What tells a job's part and motion from those of others, whatever its contact and its friction.
std::string place_of(const SceneJob& job) {
  std::string key = job.scene.name;
  for (const auto& [name, value] : job.set_keys) {
    if (!name.starts_with("contact.") && !name.starts_with("friction."))
      key += fmt::format(" {}={}", name, value);
  }
  return key;
}

JudgedCase scene_case(Scene scene, const std::string& name) {
  scene.contact.method = automatic_method;
  scene.contact.automatic_normals = true;
  scene.friction = {};
  scene.friction.law = "none";
  scene.hand.reset();
  const FingerPath path = load_finger_path(scene);
  JudgedCase judged{name, at_rate(scene, path), nullptr, {path}};
  const auto world = load_world(judged.scene);
  prepare_normals(*world);
  judged.world = world;
  return judged;
}

void take_scene_file(const std::string& file, const TakeCase& take) {
  std::set<std::string> seen;
  for (const SceneJob& job : read_scene_file(file).jobs) {
    if (!job.error.empty() || job.scene.parts.empty() || !job.scene.motion.given()) continue;
    const std::string name = place_of(job);
    if (seen.insert(name).second) take(scene_case(job.scene, name));
  }
}

}  // namespace

FingerPath way_through(const std::vector<Vec3>& places_W, const Scene& scene) {
  Motion way;
  way.p_WQ.resize(3, static_cast<Eigen::Index>(places_W.size()));
  for (std::size_t k = 0; k < places_W.size(); ++k) {
    way.t_s.push_back(static_cast<double>(k) / scene.motion.rate_hz);
    way.p_WQ.col(static_cast<Eigen::Index>(k)) = places_W[k];
  }
  return {std::move(way), scene.motion.rate_hz, scene.finger.direction};
}

void take_exact_cases(const TakeCase& take, const std::string& surface_name, int most_levels) {
  std::vector<ExactSurface> surfaces = exact_surfaces(most_levels);
  for (ExactSurface& small : small_exact_surfaces(most_levels)) surfaces.push_back(std::move(small));
  for (const ExactSurface& surface : surfaces) {
    if (!surface_name.empty() && surface.name != surface_name) continue;
    for (const int level : surface.levels) {
      const MeasuredWorld measured(world_of_mesh(surface.mesh(level), surface.name));
      take(exact_case(surface, measured, 0));
      take(exact_case(surface, measured, judged_ball_m));
    }
  }
}

void take_scene_cases(const std::string& folder, const TakeCase& take) {
  for (const std::string& where : {folder, folder + "/gallery"}) {
    for (const std::string& file :
         files_of(where, [](const std::string& ending) { return ending == ".toml"; })) {
      try {
        take_scene_file(file, take);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::refused) throw;
      }
    }
  }
}

void take_part_cases(const std::string& file, int strokes, const TakeCase& take) {
  const auto part = import_part(file, 1e-3, std::numbers::pi / 6).part;
  if (!part) return;
  const std::string name = std::filesystem::path(file).filename().string();
  const auto world = std::make_shared<World>(*world_of_part(part, name));
  // A part as small as a bead is touched by a finger, and with forces, to its scale.
  const double scale = touch_scale(*part);
  world->surfaces[0].properties.stiffness_n_per_m /= scale;
  const MeasuredWorld measured(world);
  for (const double radius_m : {0.0, judged_ball_m * scale}) {
    const Scene scene = open_scene(name + (radius_m > 0 ? ", a ball" : ", a point"), radius_m);
    JudgedCase judged{scene.name, scene, measured.chosen_for(scene)};
    judged.ways = strokes_over(judged.world->surfaces[0], scene, {strokes, scale});
    judged.trial_strokes = part_trial_strokes;
    if (!judged.ways.empty()) take(judged);
  }
}

double touch_scale(const Part& part) noexcept {
  return std::min(1.0, across_m(part) / whole_scale_m);
}

std::vector<std::string> files_of(const std::string& folder, bool (*is_one)(const std::string& ending)) {
  std::vector<std::string> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    if (is_one(entry->path().extension().string())) files.push_back(entry->path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace fingerpad
