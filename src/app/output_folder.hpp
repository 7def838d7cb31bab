#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fingerpad {

/// A folder for results, made and tried before the work that they take: a file is written into it and removed
/// again. If nothing is in it at the end, because the work failed, the folders made for it go again.
class OutputFolder {
 public:
  /// Throws Error (usage, or fault for a full disk) where it cannot be made or written to.
  explicit OutputFolder(const std::string& path);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

 private:
  std::vector<std::filesystem::path> made_;  ///< innermost first
};

}  // namespace fingerpad
