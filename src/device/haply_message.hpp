#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "device/workspace.hpp"

// What the Haply Inverse Service and its client say to each other (its public protocol, 3.5): JSON over a
// WebSocket. The first frame is an inventory; each message of the client is answered by one state.

namespace fingerpad {

/// One frame of the service.
struct HaplyFrame {
  std::string device_id;  ///< of the first Inverse3; empty: none is plugged in
  DevicePlace place;      ///< its cursor; turned as a VerseGrip is, where there is one
};

/// Reads a frame. Nothing where it is no such JSON, or has a number that is beyond 1e3 m, or a turn that is
/// no unit quaternion.
std::optional<HaplyFrame> read_haply_frame(std::string_view text);

/// The force on a device's cursor [N], also where it is 0: the service answers what it is sent.
/// @param profile_name  tells the service who it is, in the first message alone; else empty
std::string haply_message(const std::string& device_id, const Vec3& force_D_n,
                          const std::string& profile_name);

}  // namespace fingerpad
