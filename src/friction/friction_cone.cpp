#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

/// Friction cone on a proxy (Harwin & Melder 2002; separate static and dynamic cones): the proxy stays while
/// the finger is within mu_s depth of it along the surface, else it moves to the rim of radius mu_d depth,
/// and slips on for as long as the finger is outside that rim. The surface is as stiff along itself as into
/// it, so the limits are mu_s n and mu_d n.
///
/// Starts in stick at the contact point. Unloading shrinks the cone: it slips.
class FrictionCone final : public FrictionLaw {
 public:
  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const Phase before = state.phase;
    if (before == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const double depth_m = m.normal_force_n() / m.surface_stiffness_n_per_m();
    const double rim_m = m.mu_dynamic() * depth_m;
    const double cone_m = before == Phase::slip ? rim_m : m.mu_static() * depth_m;
    PlaneVector z = BoundedState(state).stretch_m() + m.step_m();
    // A proxy that was put on the rim stands there: rounding must not make it slip at rest.
    const bool outside = is_longer(z, cone_m * (1 + 1e-12));
    if (outside) z = direction_of(z) * rim_m;
    return bristle_answer(-m.surface_stiffness_n_per_m() * z, z, outside ? Phase::slip : Phase::stick, state);
  }
};

}  // namespace

LawEntry friction_cone_law() noexcept {
  return {.name = "friction-cone",
          .summary = "Harwin & Melder 2002: a proxy held within a cone; as stiff as the surface",
          .make = [](const LawSettings&) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<FrictionCone>();
          },
          .has_static_limit = true};
}

}  // namespace fingerpad
