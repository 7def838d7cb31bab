#include "trace/made_motion.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/placed_motion.hpp"
#include "scene/scene_reader.hpp"
#include "touch/mesh_store.hpp"
#include "touch/rate_choice.hpp"

namespace fingerpad {
namespace {

std::string shape_text(const SurfaceMotion& rub) {
  const double size_mm = 1e3 * rub.size_m;
  if (rub.shape == SurfaceMotion::Shape::line)
    return fmt::format("a line of {} mm", rounded_text(size_mm, 4));
  return fmt::format("a {} of {} mm radius", rub.shape == SurfaceMotion::Shape::circle ? "circle" : "spiral",
                     rounded_text(size_mm, 4));
}

LoadedMotion laid_motion(const Scene& scene, double rate_hz, MeshStore& meshes) {
  const SurfaceMotion& rub = *scene.motion.laid;
  const PartEntry& part = scene.parts.front();
  const double depth_m = pressed_depth_m(scene);
  const auto mesh = meshes.load(part);
  LaidMotion laid;
  try {
    laid = lay_on_surface(*mesh->tree, rub, scene.finger.radius_m, depth_m, rate_hz);
  } catch (const Error& error) {
    throw refused(scene.path, fmt::format("{}: {}", part.mesh, error.what()));
  }
  place(laid.motion, part.rotation, part.position_m);
  LoadedMotion motion{{std::move(laid.motion), rate_hz, scene.finger.direction}};
  const Vec3 place_mm = 1e3 * laid.place_P;
  const std::string edges = laid.edges == 0 ? ""
                                            : fmt::format(", eased off round {} sharp edge{}", laid.edges,
                                                          laid.edges == 1 ? "" : "s");
  motion.notes.push_back(
      fmt::format("{}: {} at place {} of {}, ({}, {}, {}) mm in its frame, {} mm deep{}; tried {} {}",
                  scene.name, shape_text(rub), rub.place, part.mesh, rounded_text(place_mm.x(), 4),
                  rounded_text(place_mm.y(), 4), rounded_text(place_mm.z(), 4),
                  rounded_text(1e3 * depth_m, 4), edges, laid.tried, laid.tried == 1 ? "point" : "points"));
  return motion;
}

}  // namespace

MotionPose motion_pose(const Scene& scene) {
  const MotionPlacement& placement = scene.motion.placement;
  if (!placement.in_part) return {placement.rotation, placement.position_m};
  const PartEntry& part = scene.parts.front();
  return {part.rotation * placement.rotation, part.position_m + part.rotation * placement.position_m};
}

LoadedMotion scripted_motion(const Scene& scene) {
  ScriptedMotion motion = *scene.motion.scripted;
  if (!scene.motion.placement.is_world()) {
    const MotionPose pose = motion_pose(scene);
    place(motion, pose.rotation, pose.position_m);
  }
  return {{motion, scene.motion.rate_hz, scene.finger.direction}};
}

LoadedMotion at_chosen_rate(const Scene& scene, LoadedMotion motion) {
  if (!scene.motion.automatic_rate) return motion;
  const RateChoice choice = choose_rate(scene, &motion.path);
  motion.path = motion.path.with_rate(choice.rate_hz);
  motion.notes.push_back(fmt::format("{}: {}", scene.name, choice.reason));
  if (scene.hand) refuse_hand_too_quick(*scene.hand, choice.rate_hz, scene.path);
  return motion;
}

LoadedMotion laid_at_chosen_rate(const Scene& scene, MeshStore& meshes) {
  const double first_hz = scene.motion.rate_hz;
  LoadedMotion motion = at_chosen_rate(scene, laid_motion(scene, first_hz, meshes));
  const double chosen_hz = motion.path.rate_hz();
  if (chosen_hz == first_hz) return motion;
  LoadedMotion again = laid_motion(scene, chosen_hz, meshes);
  again.notes.push_back(motion.notes.back());  // why that rate
  return again;
}

}  // namespace fingerpad
