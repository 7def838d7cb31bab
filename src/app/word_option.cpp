#include "app/word_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/nearest_word.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {

CLI::Validator one_of(std::vector<std::string> words) {
  constexpr std::size_t longest = 60;
  const std::string shown = CLI::detail::generate_set(words);  // for --help, and for completion
  const auto fault = [words = std::move(words)](const std::string& word) {
    if (std::ranges::find(words, word) != words.end()) return std::string();
    return fmt::format("'{}' is none of {}{}", printable(word, longest), word_list(words),
                       near_miss_hint(word, words));
  };
  return CLI::Validator(fault, shown);
}

}  // namespace fingerpad
