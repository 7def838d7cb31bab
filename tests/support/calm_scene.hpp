#pragma once

#include <string>

namespace fingerpad::test {

/// A scene that has nothing to warn of: half a second of rubbing a plane without friction.
std::string calm_scene(const std::string& name);

/// How many lines a text has.
int lines_of(const std::string& text);

}  // namespace fingerpad::test
