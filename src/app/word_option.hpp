#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fingerpad {

/// That an option's value is one of these words; another is refused with the one that is spelled most like
/// it.
CLI::Validator one_of(std::vector<std::string> words);

}  // namespace fingerpad
