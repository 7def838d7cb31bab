#include <array>

#include "motion/field_format.hpp"

namespace fingerpad {

// Each format is defined in the file of its name; its line here makes it known to scenes, `fit`, help and
// tests.
FieldFormat cluster_texture_format() noexcept;
FieldFormat sens3_format() noexcept;
FieldFormat finger_friction_4tu_format() noexcept;
FieldFormat hatt_format() noexcept;
FieldFormat kinaesthetic_format() noexcept;

std::span<const FieldFormat> field_formats() noexcept {
  static const std::array table{
      cluster_texture_format(), sens3_format(), finger_friction_4tu_format(), hatt_format(),
      kinaesthetic_format(),
  };
  return table;
}

}  // namespace fingerpad
