#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// The known word that `word` may stand for; "" if there is none, or are two. It is looked for in this order:
/// - the only one that `word` is without its unit ("fx" of "fx_n");
/// - the one that is spelled most like it: at most a third of its letters are changed, left out, put in or
///   swapped with their neighbour;
/// - the only one that has it between its hyphens ("point" of "closest-point"), that begins with it ("frict"
/// of
///   "friction"), or that is it without a unit ("x" of "x_m").
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// "; did you mean 'closest-point'?", to stand behind what is said of an unknown word; "" where none is near.
/// Of two that are the word with a unit both are named.
std::string near_miss_hint(std::string_view word, const std::vector<std::string>& known);

/// "unknown method 'point' in [[set]]; did you mean 'closest-point'? (known: proxy, closest-point)".
/// @param what   the word is to name
/// @param where  it stands, with its preposition; may be empty
std::string unknown_word_text(std::string_view what, std::string_view word, std::string_view where,
                              const std::vector<std::string>& known);

/// The words with commas between.
std::string word_list(const std::vector<std::string>& words);

}  // namespace fingerpad
