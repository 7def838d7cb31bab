#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <string_view>

namespace fingerpad {

/// Refuses an empty value: a shell's variable that was never set.
/// @param takes  what `--help` calls it
CLI::Option* refuse_empty(CLI::Option* option, const char* takes = "FILE");

/// Throws Error (usage) for an output whose name ends otherwise than its contents will be.
/// @param who      "plot", for the message
/// @param endings  of what it writes, with their dots
void refuse_other_endings(const std::string& path, std::string_view who,
                          std::initializer_list<std::string_view> endings);

/// The same for an output that may be a stream: a name with an ending says what it holds; one without, a pipe
/// or a device does not.
void refuse_unfit_name(const std::string& path, std::string_view who,
                       std::initializer_list<std::string_view> endings);

/// Adds `--quiet`, which keeps tell_written() silent.
void add_quiet_flag(CLI::App& command, bool& quiet);

/// Prints "wrote FILE (WHAT)", unless the file is standard output itself, by whatever name.
void tell_written(bool quiet, const std::string& path, const std::string& what);

}  // namespace fingerpad
