#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter creep_speed{
    "creep_speed_m_per_s", 0.01, 0, false,
    "v_t: below this speed the force falls to zero in proportion, so a push f creeps at f v_t/(mu n) [m/s]"};
constexpr LawParameter coulomb_parameters[] = {creep_speed};

/// Coulomb friction made continuous: f = -mu_d n v / max(|v|, v_t).
///
/// It has no stick phase: every tick is slip, and under a steady push f < mu_d n it creeps at f v_t/(mu_d n),
/// the known price of the continuity.
class Coulomb final : public FrictionLaw {
 public:
  explicit Coulomb(double creep_speed_m_per_s) : creep_speed_m_per_s_(creep_speed_m_per_s) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const BoundedMotion m(motion);
    const Polar v = polar(m.velocity_m_per_s());
    Friction answer;
    answer.force_n =
        (-m.mu_dynamic() * m.normal_force_n() * std::min(1.0, v.length / creep_speed_m_per_s_)) * v.direction;
    state.phase = Phase::slip;
    state.slip_direction = v.direction;
    state.last_velocity_m_per_s = m.velocity_m_per_s();
    return answer;
  }

 private:
  double creep_speed_m_per_s_;
};

}  // namespace

LawEntry coulomb_law() noexcept {
  return {.name = "coulomb",
          .summary = "Coulomb 1785, continuous through zero speed; creeps under a push",
          .parameters = coulomb_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Coulomb>(bounded_number(settings, creep_speed));
          }};
}

}  // namespace fingerpad
