#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// The known word that is spelled most like `word` (edit distance of at most a third of its length); "" if
/// none is.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// The words with commas between.
std::string word_list(const std::vector<std::string>& words);

}  // namespace fingerpad
