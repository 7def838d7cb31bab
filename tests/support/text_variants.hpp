#pragma once

#include <string>
#include <vector>

namespace fingerpad::test {

/// A text as other programs and systems would have written it.
struct TextVariant {
  const char* name;
  std::string (*of)(const std::string& text);
  bool must_read;  ///< else it may be refused; never is it to be read as something else
};

/// Marks of UTF-8, line ends of three systems and mixtures of them, form feeds, blank lines, UTF-16, ...
const std::vector<TextVariant>& text_variants();

std::string replaced(std::string text, const std::string& what, const std::string& by);

/// LF, CR LF and CR in turn.
std::string mixed_ends(const std::string& text);

}  // namespace fingerpad::test
