#include <cstdio>

#include "fuzz/scene_words.hpp"

int main() {
  std::fputs(fingerpad::test::scene_words().c_str(), stdout);
}
