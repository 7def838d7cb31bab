#include <array>

#include "friction/law_table.hpp"

namespace fingerpad {

// Each law is defined in the file of its name; its line here makes it known to scenes, studies, help and
// tests.
LawEntry none_law() noexcept;
LawEntry coulomb_law() noexcept;
LawEntry stick_slip_law() noexcept;
LawEntry finger_pad_law() noexcept;
LawEntry salisbury_law() noexcept;
LawEntry salcudean_vlaar_law() noexcept;
LawEntry karnopp_law() noexcept;
LawEntry dahl_law() noexcept;
LawEntry lugre_law() noexcept;
LawEntry elasto_plastic_law() noexcept;
LawEntry max_displacement_law() noexcept;
LawEntry friction_cone_law() noexcept;
LawEntry contact_area_law() noexcept;
LawEntry kikuuwe_law() noexcept;

std::span<const LawEntry> law_table() noexcept {
  static const std::array table{
      none_law(),         coulomb_law(),         stick_slip_law(),       finger_pad_law(),
      salisbury_law(),    salcudean_vlaar_law(), karnopp_law(),          dahl_law(),
      lugre_law(),        elasto_plastic_law(),  max_displacement_law(), friction_cone_law(),
      contact_area_law(), kikuuwe_law(),
  };
  return table;
}

}  // namespace fingerpad
