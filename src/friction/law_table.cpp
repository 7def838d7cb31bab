#include "friction/law_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_rule.hpp"

namespace fingerpad {

const LawEntry* find_law(std::string_view name) noexcept {
  const auto table = law_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [name](const LawEntry& entry) { return entry.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::string_view phase_name(Phase phase) noexcept {
  switch (phase) {
    case Phase::stick:
      return "stick";
    case Phase::slip:
      return "slip";
    case Phase::free:
      break;
  }
  return "free";
}

double LawSettings::number(const LawParameter& parameter) const {
  const auto given = numbers.find(parameter.key);
  return given == numbers.end() ? parameter.default_value : given->second;
}

std::string refusal(const LawParameter& parameter, double value) {
  if (!std::isfinite(value)) return "must be a finite number";
  if (value < parameter.min) return fmt::format("must be at least {}", parameter.min);
  if (value == parameter.min && !parameter.min_allowed) {
    return fmt::format("must be larger than {}", parameter.min);
  }
  if (value > parameter.max) return fmt::format("must be at most {}", parameter.max);
  return "";
}

double bounded_number(const LawSettings& settings, const LawParameter& parameter) {
  const double least = parameter.min_allowed ? parameter.min : std::max(parameter.min, 1 / huge);
  return within(settings.number(parameter), least, std::min(parameter.max, huge));
}

StickRule stick_rule_of(const LawSettings& settings) {
  return {v_min_m_per_s(settings), settings.restick, settings.events,
          StickRemedy{settings.remedy, bounded_number(settings, device_damping_parameter)}};
}

double v_min_m_per_s(const LawSettings& settings) {
  const bool given = settings.numbers.find(v_min_parameter.key) != settings.numbers.end();
  if (!given && settings.profile) return within(settings.profile->v_min_m_per_s, 0, huge);
  return bounded_number(settings, v_min_parameter);
}

}  // namespace fingerpad
