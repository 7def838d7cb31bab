#pragma once

#include <string>

namespace fingerpad {

struct ViewInput;

/// The name of the next screenshot: beside the recording that is shown or made, else in the current folder;
/// named after what is shown, numbered, of no file that exists: "knob.stl" -> "knob-view-001.png".
std::string next_screenshot_name(const ViewInput& input);

}  // namespace fingerpad
