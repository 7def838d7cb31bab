#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter damping{"damping_n_s_per_m", 2, 0, true, "force per speed, whatever the load [N s/m]"};
constexpr LawParameter parameters[] = {damping};

class Viscous final : public FrictionLaw {
 public:
  explicit Viscous(double damping_n_s_per_m) : damping_n_s_per_m_(damping_n_s_per_m) {}
  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    Friction answer;
    answer.force_n = -damping_n_s_per_m_ * BoundedMotion(motion).velocity_m_per_s();
    state.phase = Phase::slip;
    return answer;
  }

 private:
  double damping_n_s_per_m_;
};

}  // namespace

LawEntry viscous_law() noexcept {
  return {"viscous", "a force against the motion, in proportion to it", parameters,
          [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Viscous>(bounded_number(settings, damping));
          }};
}

}  // namespace fingerpad
