#include <array>

#include "device/device_table.hpp"

namespace fingerpad {

// Each device is defined in the file of its name; its line here makes it known to `touch --device`, help and
// tests.
DeviceEntry pointer_device() noexcept;
DeviceEntry keyboard_device() noexcept;
DeviceEntry spacemouse_device() noexcept;
DeviceEntry recorded_device() noexcept;
DeviceEntry hand_device() noexcept;
DeviceEntry network_device() noexcept;
DeviceEntry haply_device() noexcept;

std::span<const DeviceEntry> device_table() noexcept {
  static const std::array table{pointer_device(), keyboard_device(), spacemouse_device(), recorded_device(),
                                hand_device(),    network_device(),  haply_device()};
  return table;
}

}  // namespace fingerpad
