#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace fingerpad {

/// How a trial ended.
struct TrialOutcome {
  enum class End {
    returned,
    threw,  ///< `message` is what() of it
    died,   ///< a crash, a hang, or a hunger for memory
  };
  End end = End::died;
  std::string message;
};

/// Runs `work` in a child process, where a crash ends the child alone: for libraries that trust what they
/// read. The child shares nothing back. Throws Error (fault) if no child can be started.
/// @param seconds       of the processor; on the wall three times as many
/// @param memory_bytes  beyond what this process holds already
TrialOutcome trial(const std::function<void()>& work, std::uint64_t seconds, std::uint64_t memory_bytes);

}  // namespace fingerpad
