#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace fingerpad {

/// A text file under way: written as `path`.part and renamed when it is whole, so that half a file is never
/// taken for one. A path that is no regular file (a terminal, a pipe) is written directly, and `-` is
/// standard output. Throws Error (fault, with the path) as refuse_unwritable does, for a pipe that nobody
/// reads, and where the writing fails.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Leaves what was written as `path`.part if commit() was not reached.
  ~OutputFile();

  void write(std::string_view text);
  void flush();
  void commit();

 private:
  [[noreturn]] void fail(const std::string& doing) const;

  std::string path_, written_path_;
  std::FILE* file_ = nullptr;
};

}  // namespace fingerpad
