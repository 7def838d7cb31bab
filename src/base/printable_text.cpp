#include "base/printable_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace fingerpad {
namespace {

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool valid = false;
};

/// The first character of a text (Unicode 15, table 3-7: no overlong forms, no halves of a pair).
Character first_character(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t count = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < count) return {};
  char32_t code = lead & (0x7fu >> count);
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xc0u) != 0x80u) return {};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool half = code >= 0xd800 && code <= 0xdfff;
  if (code < least[count] || half || code > 0x10ffff) return {};
  return {count, code, true};
}

/// Line separators, marks of direction, and what has no width.
bool misleads(char32_t code) noexcept {
  return (code >= 0x80 && code < 0xa0) || code == 0x61c || (code >= 0x200b && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

std::string spelt_out(const Character& character, unsigned char byte) {
  if (character.valid && character.code >= 0x80) {
    return fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code));
  }
  if (byte == '\n') return "\\n";
  if (byte == '\r') return "\\r";
  if (byte == '\t') return "\\t";
  return fmt::format("\\x{:02x}", byte);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  out.reserve(std::min(text.size(), longest) + 8);
  while (!text.empty()) {
    if (out.size() >= longest) return out + "...";
    const Character next = first_character(text);
    const auto byte = static_cast<unsigned char>(text[0]);
    if (!next.valid || next.code < 0x20 || next.code == 0x7f || misleads(next.code)) {
      out += spelt_out(next, byte);
    } else {
      out += text.substr(0, next.bytes);
    }
    text.remove_prefix(next.bytes);
  }
  return out;
}

std::string middle_left_out(std::string_view text, std::size_t most) {
  constexpr std::string_view dots = "...";
  std::vector<std::size_t> begins;  // of its characters
  for (std::size_t at = 0; at < text.size(); at += first_character(text.substr(at)).bytes)
    begins.push_back(at);
  if (begins.size() <= most) return std::string(text);
  const std::size_t tail = (most - dots.size()) / 2, head = most - dots.size() - tail;
  return std::string(text.substr(0, begins[head]))
      .append(dots)
      .append(text.substr(begins[begins.size() - tail]));
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const Character next = first_character(text);
    if (!next.valid) return false;
    text.remove_prefix(next.bytes);
  }
  return true;
}

}  // namespace fingerpad
