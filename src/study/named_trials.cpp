#include "study/named_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"

namespace fingerpad {
namespace {

constexpr std::string_view between = ", ";

std::string without_file(const RecordedTrial& trial) {
  return trial_name(trial).substr(trial.file.size() + between.size());
}

/// Whether each part of what is said is one of the trial's name.
bool is_named(const RecordedTrial& trial, std::string_view said) {
  if (said == trial_name(trial)) return true;
  if (said.starts_with(trial.file + std::string(between)))
    said.remove_prefix(trial.file.size() + between.size());
  const std::string own = fmt::format("{}{}{}", between, without_file(trial), between);
  if (said.empty()) return false;
  while (!said.empty()) {
    const std::size_t length = std::min(said.find(between), said.size());
    if (own.find(fmt::format("{}{}{}", between, said.substr(0, length), between)) == std::string::npos)
      return false;
    said.remove_prefix(std::min(length + between.size(), said.size()));
  }
  return true;
}

Error no_trial(const std::string& option, const std::string& said, const RecordedMeasurement& recorded) {
  constexpr std::size_t most = 6;
  std::string names;
  for (std::size_t i = 0; i < recorded.trials.size() && i < most; ++i)
    names += fmt::format("{}'{}'", i == 0 ? "" : ", ", without_file(recorded.trials[i]));
  return {ErrorKind::usage, option,
          fmt::format("no trial is called '{}'; there are {}{} (or with FILE before it, or 'trial 3' alone)",
                      printable(said, 80), names, recorded.trials.size() > most ? " .." : "")};
}

/// A unit of forces or of positions.
struct NamedUnit {
  Quantity quantity = Quantity::force;
  double si = 1;
};

std::optional<NamedUnit> unit_of(const std::string& word) {
  for (const Quantity quantity : {Quantity::force, Quantity::length})
    if (const auto si = si_per_unit(quantity, word)) return NamedUnit{quantity, *si};
  return std::nullopt;
}

/// What one unit of the file was taken for.
double taken_si(const NamedUnit& unit, const std::string& file, const MeasurementFormat& format,
                const RecordedMeasurement& recorded) {
  const double said = unit.quantity == Quantity::force ? format.newtons_per_unit : format.metres_per_unit;
  const auto told = recorded.told_units.find(file);
  return told == recorded.told_units.end()
             ? said
             : told->second[static_cast<std::size_t>(unit.quantity)].value_or(said);
}

/// A unit is said once, and not of a six-axis sensor, whose contact points come from torque over force.
void refuse_unfit_unit(const RecordedTrial& trial, const char* what, bool is_first) {
  if (!is_first)
    throw Error(ErrorKind::usage, "--trial-unit",
                fmt::format("{}: its {} are given two units; name it once", trial_name(trial), what));
  if (trial.sensor)
    throw Error(
        ErrorKind::usage, "--trial-unit",
        fmt::format("{}: its contact points are told from torque over force, which one unit would part; "
                    "bring its file to one unit, or leave it out (--leave-out)",
                    trial_name(trial)));
}

}  // namespace

std::string option_name(const RecordedTrial& trial, const std::vector<RecordedTrial>& all) {
  const auto is_alike = [&trial](const RecordedTrial& other) {
    return other.subject == trial.subject && other.number == trial.number &&
           (trial.piece == 0 || other.piece == trial.piece);
  };
  return std::ranges::count_if(all, is_alike) > 1 ? trial_name(trial) : without_file(trial);
}

std::string leave_out_trials(const std::vector<std::string>& named, RecordedMeasurement& recorded) {
  for (const std::string& said : named)
    if (std::ranges::none_of(recorded.trials, [&](const auto& trial) { return is_named(trial, said); }))
      throw no_trial("--leave-out", said, recorded);
  std::string left_out;
  const std::size_t count = std::erase_if(recorded.trials, [&](const RecordedTrial& trial) {
    if (std::ranges::none_of(named, [&](const auto& said) { return is_named(trial, said); })) return false;
    left_out += fmt::format("{}{}", left_out.empty() ? "" : "; ", trial_name(trial));
    return true;
  });
  if (count == 0) return {};
  if (recorded.trials.empty())
    throw Error(ErrorKind::usage, "--leave-out", "leaves no trial to be fitted: name fewer");
  return fmt::format("left out (--leave-out): {}", left_out);
}

std::vector<std::string> take_trial_units(const std::vector<std::string>& said,
                                          const MeasurementFormat& format, RecordedMeasurement& recorded) {
  std::vector<std::string> told;
  std::set<std::pair<std::size_t, Quantity>> taken;
  for (const std::string& text : said) {
    const std::size_t equals = std::min(text.rfind('='), text.size());
    const std::string name = text.substr(0, equals), word = text.substr(std::min(equals + 1, text.size()));
    const auto unit = unit_of(word);
    if (!unit)
      throw Error(ErrorKind::usage, "--trial-unit",
                  fmt::format("'{}' is no NAME=UNIT with a UNIT of forces (N, mN, ..) or positions (m, cm, "
                              "mm, in): say 'trial 3=mN'",
                              printable(text, 80)));
    const char* what = unit->quantity == Quantity::force ? "forces" : "positions";
    bool is_there = false;
    for (std::size_t i = 0; i < recorded.trials.size(); ++i) {
      RecordedTrial& trial = recorded.trials[i];
      if (!is_named(trial, name)) continue;
      is_there = true;
      refuse_unfit_unit(trial, what, taken.emplace(i, unit->quantity).second);
      const double times = unit->si / taken_si(*unit, trial.file, format, recorded);
      (unit->quantity == Quantity::force ? trial.force_W : trial.position_W) *= times;
      if (unit->quantity == Quantity::length) trial.tracked_W *= times;
      told.push_back(
          fmt::format("{}: its {} are taken to be in {} (--trial-unit), {} times what its file's would be",
                      trial_name(trial), what, word, rounded_text(times, 4)));
    }
    if (!is_there) throw no_trial("--trial-unit", name, recorded);
  }
  return told;
}

}  // namespace fingerpad
