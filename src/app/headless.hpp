#pragma once

#include <functional>
#include <optional>

namespace fingerpad {

/// Waits where there is no window: for so many seconds, without end where none are given, until SIGINT or
/// SIGTERM comes, or until `is_over` says so, which is asked many times a second. A second signal ends the
/// program at once.
void wait_without_window(std::optional<double> seconds, const std::function<bool()>& is_over);

}  // namespace fingerpad
