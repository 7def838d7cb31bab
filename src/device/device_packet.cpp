#include "device/device_packet.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#include "device/reach.hpp"

namespace fingerpad {
namespace {

constexpr unsigned char device_magic[4] = {'F', 'P', 'D', '1'}, answer_magic[4] = {'F', 'P', 'F', '1'};
constexpr double unit_tolerance = 1e-3;

/// An unsigned whole number, the low byte first.
template <typename Number>
Number whole_at(std::span<const unsigned char> bytes, std::size_t at) noexcept {
  Number value = 0;
  for (std::size_t k = sizeof(Number); k-- > 0;)
    value = static_cast<Number>(value << 8) | static_cast<Number>(bytes[at + k]);
  return value;
}

double number_at(std::span<const unsigned char> bytes, std::size_t at) noexcept {
  return std::bit_cast<double>(whole_at<std::uint64_t>(bytes, at));
}

Vec3 vector_at(std::span<const unsigned char> bytes, std::size_t at) noexcept {
  return {number_at(bytes, at), number_at(bytes, at + 8), number_at(bytes, at + 16)};
}

template <typename Number>
void put_whole(PacketBytes& bytes, std::size_t at, Number value) noexcept {
  for (std::size_t k = 0; k < sizeof(Number); ++k)
    bytes[at + k] = static_cast<unsigned char>(value >> (8 * k) & 0xff);
}

void put_number(PacketBytes& bytes, std::size_t at, double value) noexcept {
  put_whole(bytes, at, std::bit_cast<std::uint64_t>(value));
}

void put_vector(PacketBytes& bytes, std::size_t at, const Vec3& vector) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    put_number(bytes, at + 8 * static_cast<std::size_t>(axis), vector[axis]);
}

bool has_form(std::span<const unsigned char> bytes, const unsigned char (&magic)[4]) noexcept {
  return bytes.size() == packet_bytes && std::memcmp(bytes.data(), magic, 4) == 0;
}

bool is_unit(const std::array<double, 4>& q) noexcept {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return std::abs(length - 1) <= unit_tolerance;
}

}  // namespace

PacketFault read_packet(std::span<const unsigned char> bytes, DevicePacket& packet) noexcept {
  if (!has_form(bytes, device_magic)) return PacketFault::malformed;
  DevicePacket read;
  read.sequence = whole_at<std::uint32_t>(bytes, 4);
  read.clock_ns = whole_at<std::uint64_t>(bytes, 8);
  read.position_m = vector_at(bytes, 16);
  for (std::size_t k = 0; k < 4; ++k) read.orientation_wxyz[k] = number_at(bytes, 40 + 8 * k);
  read.buttons = whole_at<std::uint32_t>(bytes, 72);
  read.flags = whole_at<std::uint32_t>(bytes, 76);
  // Not a number is no number, whether it is used or not.
  for (const double part : read.orientation_wxyz)
    if (!std::isfinite(part)) return PacketFault::numbers;
  for (const double metres : {read.position_m.x(), read.position_m.y(), read.position_m.z()})
    if (!(std::abs(metres) <= device_reach_m)) return PacketFault::numbers;
  if ((read.flags & flag_has_orientation) != 0 && !is_unit(read.orientation_wxyz))
    return PacketFault::numbers;
  packet = read;
  return PacketFault::none;
}

PacketBytes packet_of(const DevicePacket& packet) noexcept {
  PacketBytes bytes{};
  std::memcpy(bytes.data(), device_magic, 4);
  put_whole(bytes, 4, packet.sequence);
  put_whole(bytes, 8, packet.clock_ns);
  put_vector(bytes, 16, packet.position_m);
  for (std::size_t k = 0; k < 4; ++k) put_number(bytes, 40 + 8 * k, packet.orientation_wxyz[k]);
  put_whole(bytes, 72, packet.buttons);
  put_whole(bytes, 76, packet.flags);
  return bytes;
}

bool read_answer(std::span<const unsigned char> bytes, AnswerPacket& answer) noexcept {
  if (!has_form(bytes, answer_magic)) return false;
  answer.sequence = whole_at<std::uint32_t>(bytes, 4);
  answer.accepted_sequence = whole_at<std::uint32_t>(bytes, 8);
  answer.status = whole_at<std::uint32_t>(bytes, 12);
  answer.clock_ns = whole_at<std::uint64_t>(bytes, 16);
  answer.force_n = vector_at(bytes, 24);
  answer.torque_n_m = vector_at(bytes, 48);
  answer.depth_m = number_at(bytes, 72);
  return true;
}

PacketBytes packet_of(const AnswerPacket& answer) noexcept {
  PacketBytes bytes{};
  std::memcpy(bytes.data(), answer_magic, 4);
  put_whole(bytes, 4, answer.sequence);
  put_whole(bytes, 8, answer.accepted_sequence);
  put_whole(bytes, 12, answer.status);
  put_whole(bytes, 16, answer.clock_ns);
  put_vector(bytes, 24, answer.force_n);
  put_vector(bytes, 48, answer.torque_n_m);
  put_number(bytes, 72, answer.depth_m);
  return bytes;
}

}  // namespace fingerpad
