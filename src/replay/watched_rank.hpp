#pragma once

#include <functional>

#include "replay/rank_log.hpp"
#include "replay/ranks.hpp"

namespace fingerpad {

/// Goes on in a child process, and keeps watch over it in this one. A child that a signal ends (a mesh that
/// crashes a library, the kernel short of memory) loses what it has begun: that is noted in the log, and
/// another goes on in its place. So what launched the rank does not see it die, and does not end the others.
/// The one that watches passes SIGINT and SIGTERM on, asks the child to stop where its launcher is gone, and
/// ends with the child's code; the child ends with it. Returns in the child alone. To be called before there
/// are threads.
class WatchedRank {
 public:
  /// @param on_asked  called in the one that watches, where a signal has asked it to stop. May be empty
  WatchedRank(RankLog& log, const Ranks& ranks, const std::function<void()>& on_asked = {});

  /// A child that is ended before it has begun another job is replaced a few times only.
  void begins_job() noexcept;
  /// What comes is not repeated: where a signal ends the child now, it is not replaced.
  void has_left() noexcept;

 private:
  struct Told;  // in memory that both have
  Told* told_;
};

}  // namespace fingerpad
