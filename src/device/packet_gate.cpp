#include "device/packet_gate.hpp"

#include <fmt/format.h>

#include <utility>

namespace fingerpad {
namespace {

constexpr std::int64_t sender_silence_ns = 1'000'000'000;

}  // namespace

bool PacketGate::pass(std::span<const unsigned char> bytes, const PacketSender& sender, std::int64_t now_ns,
                      DevicePacket& packet) noexcept {
  DevicePacket read;
  switch (read_packet(bytes, read)) {
    case PacketFault::malformed:
      ++counts_.malformed;
      return false;
    case PacketFault::numbers:
      ++counts_.numbers;
      return false;
    case PacketFault::none:
      break;
  }
  if (read.sequence == 0) {  // they go from 1, and past the last number from 1 again
    ++counts_.old;
    return false;
  }
  const bool listens_to_one = counts_.accepted > 0 && now_ns - last_ns_ < sender_silence_ns;
  if (listens_to_one && !(sender == sender_)) {
    ++counts_.other;
    return false;
  }
  // After a silence too the last packet is not news: only a device that has started anew is.
  const bool repeated = counts_.accepted > 0 && sender == sender_ && read.sequence == last_sequence_;
  if (repeated || (listens_to_one && !comes_after(read.sequence, last_sequence_))) {
    ++counts_.old;
    return false;
  }
  sender_ = sender;
  last_ns_ = now_ns;
  last_sequence_ = read.sequence;
  ++counts_.accepted;
  packet = read;
  return true;
}

std::string counts_text(const PacketGate::Counts& counts) {
  std::string text = fmt::format("{} packets accepted, {} dropped", counts.accepted, counts.dropped());
  const std::pair<std::uint64_t, const char*> reasons[] = {{counts.malformed, "of another length or magic"},
                                                           {counts.numbers, "with numbers out of range"},
                                                           {counts.old, "old or repeated"},
                                                           {counts.other, "of another sender"}};
  const char* between = ": ";
  for (const auto& [count, reason] : reasons) {
    if (count == 0) continue;
    text += fmt::format("{}{} {}", between, count, reason);
    between = ", ";
  }
  return text;
}

}  // namespace fingerpad
