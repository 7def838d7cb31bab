// From recordings to a report, to a replay beside what was measured, by the program itself.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::fit_report_test {
namespace {
namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;

const fs::path measurements = test::source_dir() / "scenes/measurements";

class FitReportOfFiles : public testing::Test {
 protected:
  test::ShellResult program(const std::string& words) const {
    return test::shell(test::program().string() + " " + words, folder);
  }
  const fs::path folder = test::scratch_dir();
};

TEST_F(FitReportOfFiles, HoldsNumbersPicturesAndWhatTheFitForetells) {
  const auto fit = program(fmt::format("fit {} --out finger.toml --report report",
                                       (measurements / "synthetic_finger.csv").string()));
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_THAT(fit.out,
              AllOf(HasSubstr("on trials that a fit has not seen"), HasSubstr("report.html, 2 tables")));
  const std::string page = test::bytes_of(folder / "report/report.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("lateral_axis_m"), HasSubstr("Cross-validation"), HasSubstr("figure11.svg")));
  EXPECT_THAT(test::bytes_of(folder / "report/cross_validation.csv"), HasSubstr("fitted_rms_n"));
#ifdef FINGERPAD_VIEW
  for (const char* name :
       {"figure3", "figure4", "figure5_6", "figure7", "figure8", "figure9", "figure10", "figure11"}) {
    EXPECT_GT(fs::file_size(folder / fmt::format("report/{}.svg", name)), 2000u) << name;
    EXPECT_GT(fs::file_size(folder / fmt::format("report/{}.png", name)), 5000u) << name;
  }
#endif
}

double residual_rms_n(const std::string& summary) {
  std::smatch found;
  // Before its bias and lag, and the contact's method and normals.
  const std::regex row(R"(,([0-9.e+-]+),[^,]+,[^,]+,[a-z-]+,[a-z]+\n$)");
  return std::regex_search(summary, found, row) ? std::stod(found[1]) : -1;
}

TEST_F(FitReportOfFiles, AReplayWithTheFittedProfileLeavesLessOfTheMeasuredForce) {
  ASSERT_EQ(program(fmt::format("fit {} --out finger.toml --quiet",
                                (measurements / "synthetic_finger.csv").string()))
                .exit_code,
            0);
  std::string scene = test::bytes_of(test::source_dir() / "scenes/measured_rub.toml");
  scene = std::regex_replace(scene, std::regex("\"measurements/"), "\"" + measurements.string() + "/");
  std::ofstream(folder / "fitted.toml")
      << std::regex_replace(scene, std::regex("profiles/default.toml"), "finger.toml");
  const auto built_in = program(
      fmt::format("replay {} --out built_in", (test::source_dir() / "scenes/measured_rub.toml").string()));
  ASSERT_EQ(built_in.exit_code, 0) << built_in.err;
  const auto fitted = program("replay fitted.toml --out fitted");
  ASSERT_EQ(fitted.exit_code, 0) << fitted.err;
  const double less = residual_rms_n(test::bytes_of(folder / "fitted/summary.csv")),
               more = residual_rms_n(test::bytes_of(folder / "built_in/summary.csv"));
  EXPECT_GT(less, 0);
  EXPECT_LT(less, 0.8 * more);
#ifdef FINGERPAD_VIEW
  const auto plot = program("plot fitted/measured_rub.h5 --show residual --out residual.svg");
  EXPECT_EQ(plot.exit_code, 0) << plot.err;
  EXPECT_THAT(plot.out, HasSubstr("'model' less 'measured'"));
  const std::string picture = test::bytes_of(folder / "residual.svg");
  EXPECT_THAT(picture, AllOf(HasSubstr("measured"), HasSubstr("residual of")));
#endif
}

#ifdef FINGERPAD_VIEW
TEST_F(FitReportOfFiles, ATraceWithoutAMeasuredForceHasNoResidualToShow) {
  ASSERT_EQ(program(fmt::format("replay {} --out out", (test::source_dir() / "scenes/figure2.toml").string()))
                .exit_code,
            0);
  const auto plot = program("plot out/figure2.h5 --show residual --out residual.svg");
  EXPECT_EQ(plot.exit_code, 3);
  EXPECT_THAT(plot.err, HasSubstr("its motion named no measured force"));
}
#endif

TEST_F(FitReportOfFiles, ANormalForceAloneIsRefusedOfAPublishedRecording) {
  fs::create_directories(folder / "sensor_data/force");
  fs::create_directories(folder / "sensor_data/position");
  std::ofstream force(folder / "sensor_data/force/0_0_40_500_0.csv"),
      position(folder / "sensor_data/position/0_0_40_500_0.csv");
  force << "time,force\n";
  for (int i = 0; i < 600; ++i) force << fmt::format("{:.6f},0.5\n", i / 6000.0);
  position << "time,X,Y\n";
  for (int i = 0; i < 11; ++i) position << fmt::format("{:.6f},{:.2f},45.0\n", i / 100.0, 0.4 * i);
  force.close();
  position.close();
  const auto fit = program("fit sensor_data/force/0_0_40_500_0.csv --reader cluster-texture --out none.toml");
  EXPECT_EQ(fit.exit_code, 3);
  EXPECT_THAT(fit.err, AllOf(HasSubstr("column fx_n missing"), HasSubstr("the normal force alone")));
  std::ofstream(folder / "slide.toml")
      << "[[plane]]\npoint_m = [0, 0, 0.001]\nnormal = [0, 0, 1]\n[motion]\nfile = "
         "\"sensor_data/force/0_0_40_500_0.csv\"\nformat = \"cluster-texture\"\nnormal_force = "
         "\"measured\"\n";
  const auto replay = program("replay slide.toml --out out");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(replay.err + replay.out, HasSubstr("positions, about 100 Hz"));
}

}  // namespace
}  // namespace fingerpad::fit_report_test
