// From recordings to a report, to a replay beside what was measured, by the program itself.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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

/// A page's text, without tags.
std::string text_of(std::string page) {
  page = std::regex_replace(page, std::regex("<[^>]*>"), " ");
  for (const auto& [coded, plain] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    page = std::regex_replace(page, std::regex(coded), plain);
  return page;
}

/// What the terminal told that is no number's row and no word of what was written.
std::vector<std::string> told_lines(const test::ShellResult& fit) {
  std::vector<std::string> lines;
  std::istringstream all(fit.out + fit.err);
  for (std::string line; std::getline(all, line);) {
    line = std::regex_replace(line, std::regex("^(fingerpad: (warning: )?|no picture of )"), "");
    const bool is_row = std::regex_search(line, std::regex("^[a-z_0-9]+ +(refused: |[0-9.e-]+ )"));
    const bool is_written = line.starts_with("wrote ") || line.starts_with("report.html, ") ||
                            line.ends_with(": replaced the file that was there");
    if (!is_row && !is_written) lines.push_back(line);
  }
  return lines;
}

/// The terminal's words, all of them.
void expect_told(const test::ShellResult& fit, const std::string& page) {
  const std::string text = text_of(page);
  const std::vector<std::string> lines = told_lines(fit);
  EXPECT_GT(lines.size(), 6u);
  for (const std::string& line : lines) EXPECT_THAT(text, HasSubstr(line));
}

TEST_F(FitReportOfFiles, HoldsNumbersPicturesAndWhatTheFitForetells) {
  const auto fit = program(fmt::format("fit {} --out finger.toml --report report",
                                       (measurements / "synthetic_finger.csv").string()));
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_THAT(fit.out,
              AllOf(HasSubstr("on trials that a fit has not seen"), HasSubstr("report.html, 3 tables")));
  const std::string page = test::bytes_of(folder / "report/report.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("lateral_axis_m"), HasSubstr("Cross-validation"), HasSubstr("figure11.svg")));
  expect_told(fit, page);
  EXPECT_THAT(test::bytes_of(folder / "report/cross_validation.csv"), HasSubstr("fitted_rms_n"));
#ifdef FINGERPAD_VIEW
  for (const char* name : {"figure3", "figure4", "figure5_6", "figure7", "figure8", "figure9", "figure10",
                           "figure11", "stick_and_slip"}) {
    EXPECT_GT(fs::file_size(folder / fmt::format("report/{}.svg", name)), 2000u) << name;
    EXPECT_GT(fs::file_size(folder / fmt::format("report/{}.png", name)), 5000u) << name;
  }
#endif
}

/// With an offset that no tare takes and another's file left out, with steps left out, and of two trials.
TEST_F(FitReportOfFiles, SaysAllThatTheTerminalSays) {
  const std::string shipped = (measurements / "synthetic_finger.csv").string();
  std::ofstream(folder / "off.awk")
      << "BEGIN { FS = OFS = \",\" } /^[0-9]/ { $5 += 0.08; if ($1 < 0.45 || $1 > 1.6) next } { print }\n";
  std::ofstream(folder / "two.awk") << "BEGIN { FS = \",\" } /^t_s/ || $12 == 1 || $12 == 2 { print }\n";
  std::ofstream(folder / "normal_only.csv")
      << "t_s,x_m,y_m,z_m,fz_n\n0,0,0,0,1\n0.001,0,0,0,1\n0.002,0,0,0,1\n";
  ASSERT_EQ(test::shell(fmt::format("awk -f off.awk {0} > off.csv && awk -f two.awk {0} > two.csv", shipped),
                        folder)
                .exit_code,
            0);
  for (const std::string& words :
       {std::string("off.csv normal_only.csv"), shipped + " --no-tare --delay 7ms --mains off",
        std::string("two.csv --unit mm")}) {
    const auto fit = program(fmt::format("fit {} --out finger.toml --report report", words));
    ASSERT_EQ(fit.exit_code, 0) << words << fit.err;
    SCOPED_TRACE(words);
    expect_told(fit, test::bytes_of(folder / "report/report.html"));
    fs::remove_all(folder / "report");
  }
}

/// Of the normal force alone none is drawn.
TEST_F(FitReportOfFiles, LeavesNoFigureOfAnEarlierFit) {
  fs::create_directory(folder / "report");
  for (const char* name : {"figure9.svg", "figure9.png", "figure3.svg", "mine.svg"})
    std::ofstream(folder / "report" / name) << "an earlier one";
  std::ofstream(folder / "report/report.html") << "<img src=\"figure9.svg\" alt=\"v_min\">\n";
  std::ofstream(folder / "pressed.csv") << "t_s,x_m,y_m,z_m,fz_n\n";
  std::ofstream pressed(folder / "pressed.csv", std::ios::app);
  for (int i = 0; i < 4000; ++i)
    pressed << fmt::format("{:.3f},0,0,{:.7f},{:.4f}\n", 1e-3 * i,
                           -1.5e-3 * std::sqrt(1 + 0.6 * std::sin(4e-3 * i)), 1 + 0.6 * std::sin(4e-3 * i));
  pressed.close();
  ASSERT_EQ(program("fit pressed.csv --out finger.toml --report report --delay 0ms --no-tare").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "report/figure9.svg"));
  EXPECT_FALSE(fs::exists(folder / "report/figure9.png"));
  EXPECT_TRUE(fs::exists(folder / "report/mine.svg")) << "no name of the program's";
  EXPECT_TRUE(fs::exists(folder / "report/figure3.svg")) << "no figure of the earlier page";
}

double residual_rms_n(const std::string& summary) {
  std::istringstream lines(summary);
  std::string names, numbers;
  std::getline(lines, names);
  std::getline(lines, numbers);
  const auto before = names.substr(0, names.find("residual_rms_n"));
  std::istringstream row(numbers);
  std::string cell;
  for (auto columns = std::count(before.begin(), before.end(), ','); columns >= 0; --columns)
    std::getline(row, cell, ',');
  return std::stod(cell);
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
  EXPECT_THAT(picture, AllOf(HasSubstr("measured"), HasSubstr("residual [N]")));
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
