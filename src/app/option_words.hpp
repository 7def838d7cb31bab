#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fingerpad {

// What `--help` and the man pages say of an option, made from what CLI11 knows of it.

/// What it takes: "N", "h5|csv|none", "FOLDER"; nothing of a flag.
std::string placeholder(const CLI::Option& option);

/// Its description, and in brackets behind it whether it is needed, what it goes with, its range or choices,
/// and its default.
std::string about(const CLI::Option& option);

/// Those that are shown, positional ones or the others.
std::vector<const CLI::Option*> shown_options(const CLI::App& app, bool positional);

}  // namespace fingerpad
