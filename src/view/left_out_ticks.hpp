#pragma once

#include <cstdint>

#include "trace/trace.hpp"

namespace fingerpad {

/// A trace's rows are every so manieth tick, and the last. It says so itself, in CSV by a column `every`. A
/// CSV without one, as older programs wrote it, is taken for thinned where its last row comes sooner than the
/// others, as it does where the last tick was kept beside every so manieth: then the least number by which
/// that can be. Where the last tick was one of these, nothing tells, and the answer is 1.
std::uint64_t ticks_a_row(const Trace& trace);

}  // namespace fingerpad
