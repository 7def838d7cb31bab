#pragma once

namespace fingerpad {

/// A soft sphere pressed on a plane, with adhesion (Johnson, Kendall & Roberts 1971).
struct JkrPad {
  double radius_m = 0;           ///< R, the pad's own
  double modulus_pa = 0;         ///< E*, the contact modulus; K = 4 E*/3
  double adhesion_j_per_m2 = 0;  ///< gamma, work of adhesion; 0 is Hertz

  /// w = 3 pi gamma R [N].
  double adhesion_load_n() const noexcept;
  /// a, from a^3 = (R/K)(n + w + sqrt(2 w n + w^2)); n from the pull-off tension (negative) up.
  double contact_radius_m(double normal_force_n) const noexcept;
  /// The tension at which the contact parts, w/2. Reported, not displayed: contact ends at depth 0.
  double pull_off_n() const noexcept;
};

}  // namespace fingerpad
