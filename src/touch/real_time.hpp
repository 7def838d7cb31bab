#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// Keeps the calling thread's timers from being put off to save power (Linux: 50 us otherwise).
void sharpen_timers() noexcept;

/// Tells the system that the calling thread, which is as all others, works for a short while at a time: where
/// it wakes, others do not end their share of the processor first, which is three milliseconds or so (Linux
/// from 6.12 on; before, nothing happens). Needs no permission.
void ask_for_short_turns() noexcept;

/// Asks the system to run the calling thread before all others, on a core of its own as far as that can be:
/// SCHED_FIFO, and pinned to the last core that the process may use.
/// @returns a line for each thing that it does not permit, with the mend; empty where all was granted
std::vector<std::string> run_thread_first();

/// Keeps all memory of the process in RAM, so that no access waits for a disk. @returns as above
std::vector<std::string> lock_memory();

}  // namespace fingerpad
