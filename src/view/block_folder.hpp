#pragma once

#include <filesystem>
#include <string>

namespace fingerpad {

/// A .vtm file under way with the folder of its blocks: written into a hidden folder beside it, and moved
/// into place once all is there.
class BlockFolder {
 public:
  /// Throws Error (usage) where it cannot be made, and where a folder of the blocks' name holds anything else
  /// than blocks of such a file.
  explicit BlockFolder(const std::string& path);
  BlockFolder(const BlockFolder&) = delete;
  BlockFolder& operator=(const BlockFolder&) = delete;
  ~BlockFolder();

  /// What the writer is told to write.
  std::string writes_to() const { return (hidden_ / path_.filename()).string(); }
  /// Why VTK could not write.
  std::string reason(unsigned long vtk_error) const;
  /// Throws Error (fault) where something cannot be moved.
  void commit();

 private:
  std::filesystem::path path_, blocks_, hidden_;
};

}  // namespace fingerpad
