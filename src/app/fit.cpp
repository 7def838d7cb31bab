#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/commands.hpp"
#include "app/fit_cleaning_options.hpp"
#include "app/fit_pictures.hpp"
#include "app/fit_reading_options.hpp"
#include "app/output_folder.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "study/air_offset.hpp"
#include "study/few_trials.hpp"
#include "study/fit_told.hpp"
#include "study/measurement_doubts.hpp"
#include "study/measurement_reader.hpp"
#include "study/named_trials.hpp"
#include "study/odd_trials.hpp"
#include "study/profile_text.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

struct FitOptions {
  std::vector<std::string> measurements;
  std::string out, report;
  std::uint64_t seed = 1;
  bool quiet = false;
  ReadingOptions reading;
  CleaningOptions cleaning;
};

/// What is refused for one reason stands in one line; the profile has the reason beside each number.
void tell_refusals(const ProfileFit& fit) {
  std::vector<std::pair<std::string_view, std::vector<std::string_view>>> by_reason;
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const std::string_view reason = fit.values[k].refusal;
    if (reason.empty()) continue;
    const auto same = std::ranges::find(by_reason, reason, [](const auto& one) { return one.first; });
    if (same != by_reason.end()) {
      same->second.push_back(pad_number_keys[k]);
    } else {
      by_reason.push_back({reason, {pad_number_keys[k]}});
    }
  }
  for (const auto& [reason, keys] : by_reason) {
    const std::string others = keys.size() == 1 ? ""
                                                : fmt::format("; so for {} more: {}", keys.size() - 1,
                                                              fmt::join(keys.begin() + 1, keys.end(), ", "));
    print_out("{:<30} refused: {}{}\n", keys.front(), reason, others);
  }
}

void tell_fit(const ProfileFit& fit) {
  for (const std::string& note : fit_notes(fit)) print_out("{}\n", note);
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const PadValue& value = fit.values[k];
    if (!value.refusal.empty()) continue;
    const auto& both = fit.interval[k];
    print_out("{:<30} {:<11.5g} {:<5} {} ({} sample{}, {} trial{})\n", std::string(pad_number_keys[k]),
              value.value, unit_of_key(pad_number_keys[k]),
              both ? fmt::format("95 %: {:.5g} .. {:.5g}", both->first, both->second)
                   : no_interval_words(fit.no_interval[k]),
              value.samples, value.samples == 1 ? "" : "s", value.trials, value.trials == 1 ? "" : "s");
  }
  tell_refusals(fit);
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_err("fingerpad: warning: {}\n", warning);
}

void add_lines(const std::vector<std::string>& lines, std::vector<std::string>& to) {
  to.insert(to.end(), lines.begin(), lines.end());
}

/// All files that it reads.
std::vector<std::string> input_paths(const FitOptions& options) {
  std::vector<std::string> paths = options.measurements;
  if (!options.reading.positions.empty()) paths.push_back(options.reading.positions);
  return paths;
}

void refuse_lost_inputs(const FitReport& report, const FitOptions& options) {
  std::vector<std::string> names{"report.html"};
  for (const StudyTable& table : report.study.tables) names.push_back(table.name + ".csv");
  for (const Chart& chart : report.study.charts)
    for (const char* ending : {".png", ".svg"}) names.push_back(chart.name + ending);
  for (const std::string& name : names) refuse_overwriting(options.report + "/" + name, input_paths(options));
}

/// What a report is made of.
struct ReportSource {
  const Measurement& measurement;
  const ProfileFit& found;
  const FitSettings& settings;
  const FitTold& told;
  const std::string& source;
};

void tell_report(const FitOptions& options, const ReportSource& from) {
  const FitReport report = fit_report(from.measurement, from.found, from.settings);
  refuse_lost_inputs(report, options);
  const std::string written =
      write_fit_report(report, fit_page(report, from.found, from.told, from.source), options.report);
  if (options.quiet) return;
  print_out("{}\n", cross_validation_words(report.checked));
  for (const std::string& figure : report.without_picture) print_out("no picture of {}\n", figure);
  print_out("{}\n", written);
}

/// "1 trial of 1 subject".
std::string trials_text(const ProfileFit& found) {
  const auto ending = [](auto count) { return count == 1 ? "" : "s"; };
  return fmt::format("{} trial{} of {} subject{}", found.trials, ending(found.trials), found.subjects,
                     ending(found.subjects));
}

/// What is told of a file, without its name where that stands before it: whoever tells it names it.
std::string said_of(const std::string& path, const std::string& words) {
  return words.starts_with(path + ": ") ? words.substr(path.size() + 2) : words;
}

int fit(const FitOptions& options) {
  refuse_unfit_name(options.out, "fit", {".toml"});
  refuse_unwritable(options.out);
  refuse_overwriting(options.out, input_paths(options));
  std::optional<OutputFolder> report_folder;
  if (!options.report.empty()) report_folder.emplace(options.report);
  const MeasurementFormat format = measurement_format(options.reading);
  const CleaningSettings cleaning = cleaning_settings(options.cleaning);
  RecordedMeasurement recorded = read_measurements(options.measurements, format, options.reading.reader);
  std::vector<std::string> named = take_trial_units(options.reading.trial_units, format, recorded);
  if (std::string words = leave_out_trials(options.reading.left_out, recorded); !words.empty())
    named.push_back(std::move(words));
  std::vector<std::string> zeroed;
  if (cleaning.takes_tare) zeroed = take_off_hiding_offsets(recorded);
  FitTold told = told_of_reading(recorded, format);
  told.warnings.insert(told.warnings.begin(), zeroed.begin(), zeroed.end());
  for (const std::string& note : told.reading) print_err("fingerpad: {}\n", note);
  if (!told.understood.empty() && !options.quiet) print_err("fingerpad: {}\n", told.understood);
  warn(told.warnings);
  refuse_doubtful(recorded, format, cleaning.delay_s.value_or(0));
  leave_out_turned_presses(recorded);
  const std::string force_mend = recorded.force_mend;
  Measurement measurement = clean(std::move(recorded), cleaning);
  measurement.steps.insert(measurement.steps.begin(), zeroed.begin(), zeroed.end());
  measurement.steps.insert(measurement.steps.begin(), named.begin(), named.end());
  warn(left_out_warnings(measurement));
  add_lines(left_out_warnings(measurement), told.warnings);
  FitSettings settings{options.seed, blocks_of(options.cleaning)};
  settings.takes_axes_exponent = cleaning.takes_axes_exponent;
  const ProfileFit found = fit_profile(measurement, settings);
  const bool is_without_force =
      measurement.trials.empty() && !(measurement.without_force.empty() && measurement.pressed.empty());
  bool has_any = false;
  for (const PadValue& value : found.values) has_any = has_any || value.refusal.empty();
  if (!has_any) {
    for (const std::string& step : measurement.contact_steps) print_err("fingerpad: {}\n", step);
    // Of what was read, the first number's reason speaks of stick alone; slip is what friction is told by.
    const PadValue& slip = value_of(found.values, PadNumber::mu_dynamic);
    const std::string press =
        measurement.pressed.empty() ? "" : value_of(found.values, PadNumber::normal_stiffness).refusal;
    throw refused(
        options.measurements.front(),
        fmt::format("nothing can be fitted: {}{}{}{}{}", measurement.trials.empty() ? "" : "mu_dynamic: ",
                    said_of(options.measurements.front(), slip.refusal),
                    press.empty() ? "" : "; normal_stiffness_n_per_m: ", press,
                    is_without_force && !force_mend.empty() ? "; " + force_mend : ""));
  }
  std::error_code none;
  const bool replaces = options.out != "-" && std::filesystem::is_regular_file(options.out, none);
  std::string source = fmt::format("fitted to {}, seed {}:", trials_text(found), options.seed);
  for (const std::string& path : options.measurements) source += fmt::format(" {}", path);
  OutputFile file(options.out);
  file.write(profile_text(found, source));
  file.commit();
  if (!options.quiet && options.out != "-") tell_fit(found);
  tell_written(options.quiet, options.out, trials_text(found));
  if (replaces && !options.quiet) print_err("fingerpad: {}: replaced the file that was there\n", options.out);
  warn(fit_warnings(found));
  add_lines(fit_warnings(found), told.warnings);
  if (report_folder) tell_report(options, {measurement, found, settings, told, source});
  return 0;
}

}  // namespace

void add_fit(CLI::App& program, Action& action) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = program.add_subcommand("fit", "Fit a finger pad's profile to measurements");
  command
      ->add_option(
          "MEASUREMENT", options->measurements,
          "CSV or HDF5, traces too: t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n (force on the finger), and optionally "
          "nx,ny,nz (default 0,0,1), dx,dy,dz (finger direction), subject, trial (whole numbers)")
      ->required();
  refuse_empty(
      command->add_option("--out", options->out, "Profile to write (TOML), or - for standard output"))
      ->required();
  refuse_empty(
      command->add_option("--report", options->report,
                          "Folder for a report: report.html, tables, and the paper's figures 3 to 11 from "
                          "these measurements (SVG and PNG)"),
      "FOLDER");
  add_reading_options(*command, options->reading);
  add_cleaning_options(*command, options->cleaning);
  command->add_option("--seed", options->seed, "Of the intervals' bootstrap")->capture_default_str();
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A flat, rigid plate; forces on the finger. Each number comes with its 95 % interval over the trials; "
      "what the data cannot support is refused by name, under [refused], and the rest given.\n"
      "A line of units below a table's header (s,mm,mm,mm,N,N,N) is read, and must not contradict an "
      "option.\n"
      "A scene takes the profile as profile = \"PROFILE.toml\" in [finger].");
  command->callback([options, &action] { action = [options] { return fit(*options); }; });
}

}  // namespace fingerpad
