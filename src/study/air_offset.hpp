#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What a force sensor that was not zeroed reads in the air, where that is so far below 0 along the plate's
/// normal that the press itself seems to pull, as a force on the plate would: level and alike before and
/// after the press, which pushes beside it, and from no lower than the finger presses at. Nothing where any
/// of that is not so. In W [N].
std::optional<Vec3> hiding_offset_W(const RecordedTrial& trial);

/// Takes such offsets off, so that what asks for signs sees the press.
/// @returns what to tell of each file, "FILE: ..."
std::vector<std::string> take_off_hiding_offsets(RecordedMeasurement& recorded);

/// What to say of a file most of whose trials have such an offset, which is to stay; empty: they have none.
std::string hiding_offset_words(FileTrials trials);

}  // namespace fingerpad
