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
constexpr LawParameter max_displacement_parameters[] = {max_displacement, stick_displacement};

/// Hayward & Armstrong 2000: z = x - w, f = mu_d n z/z_max. Hard form: where |z| > z_max, w follows at that
/// distance. Smooth form: dw = |dx| alpha(z) z with alpha = z^8/(z_max (z_stick^8 + z^8)), and the hard limit
/// stays.
///
/// Driftless below the limit; spring and limit scale with the load.
class MaxDisplacement final : public FrictionLaw {
 public:
  MaxDisplacement(double max_m, double stick_m)
      : max_m_(max_m),
        per_max_m_(1 / max_m),
        per_stick_square_(stick_m > 0 ? std::min(1 / (stick_m * stick_m), huge) : 0) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const PlaneVector before = BoundedState(state).stretch_m();
    const double moved = length(m.step_m());
    const double yielded = per_stick_square_ > 0 ? std::min(1.0, moved * yielding_per_m(before)) : 0;
    const PlaneVector stretched = before + m.step_m() - yielded * before;
    const PlaneVector z = shortened(stretched, max_m_);
    const bool yields = is_longer(stretched, max_m_ * (1 + 1e-12));
    const Phase phase = yields ? Phase::slip : bristle_phase(z - before, moved);
    return bristle_answer((-m.mu_dynamic() * m.normal_force_n() * per_max_m_) * z, z, phase, state);
  }

 private:
  /// alpha(z); with z = 0 the bristle does not yield.
  double yielding_per_m(const PlaneVector& z) const noexcept {
    const double square = std::min(z.square() * per_stick_square_, 1e30);  // from there on it is 1/z_max
    const double fourth = square * square, eighth = fourth * fourth;
    return per_max_m_ * eighth / (1 + eighth);
  }

  double max_m_, per_max_m_;
  double per_stick_square_;  // 0: the hard form
};

}  // namespace

LawEntry max_displacement_law() noexcept {
  return {.name = "max-displacement",
          .summary = "Hayward & Armstrong 2000: a contact that lags by at most z_max; mu_dynamic only",
          .parameters = max_displacement_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<MaxDisplacement>(bounded_number(settings, max_displacement),
                                                     bounded_number(settings, stick_displacement));
          }};
}

}  // namespace fingerpad
