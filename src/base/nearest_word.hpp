#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// The known word that is spelled most like `word`: at most a third of its letters are changed, left out, put
/// in or swapped with their neighbour. If none is, the only one that has it between its hyphens ("point" of
/// "closest-point"); "" if there is none, or are two.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// The words with commas between.
std::string word_list(const std::vector<std::string>& words);

}  // namespace fingerpad
