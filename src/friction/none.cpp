#include "friction/law_table.hpp"

namespace fingerpad {
namespace {

/// No friction: the surface the paper calls "an icy surface". Always slip, never a force.
class None final : public FrictionLaw {
 public:
  Friction tick(const TangentialMotion& /*motion*/, FrictionState& state) const noexcept override {
    state.phase = Phase::slip;
    return {};
  }
};

}  // namespace

LawEntry none_law() noexcept {
  return {.name = "none",
          .summary = "no friction",
          .make = [](const LawSettings&) -> std::unique_ptr<FrictionLaw> { return std::make_unique<None>(); },
          .rubs = false};
}

}  // namespace fingerpad
