#include "support/calm_scene.hpp"

#include <algorithm>

namespace fingerpad::test {

std::string calm_scene(const std::string& name) {
  return "name = \"" + name +
         "\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[friction]\nlaw = \"none\"\n"
         "[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = "
         "0.02\n";
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace fingerpad::test
