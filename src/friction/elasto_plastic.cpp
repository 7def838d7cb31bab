#include <algorithm>
#include <numbers>

#include "friction/bristle.hpp"
#include "friction/stribeck.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter elastic_share{
    "elastic_share",
    0.7,
    0,
    true,
    "z_ba/z_ss: share of the steady deflection within which the bristle is purely elastic",
    0.999};
constexpr LawParameter elasto_plastic_parameters[] = {fixed_stiffness_parameter, stribeck_speed_parameter,
                                                      bristle_damping_parameter, viscous_parameter,
                                                      elastic_share};

/// Elasto-plastic bristle (Dupont, Hayward, Armstrong & Altpeter 2002): LuGre with its plastic term times
/// alpha(z, v), so that small motions are purely elastic and do not drift.
///
/// Deviation: z_ba is a share of z_ss(v) = g(v)/sigma_0, not of F_s/sigma_0, so that z_ba < z_ss at every
/// speed. The step takes alpha at its middle, or its mean where that is near 1: second order.
class ElastoPlastic final : public FrictionLaw {
 public:
  ElastoPlastic(const StribeckBristle& bristle, double elastic_share)
      : bristle_(bristle),
        elastic_share_(elastic_share),
        middle_share_(0.5 * (1 + elastic_share)),
        per_width_(1 / (1 - elastic_share)),
        rest_per_gap2_(0.25 * std::numbers::pi * std::numbers::pi * per_width_ * per_width_) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const PlaneVector held = shortened(BoundedState(state).stretch_m(), bristle_.longest_deflection_m(m));
    const double z_ss = bristle_.steady_deflection_m(m);
    const double moved = length(m.step_m());
    const PlaneVector z = z_ss > 0 ? stepped(held, m.step_m(), moved, z_ss) : held;
    return bristle_answer(bristle_.force_n(m, z, z - held), z, bristle_phase(z - held, moved), state);
  }

 private:
  /// How plastic the bristle is, 0 .. 1 (Dupont 2002, eq. for alpha), at a stretch of |z|/z_ss along the
  /// motion. |z| within the sine: a signed z there makes one direction of motion stiffer than the other.
  double alpha(double stretch_share) const noexcept {
    if (stretch_share <= elastic_share_) return 0;
    if (stretch_share >= 1) return 1;
    return 0.5 + 0.5 * sine_of_half_turns((stretch_share - middle_share_) * per_width_);
  }

  PlaneVector stepped(const PlaneVector& z, const PlaneVector& step, double moved,
                      double z_ss) const noexcept {
    const double per_z_ss = 1 / z_ss, x = std::min(longest_step, moved * per_z_ss);
    const double along = z.dot(step);
    if (along > 0 && (z + 0.5 * step).square() > z_ss * z_ss) return stepped_in_slip(z, step, x, z_ss);
    const double stretch = length(z);
    if (stretch + moved <= elastic_share_ * z_ss) return z + step;
    const double at_start = along > 0 ? alpha(stretch * per_z_ss) : 0;
    return shortened(stepped_by_middle(z, step, x, at_start, per_z_ss), std::max(stretch, z_ss));
  }

  /// The step where its middle is beyond z_ss if nothing yields: alpha is near 1 or becomes so within it.
  /// 1 - alpha is about the square of pi/2 (1 - |z|/z_ss)/(1 - z_ba) then, and decays over the step.
  PlaneVector stepped_in_slip(const PlaneVector& z, const PlaneVector& step, double x,
                              double z_ss) const noexcept {
    // Of the square of 1 - |z|/z_ss = 1 - sqrt(1 - below) the first terms: no root to wait for.
    const double below = std::max(0.0, 1 - z.square() / (z_ss * z_ss));
    const double gap2 = below * below * (0.25 + 0.125 * below);
    const double rest = std::min(0.5, gap2 * (rest_per_gap2_ / (1 + x)));
    // Dahl's step for alpha x, with e^y as its series to y^4: no step is too long for its inverse.
    const double y = x - x * rest, y2 = y * y;
    const double grown = (1 + y) + y2 * ((0.5 + y * (1.0 / 6)) + y2 * (1.0 / 24));
    const double pushed = (1 + y * 0.5) + y2 * (1.0 / 6 + y * (1.0 / 24));  // (grown - 1)/y
    return shortened((z + pushed * step) * (1 / grown), std::max(length(z), z_ss));
  }

  /// The step with alpha as it is at its middle. Half an implicit step finds the middle: the order stays two.
  [[gnu::noinline]] PlaneVector stepped_by_middle(const PlaneVector& z, const PlaneVector& step, double x,
                                                  double at_start, double per_z_ss) const noexcept {
    const PlaneVector middle = (z + 0.5 * step) * (1 / (1 + 0.5 * x * at_start));
    const double at_middle = middle.dot(step) > 0 ? alpha(length(middle) * per_z_ss) : 0;
    return dahl_step(z, step, x * at_middle);
  }

  /// In z_ss: beyond it every step ends in steady slip, and nothing overflows below it.
  static constexpr double longest_step = 1e30;

  StribeckBristle bristle_;
  double elastic_share_, middle_share_, per_width_;  // z_ba, the middle of z_ba .. z_ss, its width; over z_ss
  double rest_per_gap2_;                             // (1 - alpha)/(1 - |z|/z_ss)^2 near 1
};

}  // namespace

LawEntry elasto_plastic_law() noexcept {
  return {.name = "elasto-plastic",
          .summary = "Dupont et al. 2002: LuGre that is elastic below a share of its limit",
          .parameters = elasto_plastic_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<ElastoPlastic>(StribeckBristle(settings),
                                                   bounded_number(settings, elastic_share));
          },
          .has_static_limit = true};
}

}  // namespace fingerpad
