#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fingerpad::test {

/// The project's own tree, for scenes and golden files.
std::filesystem::path source_dir();

/// The built program.
std::filesystem::path program();

/// The folder of real meshes (`parts`, `dense`, `malformed`) that lies beside the project as ../shared/data,
/// or where FINGERPAD_TEST_DATA says; nothing where it is absent, and then the test is skipped.
std::optional<std::filesystem::path> real_data();

/// Files of one folder of real_data() with one of these endings, sorted; empty where absent.
std::vector<std::filesystem::path> real_files(const std::string& folder,
                                              const std::vector<std::string>& endings);

/// The meshes of its `parts` but for STEP; under a sanitizer one of six, as each takes ten times as long
/// there.
std::vector<std::filesystem::path> real_parts();

/// A fresh folder of its own for the running test, emptied at the start of the test. It is gone when the
/// process ends, unless a test failed.
std::filesystem::path scratch_dir();

}  // namespace fingerpad::test
