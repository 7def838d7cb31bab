#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter max_displacement{
    "max_displacement_m", 0.0002, 0, false,
    "z_max: how far the contact lags behind [m]; mu_d/k_f at the defaults of the other laws"};
constexpr LawParameter stick_displacement{
    "stick_displacement_m", 0, 0, true,
    "z_stick of the smooth form, which yields gradually beyond about this [m]; 0 is the hard form"};
constexpr LawParameter parameters[] = {max_displacement, stick_displacement};

/// Hayward & Armstrong 2000: z = x - w, f = mu_d n z/z_max. Hard form: where |z| > z_max, w follows at that
/// distance. Smooth form: dw = |dx| alpha(z) z with alpha = z^8/(z_max (z_stick^8 + z^8)), and the hard limit
/// stays.
///
/// Driftless below the limit; spring and limit scale with the load.
class MaxDisplacement final : public FrictionLaw {
 public:
  MaxDisplacement(double max_m, double stick_m) : max_m_(max_m), stick_m_(stick_m) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const TangentialMotion m = bounded(motion);
    if (state.phase == Phase::free) return bristle_answer({0, 0}, {0, 0}, Phase::stick, state);
    bound(state);
    const Vec2& before = state.deflection_m;
    const double moved = length(m.step_m);
    const double yielded = stick_m_ > 0 ? std::min(1.0, moved * yielding_per_m(length(before))) : 0;
    const Vec2 stretched = before + m.step_m - yielded * before;
    const Vec2 z = shortened(stretched, max_m_);
    const bool yields = length(stretched) > max_m_ * (1 + 1e-12);
    const Phase phase = yields ? Phase::slip : bristle_phase(z - before, moved);
    return bristle_answer((-m.mu_dynamic * m.normal_force_n / max_m_) * z, z, phase, state);
  }

 private:
  /// alpha(z); with z = 0 the bristle does not yield.
  double yielding_per_m(double z) const noexcept {
    if (z <= 0) return 0;
    const double ratio = stick_m_ / z;
    const double square = ratio * ratio, fourth = square * square;
    return 1 / (max_m_ * (1 + fourth * fourth));
  }

  double max_m_, stick_m_;
};

}  // namespace

LawEntry max_displacement_law() noexcept {
  return {"max-displacement",
          "Hayward & Armstrong 2000: a contact that lags by at most z_max; mu_dynamic only", parameters,
          [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<MaxDisplacement>(bounded_number(settings, max_displacement),
                                                     bounded_number(settings, stick_displacement));
          }};
}

}  // namespace fingerpad
