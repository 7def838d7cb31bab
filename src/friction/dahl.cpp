#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter dahl_parameters[] = {fixed_stiffness_parameter};

/// Dahl 1968, as a vector and with an exact step: dz = dx - |dx| z/z_c, f = sigma z, z_c = mu_d n/sigma.
///
/// No static peak. Creeps under an oscillating push. Unloading shortens the bristle to the new z_c: it slips.
class Dahl final : public FrictionLaw {
 public:
  explicit Dahl(double stiffness_n_per_m)
      : stiffness_n_per_m_(stiffness_n_per_m), compliance_m_per_n_(1 / stiffness_n_per_m) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const double z_c = m.mu_dynamic() * m.normal_force_n() * compliance_m_per_n_;
    const PlaneVector held = shortened(BoundedState(state).stretch_m(), z_c);
    const double moved = length(m.step_m());
    const PlaneVector z = z_c > 0 ? dahl_step(held, m.step_m(), moved / z_c) : held;
    return bristle_answer(-stiffness_n_per_m_ * z, z, bristle_phase(z - held, moved), state);
  }

 private:
  double stiffness_n_per_m_, compliance_m_per_n_;
};

}  // namespace

LawEntry dahl_law() noexcept {
  return {.name = "dahl",
          .summary = "Dahl 1968: a bristle that yields exponentially; mu_dynamic only",
          .parameters = dahl_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Dahl>(bounded_number(settings, fixed_stiffness_parameter));
          }};
}

}  // namespace fingerpad
