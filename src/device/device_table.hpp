#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "device/live_device.hpp"

namespace fingerpad {

/// One row of the table of live devices.
struct DeviceEntry {
  std::string_view name;  ///< as `--device` takes it
  std::string_view doc;   ///< what moves the finger, in a line
  /// @param setup  outlives the call only
  std::unique_ptr<LiveDevice> (*make)(const DeviceSetup& setup);
  std::string_view also{};                      ///< another name that `--device` takes
  bool needs_window = false;                    ///< it follows what is done there
  bool takes_port = false, takes_bind = false;  ///< of DeviceLink
  bool reads_settings = false;                  ///< [device] of the scene: all of it, or how it lies
  /// The rate of its own motion, where it has one; null: the scene's.
  double (*rate_hz)(const Scene& scene) = nullptr;
  /// Throws Error, as make() would, where the scene or the link will not do; before the scene's parts are
  /// loaded, which may take long. Null: nothing is looked at.
  void (*refuse)(const Scene& scene, const DeviceLink& link) = nullptr;
};

/// All live devices, the default one first.
std::span<const DeviceEntry> device_table() noexcept;
/// The row of a name; nullptr if there is none.
const DeviceEntry* find_device(std::string_view name) noexcept;

/// The table for a help text.
std::string device_help_text();

}  // namespace fingerpad
