#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// How a trial ended.
struct TrialOutcome {
  enum class End {
    returned,
    threw,   ///< an Error; `message` is what() of it
    waited,  ///< longer than wait_seconds()
    died,    ///< a crash, a hang, a hunger for memory, or another exception
  };
  End end = End::died;
  std::string message;
};

struct TrialLimits {
  std::uint64_t seconds;       ///< of the processor
  std::uint64_t memory_bytes;  ///< beyond what this process holds already
};

/// How long a child may take in all by the clock, far more than it may of the processor: beyond that it waits
/// for what does not come.
std::uint64_t wait_seconds(const TrialLimits& limits) noexcept;

/// Work in a child process, where a crash ends the child alone: for libraries that trust what they read. The
/// child changes nothing here; what it finds it says as bytes. In a process of several threads the work may
/// wait for nothing that another thread of this process holds: the child has this thread alone. (Memory may
/// be asked for: the C library sees to that.)
///
///     Trial trial([](const Trial::Say& say) { say("found"); }, {.seconds = 1, .memory_bytes = 1 << 20});
///     std::array<char, 5> found;
///     if (trial.hear(found) && trial.end().end == TrialOutcome::End::returned) use(found);
class Trial {
 public:
  using Say = std::function<void(std::string_view bytes)>;
  /// Starts the child. Throws Error (fault) if none can be started.
  Trial(const std::function<void(const Say&)>& work, const TrialLimits& limits);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  /// Ends the child, whatever it is at.
  ~Trial();

  /// Fills `out` with what the child says next, waiting for it. False if it ended and has said less.
  bool hear(std::span<char> out);
  /// Waits for the child's end; what it said and nobody heard is gone.
  TrialOutcome end();

 private:
  bool fill();
  void release();

  pid_t child_ = -1;
  int words_ = -1;   // what it says
  int ending_ = -1;  // how it ended: a letter, and the message of an Error
  std::vector<char> heard_;
  std::size_t used_ = 0;  // of heard_
};

}  // namespace fingerpad
