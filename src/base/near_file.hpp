#pragma once

#include <filesystem>

namespace fingerpad {

/// The file of the same folder that a misspelled path may mean; empty if none is like it.
/// - Letters of the other case, and up to a third of a name's that are wrong, are misspellings.
/// - An ending may be misspelled ("bracket.tml"), but is not another ("bracket.stl" of "bracket.toml").
/// - Names whose digits differ are those of other trials or subjects, and are never meant.
/// - Of over 1,000 entries of a folder none is.
std::filesystem::path near_file(const std::filesystem::path& path);

/// As near_file(), of a folder; those that lead to it may be misspelled, too.
std::filesystem::path near_folder(const std::filesystem::path& path);

}  // namespace fingerpad
