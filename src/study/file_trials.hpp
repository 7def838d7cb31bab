#pragma once

#include <functional>
#include <span>

#include "study/recorded_trial.hpp"

namespace fingerpad {

/// The trials of one file.
using FileTrials = std::span<const RecordedTrial>;

/// Less may be a sensor's offset, where nothing presses.
inline constexpr double surely_presses_n = 0.15;

/// The normal force of the samples that press, on the median; below 0 where a plate would pull.
double pressing_n(const RecordedTrial& trial);
/// Forces along the plate's normal.
Eigen::RowVectorXd along_normal_n(const RecordedTrial& trial);
/// How far positions reach along the axis on which they reach farthest.
double extent_m(const RecordedTrial& trial);
double largest_force_n(const RecordedTrial& trial);
/// Faster than all but a twentieth of a trial's ways over 12 ms, or over all of a shorter one.
double fastest_m_per_s(const RecordedTrial& trial);

/// The median over a file's trials that have it; not a number where none has.
double usual(FileTrials trials, const std::function<double(const RecordedTrial&)>& of);

/// Calls `use` with the trials of each file.
void each_file(const RecordedMeasurement& recorded, const std::function<void(FileTrials)>& use);

}  // namespace fingerpad
