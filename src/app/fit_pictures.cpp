#include "app/fit_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/study_output.hpp"
#include "study/fit_figures.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

/// Figures that an earlier fit drew into the folder, as its page says, and this one does not.
void remove_old_figures(const std::vector<Chart>& charts, const std::string& earlier_page,
                        const std::string& folder) {
  for (const auto& [name, draw] : fit_figure_rows) {
    if (earlier_page.find(fmt::format("<img src=\"{}.svg\"", name)) == std::string::npos) continue;
#ifdef FINGERPAD_VIEW
    const auto is_it = [own = name](const Chart& chart) { return chart.name == own; };
    if (std::any_of(charts.begin(), charts.end(), is_it)) continue;
#else
    static_cast<void>(charts);
#endif
    for (const char* ending : {".png", ".svg"}) {
      const std::string figure = fmt::format("{}/{}{}", folder, name, ending);
      std::error_code none;  // one that cannot be removed is no reason to write no report
      if (std::filesystem::is_regular_file(figure, none)) std::filesystem::remove(figure, none);
    }
  }
}

}  // namespace

std::string write_fit_report(const FitReport& report, const std::string& page, const std::string& folder) {
  const std::string page_name = folder + "/report.html";
  std::ifstream earlier(page_name, std::ios::binary);
  const std::string earlier_page{std::istreambuf_iterator<char>(earlier), {}};
  OutputFile file(page_name);
  file.write(page);
  file.commit();
  remove_old_figures(report.study.charts, earlier_page, folder);
  return fmt::format("report.html, {}", write_study(report.study, folder));
}

}  // namespace fingerpad
