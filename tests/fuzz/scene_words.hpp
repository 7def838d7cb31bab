#pragma once

#include <string>

namespace fingerpad::test {

/// The words of a scene as lines of a libFuzzer dictionary, from the rows of its keys: keys, tables, and the
/// words of choices in their quotes. Signs and numbers stand in dictionaries/scene.dict.
std::string scene_words();

}  // namespace fingerpad::test
