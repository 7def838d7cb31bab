#pragma once

#include <string>
#include <string_view>

namespace fingerpad::test {

/// What a fuzz target's dictionary has from tables of src/, as lines of a libFuzzer dictionary; empty:
/// nothing. Signs and numbers stand in dictionaries/TARGET.dict.
std::string dictionary_words(std::string_view target);

/// Of a scene: keys, tables, and the words of choices in their quotes.
std::string scene_words();

/// Of a CSV trace: its columns.
std::string trace_words();

}  // namespace fingerpad::test
