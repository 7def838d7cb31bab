#pragma once

#include <string>

namespace fingerpad {

/// The name of the next screenshot: beside the file that is shown, numbered, of no file that exists:
/// "run.h5" -> "run-view-001.png". What has no file (standard input) is named after `title`, in the
/// current folder.
std::string next_screenshot_name(const std::string& file, const std::string& title);

}  // namespace fingerpad
