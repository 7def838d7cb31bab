#include "study/measurement_doubts.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/file_trials.hpp"
#include "study/height_doubts.hpp"
#include "study/odd_trials.hpp"
#include "study/sign_doubts.hpp"
#include "study/swapped_forces.hpp"
#include "study/unit_doubts.hpp"

namespace fingerpad {
namespace {

/// With the units said that the file's own table tells.
MeasurementFormat with_told(const RecordedMeasurement& recorded, const std::string& file,
                            MeasurementFormat format) {
  const auto found = recorded.told_units.find(file);
  if (found == recorded.told_units.end()) return format;
  const auto tells = [&](Quantity quantity) {
    return found->second[static_cast<std::size_t>(quantity)].has_value();
  };
  if (const auto& told_s = found->second[static_cast<std::size_t>(Quantity::time)])
    format.seconds_per_unit = *told_s;
  format.says_time_unit = format.says_time_unit || tells(Quantity::time);
  format.says_unit = format.says_unit || tells(Quantity::length);
  format.says_force_unit = format.says_force_unit || tells(Quantity::force);
  format.says_torque_unit = format.says_torque_unit || tells(Quantity::torque);
  return format;
}

}  // namespace

void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s) {
  each_file(recorded, [&](FileTrials own) {
    for (const UnitDoubt& doubt : unit_doubts(own, with_told(recorded, own.front().file, format)))
      if (doubt.is_refused) throw refused(own.front().file, doubt.words);
    ask_for_signs(own, format, delay_s);
  });
}

std::vector<std::string> doubts_of(const RecordedMeasurement& recorded, const MeasurementFormat& format) {
  std::vector<std::string> told;
  bool doubts_times = false;
  each_file(recorded, [&](FileTrials own) {
    for (const UnitDoubt& doubt : unit_doubts(own, with_told(recorded, own.front().file, format))) {
      doubts_times = doubts_times || doubt.is_of_times;
      if (!doubt.is_refused) told.push_back(fmt::format("{}: {}", own.front().file, doubt.words));
    }
  });
  if (doubts_times) return told;  // by wrong times no trial's friction says anything
  bool are_swapped = false;
  each_file(recorded, [&](FileTrials own) {
    const std::string words = swapped_forces_doubt(own);
    if (words.empty()) return;
    are_swapped = true;
    told.push_back(fmt::format("{}: {}", own.front().file, words));
  });
  if (are_swapped) return told;  // by the wrong normal force no trial is odd
  const std::vector<std::string> heights = height_doubts(recorded.trials);
  told.insert(told.end(), heights.begin(), heights.end());
  const std::vector<std::string> odd = odd_trial_doubts(recorded.trials);
  told.insert(told.end(), odd.begin(), odd.end());
  return told;
}

}  // namespace fingerpad
