#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fingerpad {

/// That an option's value is a whole number from `least` to `most`. Another is refused with what was given
/// and what is allowed.
CLI::Validator whole_number_in(long least, long most);

/// That it is a number from `least` to `most`, in the option's own unit; refused likewise.
/// @param unit  for people, "seconds"
CLI::Validator number_in(double least, double most, const std::string& unit);

/// Makes bytes of a size of memory, "500M" or "4G" (of 1024s); refuses what is none, with what is one.
CLI::Validator memory_size();

/// "--jobs: 'two' is no whole number", "--at: '2 s' is no number; it is in seconds, without a unit": of a
/// value that CLI11 could not convert; else its own words.
std::string no_number_words(const CLI::ConversionError& error, const CLI::App& command);

}  // namespace fingerpad
