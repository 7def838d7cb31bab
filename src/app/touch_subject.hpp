#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/device_table.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What the command line of `touch` says.
struct TouchOptions {
  std::string subject, record;
  std::string device{device_table().front().name};
  std::string unit = "mm";
  std::string size = "1280x800";
  std::optional<double> rate_hz, seconds;
  DeviceLink link;
  bool headless = false, force = false, real_time = false;
};

/// What is touched, ready to be.
struct Touched {
  std::string subject;
  Scene scene;
  std::optional<HandSettings> hand;  ///< the scene's, which has none left: a person holds the finger
  std::shared_ptr<const World> world;
};

/// Loads what is to be touched and tells what there is to tell of it. Throws Error for what cannot be
/// touched, or not recorded.
Touched load_touched(const TouchOptions& options, const std::string& subject);

}  // namespace fingerpad
