#pragma once

#include <functional>
#include <string>

#include "scene/scene.hpp"
#include "touch/closed_loop.hpp"

namespace fingerpad {

/// A scene made in code for the studies: one plane z = 0, outward +z, one finger, one law. The tick is the
/// very one that replay and live touch use.
class BenchScene {
 public:
  explicit BenchScene(double rate_hz, const std::string& law = "none");

  Scene& scene() noexcept { return scene_; }
  SurfaceProperties& surface() noexcept { return scene_.planes.front().surface; }
  /// Puts the finger into a simulated hand.
  HandSettings& hold(const HandSettings& hand);

  /// The loop over a motion given as position against time, taken at the very ticks.
  ClosedLoop loop(double seconds, const std::function<Vec3(double t_s)>& position_W) const;

 private:
  Scene scene_;
};

}  // namespace fingerpad
