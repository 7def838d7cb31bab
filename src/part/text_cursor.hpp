#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fingerpad {

/// Walks through a text word by word and knows the line. Never copies the text, never leaves it.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text, long first_line = 1) : text_(text), line_(first_line) {}

  /// The next word, over line ends; empty at the end of the text.
  std::string_view word();
  /// The next word of this line; empty at its end.
  std::string_view word_in_line();
  /// The rest of this line without its end; then stands at the start of the next line.
  std::string_view rest_of_line();
  bool at_end() const { return at_ >= text_.size(); }
  long line() const { return line_; }
  std::size_t offset() const { return at_; }
  /// "line 12", for messages.
  std::string place() const { return "line " + std::to_string(line_); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  long line_ = 1;
};

/// A coordinate as mesh files spell them: 1, +1.5, 2., 1e-3, and also nan, inf, -1.#IND, 1e999 (infinite).
/// Nothing for what is no number.
std::optional<double> coordinate_of(std::string_view word);

/// A whole number in full; nothing for anything else and beyond 64 bits.
std::optional<long long> integer_of(std::string_view word);

/// "'1,5' is not a number", with the likely cause; unprintable characters are shown as '?', long words cut.
std::string not_a_number(std::string_view word);

/// The word as it may stand in a message.
std::string shown(std::string_view word);

/// Whether two words are equal but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

}  // namespace fingerpad
