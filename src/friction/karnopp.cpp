#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter zero_band{
    "zero_band_m_per_s", 0.001, 0, true,
    "D_v: speeds up to this count as rest, where friction answers the applied force [m/s]"};
constexpr LawParameter karnopp_parameters[] = {zero_band};

/// Karnopp 1985: mu_d n against the motion above D_v; within the band the applied force is answered in full,
/// up to mu_s n.
///
/// The applied force is the hand's: where no hand is simulated there is none, and the force in the band is 0.
class Karnopp final : public FrictionLaw {
 public:
  explicit Karnopp(double zero_band_m_per_s) : zero_band_m_per_s_(zero_band_m_per_s) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const BoundedMotion m(motion);
    const Polar v = polar(m.velocity_m_per_s());
    const double limit_n = m.mu_static() * m.normal_force_n();
    Friction answer;
    if (v.length > zero_band_m_per_s_) {
      state.slip_direction = v.direction;
      answer.force_n = (-m.mu_dynamic() * m.normal_force_n()) * v.direction;
    } else {
      const bool holds = !is_longer(m.applied_force_n(), limit_n);
      answer.phase = holds ? Phase::stick : Phase::slip;
      answer.centre_moved = holds;  // rigid: the centre is the contact point
      answer.force_n = -shortened(m.applied_force_n(), limit_n);
      if (!holds) state.slip_direction = direction_of(m.applied_force_n());
    }
    if (answer.phase == Phase::slip) {
      state.slip_force_scale = 1;
      answer.ruptures = state.phase == Phase::stick ? 1 : 0;
    }
    state.phase = answer.phase;
    state.last_velocity_m_per_s = m.velocity_m_per_s();
    return answer;
  }

 private:
  double zero_band_m_per_s_;
};

}  // namespace

LawEntry karnopp_law() noexcept {
  return {.name = "karnopp",
          .summary = "Karnopp 1985: rigid stick within a band of speed; 0 there without a simulated hand",
          .parameters = karnopp_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Karnopp>(bounded_number(settings, zero_band));
          },
          .has_static_limit = true};
}

}  // namespace fingerpad
