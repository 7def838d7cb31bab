#include "app/study_output.hpp"

#include <fmt/format.h>

#include "trace/output_file.hpp"
#ifdef FINGERPAD_VIEW
#include "view/plot.hpp"
#endif

namespace fingerpad {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::string write_study(const StudyReport& report, const std::string& folder) {
  for (const StudyTable& table : report.tables) {
    OutputFile file(folder + "/" + table.name + ".csv");
    file.write(table.csv());
    file.commit();
  }
#ifdef FINGERPAD_VIEW
  for (const Chart& chart : report.charts) {
    for (const char* ending : {".png", ".svg"}) write_chart(chart, folder + "/" + chart.name + ending);
  }
  return fmt::format("{} and {} (PNG and SVG) in {}", counted(report.tables.size(), "table"),
                     counted(report.charts.size(), "chart"), folder);
#else
  return fmt::format("{} in {}; charts need a build with FINGERPAD_VIEW=ON",
                     counted(report.tables.size(), "table"), folder);
#endif
}

}  // namespace fingerpad
