#include "friction/bristle.hpp"
#include "friction/stribeck.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter lugre_parameters[] = {fixed_stiffness_parameter, stribeck_speed_parameter,
                                             bristle_damping_parameter, viscous_parameter};

/// LuGre (Canudas de Wit, Olsson, Astrom & Lischinsky 1995), as a vector: z' = v - sigma_0 |v| z/g(v),
/// f = sigma_0 z + sigma_1 z' + sigma_2 v, with Dahl's exact step for z (Euler needs sigma_0 |v| T/g < 2).
///
/// Drifts under an oscillating push below breakaway. sigma_1 and sigma_2 default to 0; with them |f| may pass
/// mu_s n.
class LuGre final : public FrictionLaw {
 public:
  explicit LuGre(const StribeckBristle& bristle) : bristle_(bristle) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const PlaneVector held = shortened(BoundedState(state).stretch_m(), bristle_.longest_deflection_m(m));
    const double z_c = bristle_.steady_deflection_m(m);
    const double moved = length(m.step_m());
    const PlaneVector z = z_c > 0 ? dahl_step(held, m.step_m(), moved / z_c) : held;
    return bristle_answer(bristle_.force_n(m, z, z - held), z, bristle_phase(z - held, moved), state);
  }

 private:
  StribeckBristle bristle_;
};

}  // namespace

LawEntry lugre_law() noexcept {
  return {.name = "lugre",
          .summary = "Canudas de Wit et al. 1995: Dahl's bristle with a Stribeck limit",
          .parameters = lugre_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<LuGre>(StribeckBristle(settings));
          },
          .has_static_limit = true};
}

}  // namespace fingerpad
