#include "study/fit_report.hpp"

#include <fmt/format.h>

#include <limits>

#include "study/few_trials.hpp"
#include "study/fit_figures.hpp"
#include "study/profile_text.hpp"

namespace fingerpad {
namespace {

StudyTable numbers_table(const ProfileFit& fit) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  StudyTable table{
      "numbers", {"number", "value", "low_95", "high_95", "samples", "trials", "refused", "unit"}, {}};
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const PadValue& value = fit.values[k];
    const auto& both = fit.interval[k];
    const bool is_given = value.refusal.empty();
    table.rows.push_back({std::string(pad_number_keys[k]), is_given ? value.value : none,
                          both ? both->first : none, both ? both->second : none,
                          static_cast<double>(value.samples), static_cast<double>(value.trials),
                          value.refusal, std::string(unit_of_key(pad_number_keys[k]))});
  }
  return table;
}

std::string html(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string html_list(const std::string& heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string out = fmt::format("<h2>{}</h2>\n<ul>\n", html(heading));
  for (const std::string& line : lines) out += fmt::format("<li>{}</li>\n", html(line));
  return out + "</ul>\n";
}

std::string numbers_html(const ProfileFit& fit) {
  std::string out =
      "<h2>Numbers</h2>\n<table><tr><th>number</th><th>value</th><th>unit</th><th>95 "
      "%</th><th>samples</th><th>trials</th></tr>\n";
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const PadValue& value = fit.values[k];
    if (!value.refusal.empty()) {
      out += fmt::format("<tr><td>{}</td><td colspan=\"5\">refused: {}</td></tr>\n", pad_number_keys[k],
                         html(value.refusal));
      continue;
    }
    const auto& both = fit.interval[k];
    out += fmt::format("<tr><td>{}</td><td>{:.5g}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                       pad_number_keys[k], value.value, unit_of_key(pad_number_keys[k]),
                       both ? fmt::format("{:.5g} to {:.5g}", both->first, both->second)
                            : no_interval_words(fit.no_interval[k]),
                       value.samples, value.trials);
  }
  return out + "</table>\n";
}

std::string checked_html(const CrossValidation& checked) {
  std::string out =
      fmt::format("<h2>Cross-validation</h2>\n<p>{}.</p>\n", html(cross_validation_words(checked)));
  if (checked.trials.empty()) return out;
  out +=
      "<table><tr><th>trial</th><th>tangential force, RMS [N]</th><th>built-in pad leaves</th>"
      "<th>with the fitted friction</th><th>fitted pad leaves</th></tr>\n";
  for (const HeldOutTrial& trial : checked.trials)
    out += fmt::format("<tr><td>{}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.4f}</td></tr>\n",
                       html(trial.name), trial.measured_rms_n, trial.built_in_rms_n, trial.own_friction_rms_n,
                       trial.fitted_rms_n);
  return out + "</table>\n";
}

}  // namespace

FitReport fit_report(const Measurement& measurement, const ProfileFit& fit, const FitSettings& settings) {
  FitReport report;
  const StickPicture stick = stick_picture(measurement, fit);
  const FitPictureSource source{measurement, fit, stick};
  // All figures are of friction.
  const bool has_friction = !measurement.trials.empty() || measurement.pressed.empty();
  if (!has_friction) report.without_picture = {"figures 3 to 11: " + measurement.pressed.front().lacks};
  for (Chart& chart : has_friction ? fit_figures(source) : std::vector<Chart>()) {
    if (!chart.panels.empty()) {
      report.study.charts.push_back(std::move(chart));
      continue;
    }
    report.without_picture.push_back(
        fmt::format("{}: {}", chart.title, chart.notes.empty() ? "" : chart.notes.front()));
  }
  report.checked = cross_validate(measurement, settings);
  report.study.tables = {numbers_table(fit), cross_validation_table(report.checked),
                         boundaries_table(source)};
  return report;
}

std::string fit_page(const FitReport& report, const ProfileFit& fit, const FitTold& told,
                     const std::string& source) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>A finger pad's "
      "profile</title>\n"
      "<style>body{font-family:sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#22262c}"
      "table{border-collapse:collapse}td,th{border:1px solid #dadee3;padding:.2em .6em;text-align:left}"
      "li{overflow-wrap:anywhere}img{max-width:100%;display:block;margin:1em 0}</style></head>\n<body>\n"
      "<h1>A finger pad's profile</h1>\n";
  page += fmt::format("<p>{}.</p>\n", html(source));
  for (const std::string& warning : told.warnings)
    page += fmt::format("<p><strong>{}</strong></p>\n", html(warning));
  page += numbers_html(fit);
  page += html_list("What the numbers rest on", fit_remarks(fit));
  std::vector<std::string> reading = told.reading;
  if (!told.understood.empty()) reading.push_back(told.understood);
  page += html_list("What was read", reading);
  page += html_list("From raw to clean", fit.steps);
  page += html_list("Outlying trials", outlier_notes(fit));
  page += checked_html(report.checked);
  page += "<h2>Figures</h2>\n";
  for (const Chart& chart : report.study.charts)
    page += fmt::format("<img src=\"{}.svg\" alt=\"{}\">\n", chart.name, html(chart.title));
  page += html_list("Figures that the data cannot support", report.without_picture);
  return page + "</body></html>\n";
}

}  // namespace fingerpad
