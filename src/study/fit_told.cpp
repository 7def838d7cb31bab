#include "study/fit_told.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/number_text.hpp"
#include "study/measurement_doubts.hpp"
#include "study/measurement_words.hpp"
#include "study/pad_axes.hpp"
#include "study/profile_text.hpp"

namespace fingerpad {
namespace {

/// Of a coefficient that no fingertip has, from oiled glass to moist rubber; else empty.
std::string odd_friction_words(const PadValues& values) {
  constexpr double least = 0.05, most = 4;
  const PadValue& mu = value_of(values, PadNumber::mu_dynamic);
  const bool is_less = mu.value<least, is_more = mu.value> most;
  if (!mu.refusal.empty() || (!is_less && !is_more)) return {};
  return fmt::format(
      "mu_dynamic comes out as {}, {} than a fingertip's ({} to {}): are the force's columns, its unit and "
      "its zero right?",
      rounded_text(mu.value, 3), is_less ? "less" : "more", least, most);
}

}  // namespace

FitTold told_of_reading(const RecordedMeasurement& recorded, const MeasurementFormat& format) {
  FitTold told{recorded.notes, measurement_words(recorded), recorded.warnings};
  const std::vector<std::string> doubts = doubts_of(recorded, format);
  told.warnings.insert(told.warnings.end(), doubts.begin(), doubts.end());
  return told;
}

std::vector<std::string> left_out_warnings(const Measurement& measurement) {
  std::vector<std::string> warnings;
  for (const std::string& name : measurement.untouched)
    warnings.push_back(
        fmt::format("{}: the finger never presses with more than {} N, below which a sensor's "
                    "offset would be most of the friction; the trial is left out",
                    name, least_normal_force_n));
  if (measurement.trials.empty() && measurement.pressed.empty())
    return warnings;  // nothing is left to be fitted, which is told otherwise
  for (const std::string& reason : measurement.without_force)
    warnings.push_back(reason + "; the file is left out");
  return warnings;
}

std::vector<std::string> fit_warnings(const ProfileFit& fit) {
  std::vector<std::string> warnings;
  if (std::string odd = odd_friction_words(fit.values); !odd.empty()) warnings.push_back(std::move(odd));
  if (!fit.residual.misfit.empty()) warnings.push_back("the pad's law does not fit: " + fit.residual.misfit);
  if (std::string missing = missing_axes_words(fit); !missing.empty()) warnings.push_back(std::move(missing));
  return warnings;
}

}  // namespace fingerpad
