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
      : bristle_(bristle), elastic_share_(elastic_share) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const TangentialMotion m = bounded(motion);
    const bool first = state.phase == Phase::free;
    bound(state);
    const Vec2 held = shortened(state.deflection_m, m.mu_static * m.normal_force_n / bristle_.sigma0_n_per_m);
    const double z_ss = bristle_.steady_deflection_m(m, length(m.velocity_m_per_s));
    const double moved = length(m.step_m);
    const Vec2 z = first || z_ss <= 0 ? held : stepped(held, m.step_m, moved, z_ss);
    const Phase phase = first ? Phase::stick : bristle_phase(z - held, moved);
    const Vec2 force = first ? Vec2(Vec2::Zero()) : bristle_.force_n(m, z, z - held);
    return bristle_answer(force, z, phase, state);
  }

 private:
  /// How plastic the bristle is, 0 .. 1 (Dupont 2002, eq. for alpha). |z| within the sine: a signed z there
  /// makes one direction of motion stiffer than the other.
  double alpha(const Vec2& z, double stretch, const Vec2& step, double z_ss) const noexcept {
    const double z_ba = elastic_share_ * z_ss;
    if (stretch <= z_ba || z.dot(step) <= 0) return 0;
    // The sine's top is flat: this near to z_ss it differs from 1 by less than 3e-10.
    if (z_ss - stretch <= 1e-5 * (z_ss - z_ba)) return 1;
    return 0.5 + 0.5 * std::sin(std::numbers::pi * (stretch - 0.5 * (z_ss + z_ba)) / (z_ss - z_ba));
  }

  static Vec2 step_at(double alpha, const Vec2& z, const Vec2& step, double moved, double z_ss) noexcept {
    return alpha > 1e-12 ? dahl_step(z, step, moved, z_ss / alpha) : Vec2(z + step);
  }

  Vec2 stepped(const Vec2& z, const Vec2& step, double moved, double z_ss) const noexcept {
    const double stretch = length(z);
    if (stretch + moved <= elastic_share_ * z_ss) return z + step;
    const double at_start = alpha(z, stretch, step, z_ss);
    double at_middle = at_start;
    // In near steady slip alpha is flat, and the start's value serves for the whole step.
    if (at_start < 0.99 || z.dot(step) < 0.9 * stretch * moved) {
      const Vec2 middle = step_at(at_start, z, step / 2, moved / 2, z_ss);
      at_middle = alpha(middle, length(middle), step, z_ss);
    }
    return shortened(step_at(at_middle, z, step, moved, z_ss), std::max(stretch, z_ss));
  }

  StribeckBristle bristle_;
  double elastic_share_;
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
