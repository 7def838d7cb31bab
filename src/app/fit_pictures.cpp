#include "app/fit_pictures.hpp"

#include <fmt/format.h>

#include "app/study_output.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {

std::string write_fit_report(const FitReport& report, const std::string& page, const std::string& folder) {
  OutputFile file(folder + "/report.html");
  file.write(page);
  file.commit();
  return fmt::format("report.html, {}", write_study(report.study, folder));
}

}  // namespace fingerpad
