#include <array>

#include "contact/contact_method_table.hpp"

namespace fingerpad {

// Each method is defined in the file of its name; its line here makes it known to scenes, `auto`, studies,
// traces, help and tests.
ContactMethodEntry closest_point_method() noexcept;
ContactMethodEntry proxy_method() noexcept;

std::span<const ContactMethodEntry> contact_method_table() noexcept {
  static const std::array table{closest_point_method(), proxy_method()};
  return table;
}

}  // namespace fingerpad
