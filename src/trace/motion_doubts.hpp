#pragma once

#include "trace/motion_reading.hpp"

namespace fingerpad {

// What is odd in a file that was read. Its clock is known.

/// Refuses a rate of its own that no ticks and no resampling go at.
void refuse_wild_rate(const MotionReading& reading, double least_hz);

/// Of a clock with steps of many lengths: said where it decides something.
void warn_of_odd_steps(MotionReading& reading);
/// Of columns whose names say another unit than the scene says.
void warn_of_named_units(MotionReading& reading);
/// Of columns that by their names hold the finger's orientation, where no such is read.
void note_unread_attitude(MotionReading& reading, const std::vector<std::string>& names);
/// Of columns that by their names number trials or subjects, and that the scene does not ask for.
void note_unread_trials(MotionReading& reading, const std::vector<std::string>& names);
/// Of single steps that no finger makes, as where a tracker lost its marker: faster than 3 m/s, and twenty
/// times as fast as is usual where it moves. (Of many such steps the unit is wrong, or the clock.)
void warn_of_leaps(MotionReading& reading);
/// Of a file, or of a trial in it, of one row.
void warn_of_one_sample(MotionReading& reading);
/// Of times that seem to be in ms, us or ns and were read as seconds, where the scene does not say what they
/// are in.
///
/// Rule: no recorder is slower than 10 Hz, and no finger that is recorded for more than twenty samples is
/// slower than a thousandth of 2 m/s on average; ms, us or ns, whichever gives 20 Hz to 20 kHz, is likely if
/// the finger stays under 2 m/s so. A few samples far apart are a motion that was written by hand.
void warn_of_slow_clock(MotionReading& reading);
/// Of times that seem to be in minutes: a finger at 2 m/s on average, told at 5 kHz or more. Else of a
/// finger that goes faster than any.
void warn_of_quick_clock(MotionReading& reading);
/// Of a measured normal force that presses nothing.
void warn_of_odd_force(MotionReading& reading);
/// Of a measured force that no finger rubs with: its unit is asked for, where nothing says it.
void warn_of_force_unit(MotionReading& reading);
/// Of a measured force that drives the finger: the residual would be that of a wrong sign.
void warn_of_driving_force(MotionReading& reading);

}  // namespace fingerpad
