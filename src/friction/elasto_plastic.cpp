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
constexpr LawParameter parameters[] = {fixed_stiffness_parameter, stribeck_speed_parameter,
                                       bristle_damping_parameter, viscous_parameter, elastic_share};

/// Elasto-plastic bristle (Dupont, Hayward, Armstrong & Altpeter 2002): LuGre with its plastic term times
/// alpha(z, v), so that small motions are purely elastic and do not drift.
///
/// Deviation: z_ba is a share of z_ss(v) = g(v)/sigma_0, not of F_s/sigma_0, so that z_ba < z_ss at every
/// speed. The step takes alpha at its middle; with alpha held it is exact.
class ElastoPlastic final : public FrictionLaw {
 public:
  ElastoPlastic(const StribeckBristle& bristle, double elastic_share)
      : bristle_(bristle),
        elastic_share_(elastic_share),
        middle_share_(0.5 * (1 + elastic_share)),
        per_width_(1 / (1 - elastic_share)) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const PlaneVector held = shortened(BoundedState(state).deflection_m(), bristle_.longest_deflection_m(m));
    const double z_ss = bristle_.steady_deflection_m(m);
    const double moved = length(m.step_m());
    const PlaneVector z = z_ss > 0 ? stepped(held, m.step_m(), moved, z_ss) : held;
    return bristle_answer(bristle_.force_n(m, z, z - held), z, bristle_phase(z - held, moved), state);
  }

 private:
  /// 1 - alpha where that is below 0.01, near the flat top of the sine, as its series; 1 elsewhere.
  double elastic_rest(double stretch_share) const noexcept {
    const double below_top = (1 - stretch_share) * per_width_;
    if (below_top <= 0) return 0;
    const double t = std::numbers::pi * std::numbers::pi / 4 * below_top * below_top;
    if (t > 0.01) return 1;
    // sin^2 of the root of t
    return t * ((1 - t * (1.0 / 3)) + t * t * ((2.0 / 45 - t * (1.0 / 315)) + t * t * (2.0 / 14175)));
  }

  /// How plastic the bristle is, 0 .. 1 (Dupont 2002, eq. for alpha), at a stretch of |z|/z_ss along the
  /// motion. |z| within the sine: a signed z there makes one direction of motion stiffer than the other.
  double alpha(double stretch_share) const noexcept {
    if (stretch_share <= elastic_share_) return 0;
    const double rest = elastic_rest(stretch_share);
    return rest < 1 ? 1 - rest : 0.5 + 0.5 * sine_of_half_turns((stretch_share - middle_share_) * per_width_);
  }

  PlaneVector stepped(const PlaneVector& z, const PlaneVector& step, double moved,
                      double z_ss) const noexcept {
    const double stretch = length(z);
    if (stretch + moved <= elastic_share_ * z_ss) return z + step;
    const double per_z_ss = 1 / z_ss, x = moved * per_z_ss;
    const double along = z.dot(step);
    const double rest = elastic_rest(stretch * per_z_ss);
    if (rest < 1 && x > 1e-3 && x < 2 && along >= 0.9 * stretch * moved) {
      // In near steady slip alpha is flat, and the start's value serves for the whole step.
      const Yielding yielded = yielding_less(x, rest);
      return shortened(z + step * yielded.per_x - z * yielded.share, std::max(stretch, z_ss));
    }
    const double at_start = along > 0 ? alpha(stretch * per_z_ss) : 0;
    return shortened(stepped_by_middle(z, step, x, at_start, per_z_ss), std::max(stretch, z_ss));
  }

  /// The step with alpha as it is at its middle. Half an implicit step finds the middle: the order stays two.
  [[gnu::noinline]] PlaneVector stepped_by_middle(const PlaneVector& z, const PlaneVector& step, double x,
                                                  double at_start, double per_z_ss) const noexcept {
    const PlaneVector middle = (z + 0.5 * step) * (1 / (1 + 0.5 * x * at_start));
    const double at_middle = middle.dot(step) > 0 ? alpha(length(middle) * per_z_ss) : 0;
    return dahl_step(z, step, x * at_middle);
  }

  StribeckBristle bristle_;
  double elastic_share_, middle_share_, per_width_;  // z_ba, the middle of z_ba .. z_ss, its width; over z_ss
};

}  // namespace

LawEntry elasto_plastic_law() noexcept {
  return {"elasto-plastic", "Dupont et al. 2002: LuGre that is elastic below a share of its limit",
          parameters, [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<ElastoPlastic>(StribeckBristle(settings),
                                                   bounded_number(settings, elastic_share));
          }};
}

}  // namespace fingerpad
