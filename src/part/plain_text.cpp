#include "part/plain_text.hpp"

#include <string_view>

#include "base/error.hpp"
#include "part/sniff.hpp"

namespace fingerpad {
namespace {

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
constexpr std::string_view header_end = "end_header";
constexpr char ctrl_z = '\x1a';

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// Where the last line of a PLY header begins, if the header says that its body is binary; else npos.
std::size_t end_of_binary_header(std::string_view bytes) {
  if (!bytes.starts_with("ply")) return std::string_view::npos;
  std::size_t at = bytes.find(header_end);
  while (at != std::string_view::npos && !is_line_end(bytes[at - 1])) at = bytes.find(header_end, at + 1);
  if (at == std::string_view::npos) return at;
  return bytes.substr(0, at).find("format binary") != std::string_view::npos ? at : std::string_view::npos;
}

void feed_for_bare_return(std::string& bytes, std::size_t from, std::size_t to) {
  for (std::size_t at = bytes.find('\r', from); at < to; at = bytes.find('\r', at + 1)) {
    if (at + 1 == bytes.size() || bytes[at + 1] != '\n') bytes[at] = '\n';
  }
}

/// The line ends of a header before a binary body. Where its lines end in a bare CR, an LF after the last CR
/// is the body's first byte.
void make_header_plain(std::string& bytes, std::size_t last_line) {
  const std::size_t first_end = bytes.find_first_of("\r\n");
  const bool bare = bytes[first_end] == '\r' && bytes[first_end + 1] != '\n';
  feed_for_bare_return(bytes, 0, last_line);
  const std::size_t end = last_line + header_end.size();
  if (end + 1 < bytes.size() && bytes[end] == '\r' && (bare || bytes[end + 1] != '\n')) bytes[end] = '\n';
}

}  // namespace

void make_text_plain(std::string& bytes) {
  if (is_binary_stl_size(bytes)) return;
  const bool marked = bytes.starts_with(utf8_mark);
  const std::size_t last_line =
      end_of_binary_header(std::string_view(bytes).substr(marked ? utf8_mark.size() : 0));
  const bool binary = last_line != std::string_view::npos || bytes.find('\0') != std::string::npos;
  if (marked && binary) {
    throw refused("byte 0", "begins with a mark of UTF-8, but holds binary data: a text tool has changed it");
  }
  if (last_line != std::string_view::npos) make_header_plain(bytes, last_line);
  if (binary) return;
  if (marked) bytes.erase(0, utf8_mark.size());
  while (bytes.ends_with(ctrl_z)) bytes.pop_back();
  feed_for_bare_return(bytes, 0, bytes.size());
}

}  // namespace fingerpad
