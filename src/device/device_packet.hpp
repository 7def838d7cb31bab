#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/types.hpp"

// The packets of `--device network`: UDP, 80 bytes either way, little-endian.
//
//   from the device                              to the device
//    0 "FPD1"                                     0 "FPF1"
//    4 u32 sequence, from 1, growing              4 u32 sequence of the answer
//    8 u64 its clock, ns                          8 u32 sequence of the last packet accepted
//   16 3 f64 position, m, device frame           12 u32 status, AnswerStatus
//   40 4 f64 orientation w, x, y, z              16 u64 the program's clock, ns
//   72 u32 buttons, PacketButton                 24 3 f64 force on the finger, N, device frame
//   76 u32 flags, PacketFlag                     48 3 f64 torque, N m; 72 f64 depth, m

namespace fingerpad {

inline constexpr std::size_t packet_bytes = 80;
using PacketBytes = std::array<unsigned char, packet_bytes>;

enum PacketButton : std::uint32_t { button_clutch = 1u << 0, button_emergency_stop = 1u << 31 };
enum PacketFlag : std::uint32_t { flag_has_orientation = 1u << 0 };
enum AnswerStatus : std::uint32_t {
  status_touching = 1u << 0,
  status_stick = 1u << 1,
  status_slip = 1u << 2,
  status_limited = 1u << 3,   ///< the force is not the model's
  status_watchdog = 1u << 4,  ///< has tripped since the last answer
  status_stopped = 1u << 5    ///< by the emergency stop
};

/// What a device says.
struct DevicePacket {
  std::uint32_t sequence = 0;
  std::uint64_t clock_ns = 0;
  Vec3 position_m = Vec3::Zero();
  std::array<double, 4> orientation_wxyz{1, 0, 0, 0};
  std::uint32_t buttons = 0, flags = 0;
};

/// What it is answered.
struct AnswerPacket {
  std::uint32_t sequence = 0, accepted_sequence = 0, status = 0;
  std::uint64_t clock_ns = 0;
  Vec3 force_n = Vec3::Zero(), torque_n_m = Vec3::Zero();
  double depth_m = 0;
};

/// What is wrong with the bytes of a packet.
enum class PacketFault {
  none,
  malformed,  ///< another length or magic
  numbers     ///< one that is not finite, or beyond 1e3 m; an orientation that is no unit quaternion
};

/// Reads a packet from a device. @returns what is wrong; then `packet` is as it was
PacketFault read_packet(std::span<const unsigned char> bytes, DevicePacket& packet) noexcept;
PacketBytes packet_of(const DevicePacket& packet) noexcept;

/// @returns whether it is an answer; else `answer` is as it was
bool read_answer(std::span<const unsigned char> bytes, AnswerPacket& answer) noexcept;
PacketBytes packet_of(const AnswerPacket& answer) noexcept;

}  // namespace fingerpad
