#include "app/fit_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/study_output.hpp"
#include "study/fit_figures.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

/// Figures that an earlier fit drew into the folder, and this one does not.
void remove_old_figures(const std::vector<Chart>& charts, const std::string& folder) {
  for (const std::string_view name : fit_figure_names) {
#ifdef FINGERPAD_VIEW
    const auto is_it = [&](const Chart& chart) { return chart.name == name; };
    if (std::any_of(charts.begin(), charts.end(), is_it)) continue;
#else
    static_cast<void>(charts);
#endif
    for (const char* ending : {".png", ".svg"}) {
      std::error_code none;  // one that cannot be removed is no reason to write no report
      std::filesystem::remove(fmt::format("{}/{}{}", folder, name, ending), none);
    }
  }
}

}  // namespace

std::string write_fit_report(const FitReport& report, const std::string& page, const std::string& folder) {
  OutputFile file(folder + "/report.html");
  file.write(page);
  file.commit();
  remove_old_figures(report.study.charts, folder);
  return fmt::format("report.html, {}", write_study(report.study, folder));
}

}  // namespace fingerpad
