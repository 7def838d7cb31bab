#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace fingerpad {

/// A text file under way: written as `path`.part and renamed when it is whole, so that half a file is never
/// taken for one. Links are followed, and what is replaced keeps its mode. A path that is no regular file (a
/// terminal, a pipe) is written directly, and `-` is standard output. Throws Error, with the path: usage as
/// refuse_unwritable does, fault for a pipe that nobody reads and where the writing fails.
class OutputFile {
 public:
  /// What becomes of `path`.part if commit() was not reached: a table of which half is there is worth
  /// nothing, a recording is worth all that it holds.
  enum class Unfinished { removed, kept };
  explicit OutputFile(const std::string& path, Unfinished unfinished = Unfinished::removed);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  void flush();
  void commit();

 private:
  [[noreturn]] void fail(const std::string& doing) const;

  std::string path_;        // as given, for messages
  std::string final_path_;  // behind its links
  std::string part_path_;   // empty: written directly
  Unfinished unfinished_;
  std::FILE* file_ = nullptr;
};

}  // namespace fingerpad
