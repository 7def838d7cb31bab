#include "base/text_lines.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18, most_line_bytes = std::size_t{1} << 20;
constexpr char ctrl_z = '\x1a';

/// The first end of a line, or the text's size. Looked for in windows that grow, so that neither mark is
/// searched for far behind the other: a file may have one of them alone.
std::size_t line_end(std::string_view text) {
  std::size_t window = 64;
  for (std::size_t from = 0; from < text.size(); from += window, window *= 2) {
    const std::string_view here = text.substr(from, window);
    const std::size_t feed = std::min(here.find('\n'), here.size());
    const std::size_t bare = here.substr(0, feed).find('\r');
    if (bare != std::string_view::npos) return from + bare;
    if (feed < here.size()) return from + feed;
  }
  return text.size();
}

}  // namespace

TextLines::TextLines(const std::string& path, const InputKind& kind) : file_(path, kind) {
  begin();
}

void TextLines::begin() {
  fill();
  const std::string_view start = std::string_view(buffer_).substr(0, filled_);
  if (start.starts_with("\xfe\xff") || start.starts_with("\xff\xfe")) {
    throw refused(where(), "is a UTF-16 text: save it as UTF-8 or ASCII");
  }
  if (start.starts_with("\xef\xbb\xbf")) at_ = 3;
}

/// Reads on behind what is not yet given out; false if there was nothing more.
bool TextLines::fill() {
  if (at_end_) return false;
  buffer_.erase(0, at_);
  filled_ -= at_;
  at_ = 0;
  buffer_.resize(filled_ + block_bytes);
  const std::size_t got = file_.read(buffer_.data() + filled_, block_bytes);
  filled_ += got;
  at_end_ = got < block_bytes;
  while (at_end_ && filled_ > 0 && buffer_[filled_ - 1] == ctrl_z) --filled_;
  return got > 0;
}

bool TextLines::next(std::string_view& line) {
  std::size_t seen = 0;
  while (true) {
    const std::string_view left(buffer_.data() + at_, filled_ - at_);
    const std::size_t end = seen + line_end(left.substr(seen));
    // A CR at the end of what was read may be the first half of a CR LF.
    const bool whole = end + 1 < left.size() || (end < left.size() && (left[end] == '\n' || at_end_));
    if (whole || at_end_) {
      if (left.empty()) return false;
      ++number_;
      ended_ = end < left.size();
      line = left.substr(0, end);
      at_ += std::min(left.size(), end + 1);
      if (end + 1 < left.size() && left[end] == '\r' && left[end + 1] == '\n') ++at_;
      return true;
    }
    if (left.size() > most_line_bytes) {
      throw refused(where() + ":" + std::to_string(number_ + 1),
                    "is a line of over 1 MiB: no row of a table");
    }
    seen = end;
    fill();
  }
}

}  // namespace fingerpad
