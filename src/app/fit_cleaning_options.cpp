#include "app/fit_cleaning_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/quantity_option.hpp"
#include "app/word_option.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/unit.hpp"

namespace fingerpad {
namespace {

const std::string times = "ms, us, s", hertz = "Hz, kHz";

/// Of a number that the command line has read already.
std::string fault_of_hertz(const std::string& text) {
  const double value = parse_number(text).value_or(-1);
  return value >= 0 && std::isfinite(value) ? "" : fmt::format("{} Hz: a frequency is 0 or more", text);
}

/// @throws Error (usage)
double delay_of(const std::string& text) {
  const auto delay_s = number_with_unit(text, factors_of(Quantity::time));
  if (!delay_s || !std::isfinite(*delay_s))
    throw Error(ErrorKind::usage, "--delay",
                fmt::format("'{}' is no time (7ms, or 0.007 for seconds), nor 'found' nor 'off'", text));
  if (std::abs(*delay_s) <= 1) return *delay_s;
  throw Error(ErrorKind::usage, "--delay",
              fmt::format("'{}' is more than a second, which no delay is{}", text,
                          parse_number(text) ? fmt::format("; milliseconds are {}ms", text) : ""));
}

}  // namespace

void add_cleaning_options(CLI::App& command, CleaningOptions& options) {
  take_units_within(command.add_option("--fill", options.fill_ms,
                                       "Gaps of samples up to this are filled with a line [ms]; 0: none"),
                    factors_of(Quantity::time, 1e-3), times, {0, 1000, "ms"})
      ->capture_default_str();
  command.add_option("--mains", options.mains, "Mains hum to take out of forces: any, 50, 60 or off")
      ->check(one_of({"any", "50", "60", "off"}))
      ->capture_default_str();
  command.add_flag("--no-tare", options.no_tare,
                   "Take forces as they are: no tare from moments without contact");
  command
      .add_option(
          "--delay", options.delay,
          "By how much force lags position (7ms; [s] where it has no unit), to be taken out; 'found' by "
          "cross-correlation, or 'off'")
      ->capture_default_str();
  take_units(command.add_option(
                 "--smoothing", options.smoothing_hz,
                 "Zero-phase low pass of positions and forces, this frequency being halved [Hz]; 0: none"),
             factors_of_hertz(), hertz)
      ->check(CLI::Validator(fault_of_hertz, ""))
      ->capture_default_str();
  command
      .add_option("--blocks", options.blocks,
                  "What the intervals' bootstrap draws: trials of each subject, or subjects")
      ->check(one_of({"trials", "subjects"}))
      ->capture_default_str();
  take_units_within(
      command.add_option(
          "--light", options.light_percent,
          "Samples pressed with less than this of what their trial is pressed with tell neither stick "
          "nor slip [%]; 0: none is left out"),
      factors_of_percent(), "%", {0, 90, "%"})
      ->capture_default_str();
  command
      .add_option(
          "--spring-load", options.spring_load,
          "How springs are taken to one load: 'found' by trials of several loads, or 'off' as they are")
      ->check(one_of({"found", "off"}))
      ->capture_default_str();
}

CleaningSettings cleaning_settings(const CleaningOptions& options) {
  CleaningSettings settings;
  settings.longest_fill_s = 1e-3 * options.fill_ms;
  settings.mains = options.mains == "off"  ? Mains::off
                   : options.mains == "50" ? Mains::hz_50
                   : options.mains == "60" ? Mains::hz_60
                                           : Mains::any;
  settings.takes_tare = !options.no_tare;
  settings.takes_delay = options.delay == "found";
  if (options.delay != "found" && options.delay != "off") settings.delay_s = delay_of(options.delay);
  settings.smoothing_hz = options.smoothing_hz;
  settings.takes_axes_exponent = options.spring_load == "found";
  settings.light_share = options.light_percent / 100;
  return settings;
}

Blocks blocks_of(const CleaningOptions& options) {
  return options.blocks == "subjects" ? Blocks::subjects : Blocks::trials;
}

}  // namespace fingerpad
