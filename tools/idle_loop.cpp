// A servo loop that does nothing, at 1 kHz until SIGTERM: what of a live touch's lateness is the machine's.
// Prints how it kept its time: ticks, late ticks, and a line for each length of time with ticks as late as
// that.
#include <csignal>
#include <cstdio>
#include <thread>

#include "touch/servo_thread.hpp"

namespace {
volatile std::sig_atomic_t is_over = 0;
}

int main(int count, char**) {
  std::signal(SIGTERM, [](int) { is_over = 1; });
  fingerpad::ServoThread loop(
      1000, [](double) { return fingerpad::TickRecord(); }, 0.1, count > 1);
  while (is_over == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  loop.stop();
  const fingerpad::ServoTiming timing = loop.timing();
  std::printf("%ld %ld %.9g\n", timing.ticks, timing.late_ticks, timing.worst_late_s);
  for (int i = 0; i < fingerpad::TimeCounts::buckets; ++i)
    std::printf("%.9g %llu\n", fingerpad::TimeCounts::upper_s(i),
                static_cast<unsigned long long>(timing.latenesses.counts[static_cast<std::size_t>(i)]));
}
