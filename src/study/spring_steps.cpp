#include "study/spring_steps.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {

void tell_light_samples(const Measurement& measurement, const std::vector<StickSegments>& segments,
                        ProfileFit& fit) {
  std::size_t light = 0, all = 0;
  for (const StickSegments& trial : segments) {
    light += trial.light_samples;
    all += trial.phase.size();
  }
  if (all == 0) return;
  if (const double share = measurement.trials.front().light_share; share > 0) {
    fit.steps.push_back(
        fmt::format("light samples: {} of {} in touch are pressed with less than {} % of what their trial is "
                    "pressed with, or are lost in its noise: the normal law alone is told by them{}",
                    light, all, rounded_text(100 * share, 3),
                    light == all ? ", and nothing is left that tells friction" : ""));
  } else {
    fit.steps.push_back(fmt::format(
        "light samples: left in (--light 0), but for {} of {} that are lost in noise", light, all));
  }
}

void tell_axes_exponent(bool takes_axes_exponent, ProfileFit& fit) {
  if (!takes_axes_exponent) {
    fit.steps.emplace_back("springs: taken as they are under each load (--spring-load off)");
    return;
  }
  if (!fit.axes_exponent) return;
  constexpr double in_interval = 2;
  // Axes are mu(n) n over the stiffness.
  const PadValue& mu_exponent = value_of(fit.values, PadNumber::mu_load_exponent);
  const double mu_power = mu_exponent.refusal.empty() ? mu_exponent.value : 0,
               power = 1 + mu_power - fit.axes_exponent->value,
               reach = in_interval * fit.axes_exponent->deviation;
  fit.steps.push_back(fmt::format(
      "springs: over the loads of {} trials their stiffness in N/m goes with the load's power of {:.2f} "
      "(95 %: {:.2f} .. {:.2f}), where the pad's law, whose axes stay, has it go with the friction's, "
      "{:.2f}: "
      "they are taken to {} N by that power, and hold there",
      fit.axes_exponent->trials, power, power - reach, power + reach, 1 + mu_power,
      rounded_text(fit.mu_load_n, 3)));
}

}  // namespace fingerpad
