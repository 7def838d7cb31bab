#pragma once

#include <filesystem>

namespace fingerpad {

/// The file of the same folder and with the same extension that a misspelled path may mean; empty if none is
/// like it, where names differ in digits alone, as those of a series do, and in folders of over 1,000
/// entries.
std::filesystem::path near_file(const std::filesystem::path& path);

}  // namespace fingerpad
