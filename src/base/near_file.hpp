#pragma once

#include <filesystem>

namespace fingerpad {

/// The file of the same folder and with the same extension that a misspelled path may mean; empty if none is
/// like it. Of a folder 10,000 names are looked at.
std::filesystem::path near_file(const std::filesystem::path& path);

}  // namespace fingerpad
