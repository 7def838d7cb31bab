#include "device/wake_up.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "base/error.hpp"

namespace fingerpad {

WakeUp::WakeUp() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(ErrorKind::fault, "eventfd", std::strerror(errno));
}

WakeUp::~WakeUp() {
  close(descriptor_);
}

void WakeUp::wake() noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(descriptor_, &one, sizeof(one));
}

bool WakeUp::wait(int patience_ms) noexcept {
  pollfd ready{descriptor_, POLLIN, 0};
  return poll(&ready, 1, patience_ms) == 1;
}

WakeUp::Woken WakeUp::wait_with(int other_descriptor) noexcept {
  pollfd ready[] = {{descriptor_, POLLIN, 0}, {other_descriptor, POLLIN, 0}};
  while (poll(ready, 2, -1) < 0) {
    if (errno != EINTR) return {.broken = true};
  }
  constexpr short never = POLLNVAL;
  return {.by_wake = ready[0].revents != 0,
          .by_other = ready[1].revents != 0,
          .broken = ((ready[0].revents | ready[1].revents) & never) != 0};
}

void WakeUp::clear() noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t got = read(descriptor_, &count, sizeof(count));
}

}  // namespace fingerpad
