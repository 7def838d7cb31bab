#pragma once

#include <string>
#include <string_view>

#include "base/input_file.hpp"

namespace fingerpad {

/// The lines of a text, however they end: LF, CR LF, a bare CR, or any mix of them. A mark of UTF-8 at the
/// beginning and a Ctrl-Z at the end (DOS) are passed over; UTF-16, and a line of over 1 MiB, are refused.
class TextLines {
 public:
  /// Throws Error (refused) as InputFile does.
  TextLines(const std::string& path, const InputKind& kind);

  /// The next line without its end, which stands until the next call; false at the end of the text.
  bool next(std::string_view& line);
  /// Whether the last line given had an end: in a file cut short, its last line may lack a part.
  bool ended() const noexcept { return ended_; }
  /// "table.csv:12", the last line given.
  std::string place() const { return file_.where() + ":" + std::to_string(number_); }
  const std::string& where() const noexcept { return file_.where(); }
  long number() const noexcept { return number_; }

 private:
  bool fill();
  void begin();

  InputFile file_;
  std::string buffer_;
  std::size_t at_ = 0, filled_ = 0;
  long number_ = 0;
  bool at_end_ = false, ended_ = true;
};

}  // namespace fingerpad
