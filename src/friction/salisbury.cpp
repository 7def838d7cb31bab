#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter parameters[] = {fixed_stiffness_parameter};

/// Salisbury, Brock, Massie, Swarup & Zilles 1995: f = k (x - c); where |f| > mu_s n the centre jumps to
/// c = x - (mu_d n/k) u, u the direction of the spring. A sawtooth at every speed, between mu_d n and mu_s n.
///
/// The stiffness does not follow the load, so unloading alone slips. A tick of slip is one in which c jumped.
class Salisbury final : public FrictionLaw {
 public:
  explicit Salisbury(double stiffness_n_per_m) : stiffness_n_per_m_(stiffness_n_per_m) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    PlaneVector z = BoundedState(state).deflection_m() + m.step_m();
    const double limit_n = m.mu_static() * m.normal_force_n();
    Phase phase = Phase::stick;
    // Where mu_d = mu_s the centre is put on the limit itself: rounding must not move it again at rest.
    if (is_longer(stiffness_n_per_m_ * z, limit_n * (1 + 1e-12))) {
      z = direction_of(z) * (m.mu_dynamic() * m.normal_force_n() / stiffness_n_per_m_);
      phase = Phase::slip;
    }
    return bristle_answer(-stiffness_n_per_m_ * z, z, phase, state);
  }

 private:
  double stiffness_n_per_m_;
};

}  // namespace

LawEntry salisbury_law() noexcept {
  return {"salisbury", "Salisbury et al. 1995: a spring whose centre jumps; fixed stiffness", parameters,
          [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Salisbury>(bounded_number(settings, fixed_stiffness_parameter));
          }};
}

}  // namespace fingerpad
