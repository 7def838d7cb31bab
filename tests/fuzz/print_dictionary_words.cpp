#include <cstdio>

#include "fuzz/dictionary_words.hpp"

// usage: print_dictionary_words TARGET
int main(int count, char** words) {
  if (count != 2) return 2;
  std::fputs(fingerpad::test::dictionary_words(words[1]).c_str(), stdout);
}
