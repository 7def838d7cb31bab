#pragma once

#include "replay/batch_plan.hpp"

namespace fingerpad {

/// Prints a plan: a line a job, then ticks, time and disk, with a warning where the disk has less room.
/// @returns  whether no job would fail
bool tell_plan(const BatchPlan& plan, const BatchOptions& batch);

}  // namespace fingerpad
