#pragma once

#include "trace/motion_source.hpp"

namespace fingerpad {

/// What takes a motion's own coordinates to the world.
struct MotionPose {
  Mat3 rotation;
  Vec3 position_m;
};

MotionPose motion_pose(const Scene& scene);

/// The motion that the scene writes down, where it says.
LoadedMotion scripted_motion(const Scene& scene);

/// At the rate that a scene leaves to the program, and that told; as it is where it leaves none.
LoadedMotion at_chosen_rate(const Scene& scene, LoadedMotion motion);

/// The motion that the scene lays on its first part, at that rate. It is laid for ticks of one rate: where
/// that is chosen by a motion, anew at that rate.
LoadedMotion laid_at_chosen_rate(const Scene& scene, MeshStore& meshes);

}  // namespace fingerpad
