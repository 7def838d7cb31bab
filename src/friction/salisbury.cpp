#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_walk.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter salisbury_parameters[] = {fixed_stiffness_parameter};

/// Salisbury, Brock, Massie, Swarup & Zilles 1995: f = k (x - c); where |f| > mu_s n the centre jumps to
/// c = x - (mu_d n/k) u, u the direction of the spring. A sawtooth at every speed, between mu_d n and mu_s n.
///
/// The stiffness does not follow the load, so unloading alone slips. A tick of slip is one in which c jumped.
class Salisbury final : public FrictionLaw {
 public:
  Salisbury(double stiffness_n_per_m, Events events)
      : stiffness_n_per_m_(stiffness_n_per_m), events_(events) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const PlaneVector before = BoundedState(state).stretch_m();
    const PlaneVector z = before + m.step_m();
    const double limit_n = m.mu_static() * m.normal_force_n();
    // Where mu_d = mu_s the centre is put on the limit itself: rounding must not move it again at rest.
    if (!is_longer(stiffness_n_per_m_ * z, limit_n * (1 + 1e-12)))
      return bristle_answer(-stiffness_n_per_m_ * z, z, Phase::stick, state);
    return events_ == Events::exact ? jumped_within(m, before, state) : jumped(m, z, state);
  }

 private:
  Friction jumped(const BoundedMotion& m, const PlaneVector& z, FrictionState& state) const noexcept {
    return jumped_to(direction_of(z) * (m.mu_dynamic() * m.normal_force_n()), 1, state);
  }

  Friction jumped_within(const BoundedMotion& m, const PlaneVector& before,
                         FrictionState& state) const noexcept {
    const CircleSpring spring{1, stiffness_n_per_m_};
    const StickEnd end =
        walk_of_teeth(spring.ratio_of(before), spring.ratio_of(m.step_m()),
                      m.mu_dynamic() * m.normal_force_n(), m.mu_static() * m.normal_force_n());
    return jumped_to(end.ratio, end.ruptures, state);
  }

  Friction jumped_to(const PlaneVector& pull_n, int ruptures, FrictionState& state) const noexcept {
    Friction answer = bristle_answer(-pull_n, pull_n / stiffness_n_per_m_, Phase::slip, state);
    answer.ruptures = ruptures;
    return answer;
  }

  double stiffness_n_per_m_;
  Events events_;
};

}  // namespace

LawEntry salisbury_law() noexcept {
  return {.name = "salisbury",
          .summary = "Salisbury et al. 1995: a spring whose centre jumps; fixed stiffness",
          .parameters = salisbury_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Salisbury>(bounded_number(settings, fixed_stiffness_parameter),
                                               settings.events);
          },
          .choices = rupture_choices,
          .has_static_limit = true};
}

}  // namespace fingerpad
