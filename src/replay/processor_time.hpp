#pragma once

namespace fingerpad {

/// The processors' time that this process has taken so far, all its threads together [s]. What else the
/// machine does is not in it.
double processor_s() noexcept;

/// How many processors so many busy threads get on this machine as it is now: more than 0, at most `threads`.
/// Fewer than the threads where there are fewer, or others want them too. Keeps them busy for two fifths of a
/// second.
/// @pre threads >= 1
double processors_for(int threads);

/// How long work lasts that threads share, one of whose jobs takes `longest_s` by itself, which no second
/// thread shortens. All in seconds of a processor, but for the result.
/// @param processors  that the threads get together
double shared_seconds(double work_s, double longest_s, int threads, double processors) noexcept;

}  // namespace fingerpad
