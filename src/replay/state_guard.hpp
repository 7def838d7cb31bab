#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "replay/locked_file.hpp"

namespace fingerpad {

/// How the names of the registrations beside a guard end.
inline constexpr const char* lock_ending = ".lock";

/// The guard of a state folder, held by whoever reads or changes the registrations. Whoever finds the folder
/// without registrations removes it with its guard; then it is made anew.
/// @param made  not null: makes the output folder again too, which a run that was refused may have just
/// removed, and counts the folders that it makes
std::optional<OpenFile> take_guard(const std::string& state, const std::string& folder, std::size_t* made);

/// Keeps in the guard's file how many folders were made by the runs that meet there.
void note_made_folders(int guard, std::size_t made);

/// Removes a state folder that holds its guard alone, and then those that were made, as far as they are
/// empty.
/// @pre the guard is held
void remove_if_unused(const std::string& state, int guard);

/// Of an output folder, which was there a moment ago: whoever removed it, or put a file in its place, the
/// call was good.
Error cannot_write_into(const std::string& folder);

}  // namespace fingerpad
