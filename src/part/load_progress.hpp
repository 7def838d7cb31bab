#pragma once

#include <functional>
#include <string_view>
#include <utility>

namespace fingerpad {

/// Told how a load goes: what is done now, in words for a person, and how much of the load is done, 0 .. 1,
/// never less than before. Called now and then from the thread that loads; may be empty, and must not throw.
using LoadProgress = std::function<void(std::string_view stage, double share_done)>;

inline void tell(const LoadProgress& progress, std::string_view stage, double share_done) {
  if (progress) progress(stage, share_done);
}

/// What a step of a load is given where it is the part from .. to of the whole.
inline LoadProgress step_of(LoadProgress whole, double from, double to) {
  if (!whole) return {};
  return [whole = std::move(whole), from, to](std::string_view stage, double share_done) {
    whole(stage, from + (to - from) * share_done);
  };
}

}  // namespace fingerpad
