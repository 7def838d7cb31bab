#include "device/device_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fingerpad {

const DeviceEntry* find_device(std::string_view name) noexcept {
  const auto table = device_table();
  const auto found = std::find_if(table.begin(), table.end(), [name](const DeviceEntry& entry) {
    return entry.name == name || (!name.empty() && entry.also == name);
  });
  return found == table.end() ? nullptr : &*found;
}

std::string device_help_text() {
  std::string text = "\nDevices for --device:\n";
  for (const DeviceEntry& device : device_table()) {
    const std::string also = device.also.empty() ? "" : fmt::format(" (also '{}')", device.also);
    text += fmt::format("  {:<17}{}{}\n", device.name, device.doc, also);
  }
  return text;
}

}  // namespace fingerpad
