#include "contact/normals.hpp"

namespace fingerpad {

// Each kind is defined in the file normals_<name>.cpp; its line here makes it known to scenes, `auto`,
// studies, help and tests.
std::span<const Normals> normals_table() noexcept {
  static constexpr Normals table[] = {Normals::facet, Normals::smooth, Normals::curved};
  return table;
}

}  // namespace fingerpad
