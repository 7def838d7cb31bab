#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fingerpad::test {

/// A file with these bytes for readers that want a path; gone at its end. In memory where the system has a
/// place for that.
class InputFile {
 public:
  /// @param ending  ".stl"
  InputFile(std::string_view bytes, std::string_view ending);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace fingerpad::test
