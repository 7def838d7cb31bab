#include "study/measurement_doubts.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/dead_channels.hpp"
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

std::vector<UnitDoubt> doubts_of_units(const RecordedMeasurement& recorded, FileTrials own,
                                       const MeasurementFormat& format) {
  const std::string& file = own.front().file;
  const auto told = recorded.told_units.find(file);
  const bool tells_times =
      told != recorded.told_units.end() && told->second[static_cast<std::size_t>(Quantity::time)].has_value();
  return unit_doubts(own, with_told(recorded, file, format), tells_times);
}

/// What swapped forces would be told by (swapped_forces_doubt); wrong times would make as odd ones of any.
std::string swapped_by_sure_times(const RecordedMeasurement& recorded, FileTrials own,
                                  const MeasurementFormat& format) {
  for (const UnitDoubt& doubt : doubts_of_units(recorded, own, format))
    if (doubt.is_of_times) return {};
  return swapped_forces_doubt(own);
}

}  // namespace

void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s) {
  each_file(recorded, [&](FileTrials own) {
    for (const UnitDoubt& doubt : doubts_of_units(recorded, own, format))
      if (doubt.is_refused) throw refused(own.front().file, doubt.words);
    // First: along the normal friction would be asked for the press's sign.
    if (const std::string swapped = swapped_by_sure_times(recorded, own, format); !swapped.empty())
      throw refused(own.front().file, swapped);
    ask_for_signs(own, format, delay_s);
  });
}

std::vector<std::string> doubts_of(const RecordedMeasurement& recorded, const MeasurementFormat& format) {
  std::vector<std::string> told;
  bool trials_can_be_odd = true;
  each_file(recorded, [&](FileTrials own) {
    const std::string& file = own.front().file;
    bool doubts_times = false;
    for (const UnitDoubt& doubt : doubts_of_units(recorded, own, format)) {
      doubts_times = doubts_times || doubt.is_of_times;
      if (!doubt.is_refused) told.push_back(fmt::format("{}: {}", file, doubt.words));
    }
    // By wrong times all is odd; what has swapped forces is refused, whatever else is odd in it.
    if (doubts_times || !swapped_forces_doubt(own).empty()) {
      trials_can_be_odd = false;
      return;
    }
    for (const auto& doubts :
         {height_doubts(own, recorded.trials), swapped_trial_doubts(own, recorded.trials),
          dead_channel_doubts(own, recorded.trials)})
      told.insert(told.end(), doubts.begin(), doubts.end());
  });
  // By wrong times or the wrong normal force of some all trials are odd, or none.
  if (!trials_can_be_odd) return told;
  const std::vector<std::string> odd = odd_trial_doubts(recorded.trials);
  told.insert(told.end(), odd.begin(), odd.end());
  return told;
}

}  // namespace fingerpad
