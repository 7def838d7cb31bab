#pragma once

#include <set>

namespace fingerpad {

/// The threads that draw. Without a graphics card they take every core there is; a servo that is as any other
/// thread of the system then waits for them, unless they stand back.
class DrawingThreads {
 public:
  /// All threads that come from now on are taken for such, and the calling one.
  DrawingThreads();
  /// They leave others the first turn, and a core where there is more than one, for ever, and so does what
  /// they begin (see KeptThread): a turn that is over only at the system's next clock tick is a millisecond
  /// that a servo waits. A system that does not let them loses nothing else.
  void stand_back() const;

 private:
  std::set<int> others_;
};

}  // namespace fingerpad
