#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fingerpad {

/// Throws Error (usage) where a file cannot be written by that name: it is empty, a folder stands there, its
/// own folder is missing, forbidden or none. Asked before long work, so that its result is not lost at the
/// end. Writes and opens nothing. A `-` is standard output, and a pipe or a device is for the writing itself
/// to try.
void refuse_unwritable(const std::string& path);

/// Makes a folder with those that lead to it.
/// @returns those that were not there, innermost first. Throws Error (usage, or fault for a full disk) where
/// it cannot be made; then none of them stays.
std::vector<std::filesystem::path> make_folder(const std::string& path);

/// Removes those of these folders that are empty, innermost first.
void remove_empty(const std::vector<std::filesystem::path>& folders) noexcept;

}  // namespace fingerpad
