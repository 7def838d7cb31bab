#include "view/comparison.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_writer.hpp"
#include "view/chart_layout.hpp"
#include "view/rub.hpp"
#include "view/touch_series.hpp"

namespace fingerpad::comparison_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A run of one column that goes linearly, so that interpolation is exact.
ComparedRun line_run(const std::string& path, double from_s, double to_s, double step_s, double offset) {
  ComparedRun run{"", "scene", "scene: a.stl", path, "", true, {}, {{"fn_n", "N", {}}}};
  for (int i = 0; from_s + i * step_s <= to_s + 1e-9; ++i) {
    run.x.push_back(from_s + i * step_s);
    run.columns[0].values.push_back(2 * run.x.back() + offset);
  }
  return run;
}

TEST(Comparison, OfOtherRatesIsAtTheTicksOfTheCoarser) {
  const Comparison comparison = compare_runs(
      {line_run("fine.h5", 0, 1, 0.001, 0), line_run("coarse.h5", 0.35, 2, 0.1, 0.25)}, {}, Over::time);
  ASSERT_EQ(comparison.residuals.size(), 1u);
  const Residual& left = comparison.residuals[0];
  ASSERT_EQ(left.values.size(), 7u) << "0.35 to 0.95 s";
  for (const double value : left.values)
    EXPECT_NEAR(value, 0.25, 1e-12) << "coarse less fine, and lines are exact";
  EXPECT_NEAR(left.rms, 0.25, 1e-12);
  EXPECT_THAT(comparison.notes,
              ElementsAre("residuals: less the first, fine",
                          "coarse: 0.35 to 1 s, at its own ticks, the first interpolated linearly"));
  EXPECT_THAT(residual_words(comparison), ElementsAre("fn_n: RMS 0.25 N, 'coarse' less 'fine', 7 ticks"));
}

TEST(Comparison, OfSeveralWallsSaysWhatTheirNormalForceIs) {
  const ComparedRun first = line_run("a.h5", 0, 1, 0.1, 0);
  ComparedRun other = first;
  other.path = "b.h5";
  other.several_walls = true;
  const auto walls = testing::Contains(HasSubstr("its normal force is all of theirs added up"));
  EXPECT_THAT(compare_runs({first, other}, {"fn_n"}, Over::time).notes, walls);
  EXPECT_THAT(compare_runs({first, first}, {"fn_n"}, Over::time).notes, Not(walls));
  other.columns[0].name = "fx_n";
  ComparedRun third = other;
  third.path = "c.h5";
  EXPECT_THAT(compare_runs({other, third}, {"fx_n"}, Over::time).notes, Not(walls)) << "of none of it";
}

TEST(Comparison, OfASceneInACornerKnowsItsWalls) {
  const auto folder = test::scratch_dir();
  auto rows = test::torus_rub().rows;
  const auto several = [&](const char* name) {
    const std::string path = (folder / name).string();
    TraceInfo info;
    info.several_walls = true;
    const auto writer = TraceWriter::create(path, TraceFormat::csv, info, World());
    writer->append(rows);
    writer->finish();
    return read_compared_run(path, Over::time, -1, 1e9).several_walls;
  };
  EXPECT_FALSE(several("one.csv"));
  rows[5].walls = 2;
  EXPECT_TRUE(several("two.csv"));
}

TEST(Comparison, OfOneTickAloneTellsWhatIsLeftThereAndNoMean) {
  ComparedRun first = line_run("a.h5", 0, 1, 0.1, 0), other = line_run("b.h5", 0, 1, 0.1, -0.25);
  const auto keep_one = [](ComparedRun& run) {
    for (std::size_t i = 0; i < run.x.size(); ++i) {
      if (i != 3) run.columns[0].values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  };
  keep_one(other);
  const Comparison one = compare_runs({first, other}, {}, Over::time);
  EXPECT_THAT(residual_words(one), ElementsAre("fn_n: -0.25 N at one tick alone, no RMS, 'b' less 'a'"));
  EXPECT_EQ(comparison_chart(one, Over::time).panels[1].curves[0].name,
            "b: -0.25 N at one tick alone, no RMS");
  other.columns[0].values[3] = std::numeric_limits<double>::quiet_NaN();
  const Comparison none = compare_runs({first, other}, {}, Over::time);
  EXPECT_THAT(residual_words(none), ElementsAre("fn_n: no tick at which both have a number, 'b' less 'a'"));
  EXPECT_TRUE(std::isnan(none.residuals[0].rms));
}

/// What several runs have in common is told once.
TEST(Comparison, TellsTheSpanThatRunsHaveInCommonOnce) {
  const auto notes = [](std::vector<ComparedRun> others) {
    std::vector<ComparedRun> runs = {line_run("a.h5", 0, 1, 0.01, 0)};
    for (ComparedRun& run : others) runs.push_back(std::move(run));
    std::vector<std::string> all = compare_runs(std::move(runs), {}, Over::time).notes;
    all.erase(all.begin());  // of which the residuals are
    return all;
  };
  EXPECT_THAT(notes({line_run("b.h5", 0, 1, 0.01, 1), line_run("c.h5", 0, 1, 0.01, 2)}),
              ElementsAre("all: 0 to 1 s"));
  EXPECT_THAT(notes({line_run("b.h5", 0.35, 2, 0.1, 1), line_run("c.h5", 0.35, 2, 0.1, 2)}),
              ElementsAre("all: 0.35 to 1 s, each at its own ticks, the first interpolated linearly"));
  EXPECT_THAT(notes({line_run("b.h5", 0, 1, 0.01, 1), line_run("c.h5", 0, 1, 0.003, 2)}),
              ElementsAre("b: 0 to 1 s", "c: 0 to 0.999 s, interpolated linearly at the ticks of the first"));
  EXPECT_THAT(notes({line_run("b.h5", 0, 1, 0.01, 1), line_run("c.h5", 0, 1, 0.01, 1),
                     line_run("d.h5", 0.5, 1, 0.01, 2)}),
              testing::Contains("b; c: 0 to 1 s"));
  EXPECT_THAT(notes({line_run("b.h5", 0, 1, 0.01, 1), line_run("c.h5", 0, 1, 0.0025, 2)}),
              ElementsAre("all: 0 to 1 s", "c: at the ticks of the first"));
}

TEST(Comparison, NamesRunsOfScenesWithLittleInCommonByTheirFiles) {
  std::vector<ComparedRun> runs = {line_run("a.h5", 0, 1, 0.1, 0), line_run("b.h5", 0, 1, 0.1, 0)};
  runs[0].scene_text = "[friction]\nlaw = \"dahl\"\n";
  runs[1].scene_text = "[friction]\nlaw = \"lugre\"\n";
  name_apart(runs);
  EXPECT_EQ(runs[1].name, "law lugre");
  runs[1].scene_text += "[contact]\nmethod = \"proxy\"\nnormals = \"curved\"\n[finger]\nradius_m = 0.007\n";
  name_apart(runs);
  EXPECT_EQ(runs[1].name, "law lugre") << "names that are there stay";
  for (ComparedRun& run : runs) run.name.clear();
  name_apart(runs);
  EXPECT_EQ(runs[1].name, "b");
}

TEST(Comparison, InterpolatesTheOtherWhereThatIsFiner) {
  const Comparison comparison = compare_runs(
      {line_run("coarse.h5", 0, 1, 0.1, 0), line_run("fine.h5", 0, 1, 0.03, -0.5)}, {}, Over::time);
  EXPECT_EQ(comparison.residuals[0].values.size(), 10u) << "0 to 0.9 s";
  EXPECT_NEAR(comparison.residuals[0].rms, 0.5, 1e-12);
  EXPECT_THAT(comparison.notes[1], HasSubstr("interpolated linearly at the ticks of the first"));
}

TEST(Comparison, LeavesOutTicksWithoutANumber) {
  ComparedRun a = line_run("a.h5", 0, 1, 0.1, 0), b = line_run("b.h5", 0, 1, 0.1, 1);
  b.columns[0].values[3] = std::nan("");
  const Comparison comparison = compare_runs({a, b}, {}, Over::time);
  EXPECT_NEAR(comparison.residuals[0].rms, 1, 1e-12);
  EXPECT_THAT(residual_words(comparison)[0], HasSubstr("10 ticks"));
}

TEST(Comparison, TellsWhatCannotBeCompared) {
  const auto words = [](std::vector<ComparedRun> runs, const std::vector<std::string>& columns) {
    return test::why_not([&] { compare_runs(runs, columns, Over::time); });
  };
  ComparedRun other = line_run("b.csv", 0, 1, 0.1, 0);
  other.columns[0].name = "fx_n";
  EXPECT_THAT(words({line_run("a.h5", 0, 1, 0.1, 0), other}, {}),
              HasSubstr("b.csv: has no column in common with a.h5: fn_n there, fx_n here"));
  EXPECT_THAT(words({line_run("a.h5", 0, 1, 0.1, 0), line_run("b.h5", 2, 3, 0.1, 0)}, {}),
              HasSubstr("b.h5: has no time in common with a.h5: 2 to 3 here, 0 to 1 there"));
  EXPECT_THAT(words({line_run("a.h5", 0, 1, 0.1, 0), line_run("b.h5", 0, 1, 0.1, 0)}, {"tea"}),
              HasSubstr("a.h5: has no column 'tea'; it has fn_n"));
}

TEST(Comparison, DrawsFrictionFromZero) {
  ComparedRun run = line_run("a.h5", 0, 1, 0.1, 5);
  run.columns.push_back({"friction", "N", std::vector<double>(run.x.size(), -0.5)});
  const Chart chart = comparison_chart(compare_runs({run}, {"fn_n", "friction"}, Over::time), Over::time);
  ASSERT_EQ(chart.panels.size(), 2u);
  EXPECT_FALSE(chart.panels[0].y_from_zero);
  EXPECT_TRUE(chart.panels[1].y_from_zero) << "its sign says which way it acts";
}

TEST(Comparison, OfOneThinnedRunNamesItNot) {
  ComparedRun run = line_run("a.h5", 0, 1, 0.1, 5);
  run.name.clear();
  run.scene_text = "[[plane]]";
  run.lacks_ticks = true;
  run.every = 10;
  EXPECT_THAT(compare_runs({run}, {"fn_n"}, Over::time).notes, testing::Contains("1 tick in 10 is here"));
}

/// Writes one row in so many, and the last.
void write_some(const std::string& path, const ViewInput& input, std::uint64_t every) {
  const auto writer = TraceWriter::create(path, TraceFormat::csv, {}, *input.world);
  const auto last = static_cast<long>(input.rows.size()) - 1;
  for (long k = 0; k <= last; ++k) {
    if (is_kept(k, last, every)) writer->append({&input.rows[static_cast<std::size_t>(k)], 1});
  }
  writer->finish();
}

// Friction along the sliding direction goes by the way from one row to the next, which is another where rows
// are left out.
TEST(Comparison, OfARunWithItselfThinnedLeavesNothing) {
  const auto folder = test::scratch_dir();
  const ViewInput input = test::torus_rub(1.004);
  const std::string whole = (folder / "whole.csv").string(), thin = (folder / "thin.csv").string();
  write_some(whole, input, 1);
  write_some(thin, input, 10);
  constexpr double all = std::numeric_limits<double>::infinity();
  const std::string by_fewer =
      "way: from each tick to the next of the run that has fewest; what lies between is longer";
  for (const Over over : {Over::time, Over::travel, Over::turn})
    for (const auto& paths : {std::vector{whole, thin}, std::vector{thin, whole}}) {
      const Comparison comparison =
          compare_runs(read_compared_runs(paths, over, 0.2, all), {"fn_n", "friction", "x_m"}, over);
      ASSERT_EQ(comparison.residuals.size(), 3u);
      for (const Residual& left : comparison.residuals) {
        EXPECT_EQ(left.rms, 0) << left.column;
        EXPECT_EQ(std::count_if(left.values.begin(), left.values.end(), [](double x) { return x == 0; }), 92)
            << "0.2 to 1.1 s, and the last";
      }
      EXPECT_THAT(comparison.notes.back(), Not(HasSubstr("interpolated")));
      EXPECT_EQ(std::count(comparison.notes.begin(), comparison.notes.end(), by_fewer),
                over == Over::time ? 0 : 1);
    }
}

/// One run, with a row in so many ticks each.
std::vector<std::string> thinned_traces(const std::vector<std::uint64_t>& rows_in) {
  const auto folder = test::scratch_dir();
  const ViewInput input = test::torus_rub(1.004);
  std::vector<std::string> paths;
  for (const std::uint64_t every : rows_in) {
    paths.push_back((folder / fmt::format("every{}.csv", every)).string());
    write_some(paths.back(), input, every);
  }
  return paths;
}

TEST(Comparison, OfTwoTracesIsTheSameBesideAThird) {
  const std::vector<std::string> paths = thinned_traces({1, 2, 20});
  constexpr double all = std::numeric_limits<double>::infinity();
  for (const Over over : {Over::time, Over::travel}) {
    const Comparison comparison = compare_runs(read_compared_runs(paths, over, 0, all), {"friction"}, over);
    ASSERT_EQ(comparison.residuals.size(), 2u);
    for (const Residual& left : comparison.residuals) {
      EXPECT_LT(left.rms, 1e-8) << left.run << ": but for the way's rounding, which is told by the third";
      EXPECT_GT(left.ticks, 40u);
    }
  }
}

// Of every seventh tick few are among every twentieth's, by which the whole run's way is told.
TEST(Comparison, OverTheWayTellsWhoseWayIsItsOwn) {
  const std::vector<std::string> paths = thinned_traces({1, 7, 20});
  constexpr double all = std::numeric_limits<double>::infinity();
  const auto notes = [&](Over over) {
    return compare_runs(read_compared_runs(paths, over, 0, all), {"x_m"}, over).notes;
  };
  const auto own_way = testing::Contains(HasSubstr("every7 has not all of its ticks: its way is its own"));
  EXPECT_THAT(notes(Over::travel), own_way);
  EXPECT_THAT(notes(Over::travel), Not(testing::Contains(HasSubstr("every20 has not"))));
  EXPECT_THAT(notes(Over::time), Not(own_way));
}

// At another rate the finger passes other places of its way, so that none stands at a tick of both.
TEST(Comparison, OverTheWayOfAnotherRateIsAtAllOfItsTicks) {
  const auto folder = test::scratch_dir();
  ViewInput input = test::torus_rub(1.004);
  const std::string whole = (folder / "whole.csv").string(), thin = (folder / "thin.csv").string();
  write_some(whole, input, 1);
  for (TickRecord& row : input.rows) row.contact_W *= 1.001;
  write_some(thin, input, 10);
  constexpr double all = std::numeric_limits<double>::infinity();
  const Comparison comparison = compare_runs(read_compared_runs({whole, thin}, Over::travel, 0.2, all),
                                             {"friction", "x_m"}, Over::travel);
  ASSERT_EQ(comparison.residuals.size(), 2u);
  EXPECT_EQ(comparison.residuals[0].ticks, comparison.residuals[1].ticks)
      << "friction is known wherever x is";
  EXPECT_GE(comparison.residuals[0].ticks, 90u);
  EXPECT_LT(comparison.residuals[0].rms, 0.01);
}

// A finger that rests while it is pressed is at one place of its way for many ticks.
TEST(Comparison, OverTheWayGoesByTheNearestTimeWhereTheFingerRests) {
  ComparedRun a = line_run("a.h5", 0.1, 1, 0.1, 0), b = line_run("b.h5", 0, 1, 0.05, 0);
  for (ComparedRun* run : {&a, &b}) {
    run->t_s = run->x;
    for (double& x : run->x) x = std::max(0.0, x - 0.5);  // it rests for half a second
  }
  const Comparison comparison = compare_runs({a, b}, {}, Over::travel);
  EXPECT_EQ(comparison.residuals[0].values.size(), 10u);
  EXPECT_NEAR(comparison.residuals[0].rms, 0, 1e-12);
}

// In the air between two strokes, or after the last, the way stands, and the sums of two runs differ in their
// last digits.
TEST(Comparison, OverTheWayTakesPlacesThatRoundingPartsForOne) {
  for (const double begins : {0.25, 0.75}) {
    ComparedRun a = line_run("a.h5", 0, 1, 0.1, 0);
    a.t_s = a.x;
    for (double& x : a.x) x = x > begins ? std::max(begins, x - 0.5) : x;
    for (const double off : {1e-15, -1e-15}) {
      ComparedRun b = a;
      b.path = "b.h5";
      for (double& x : b.x) x += x == begins ? off : 0;
      const Comparison comparison = compare_runs({a, b}, {}, Over::travel);
      EXPECT_EQ(comparison.residuals[0].ticks, 11u) << off;
      EXPECT_NEAR(comparison.residuals[0].rms, 0, 1e-12) << off;
      EXPECT_THAT(comparison.notes, ElementsAre("residuals: less the first, a", testing::EndsWith(" mm")));
    }
  }
}

TEST(Comparison, OfAsManyTicksElsewhereSaysAtWhich) {
  const Comparison comparison =
      compare_runs({line_run("a.h5", 0, 1, 0.1, 0), line_run("b.h5", 0, 0.5, 0.05, 0)}, {}, Over::time);
  EXPECT_THAT(comparison.notes, testing::Contains(HasSubstr("at the ticks of the first")));
}

TEST(Comparison, HasAResidualUnderEachPanelAndOneLegendForWhatDiffers) {
  ComparedRun a = line_run("a.h5", 0, 1, 0.1, 0), b = line_run("b.h5", 0, 1, 0.1, 1);
  a.scene_text = "[[part]]\nmu_static = 0.3\n";
  b.scene_text = "[[part]]\nmu_static = 0.4\n";
  const Chart chart = comparison_chart(compare_runs({a, b}, {}, Over::time), Over::time);
  EXPECT_EQ(chart.title, "scene: a.stl");
  ASSERT_EQ(chart.panels.size(), 2u);
  EXPECT_EQ(chart.panels[0].curves[0].name, "mu_static 0.3");
  EXPECT_EQ(chart.panels[0].curves[1].name, "mu_static 0.4");
  EXPECT_NE(chart.panels[0].curves[0].style.dash, chart.panels[0].curves[1].style.dash)
      << "not by colour alone";
  EXPECT_EQ(chart.panels[1].curves[0].name, "mu_static 0.4: RMS 1 N");
}

TEST(Comparison, OfManyRunsNamesEachOnceAndTellsItsResidualsShortly) {
  const auto legends_of = [](int count) {
    std::vector<ComparedRun> runs;
    for (int i = 0; i < count; ++i) {
      runs.push_back(line_run(std::string(1, static_cast<char>('a' + i)) + ".h5", 0, 1, 0.1, i));
      runs.back().columns.push_back({"mu", "1", runs.back().x});
    }
    std::vector<std::vector<std::string>> legends;
    for (const ChartPanel& panel :
         comparison_chart(compare_runs(std::move(runs), {"fn_n", "mu"}, Over::time), Over::time).panels) {
      legends.emplace_back();
      for (const ChartCurve& curve : panel.curves) legends.back().push_back(curve.name);
    }
    return legends;
  };
  const auto four = legends_of(4);
  ASSERT_EQ(four.size(), 4u);
  EXPECT_THAT(four[0], ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(four[1], ElementsAre("RMS 1 N", "RMS 2 N", "RMS 3 N"));
  EXPECT_THAT(four[2], ElementsAre("", "", "", ""));
  EXPECT_THAT(four[3], ElementsAre("RMS 0", "RMS 0", "RMS 0"));
  EXPECT_THAT(legends_of(3)[3], ElementsAre("b: RMS 0", "c: RMS 0")) << "few are named everywhere";
}

TEST(Comparison, IsTitledByItsScenesWhereTheyDiffer) {
  const auto title = [](const std::vector<std::string>& scenes) {
    std::vector<ComparedRun> runs;
    for (const std::string& scene : scenes) {
      runs.push_back(line_run(std::to_string(runs.size()) + ".h5", 0, 1, 0.1, 0));
      runs.back().scene = scene;
      runs.back().title = scene + ": part.stl";
    }
    return comparison_chart(compare_runs(runs, {}, Over::time), Over::time).title;
  };
  EXPECT_EQ(title({"knob", "plate"}), "knob and plate");
  EXPECT_EQ(title({"knob", "plate", "rim", "bore"}), "knob, plate, rim and bore");
  EXPECT_EQ(title({"knob", "plate", "rim", "bore", "slot"}), "knob, plate, rim and 2 more");
  EXPECT_EQ(title({"knob", "knob", "plate", "knob", "rim"}), "knob, plate and rim");
  EXPECT_EQ(title({"knob", "knob"}), "knob: part.stl");
}

// Alike to the last bit, a curve lay on the panel's frame.
TEST(Comparison, DrawsZeroInTheMiddleWhereNothingIsLeft) {
  const ComparedRun run = line_run("a.h5", 0, 1, 0.1, 0);
  const Chart chart = comparison_chart(compare_runs({run, run}, {}, Over::time), Over::time);
  const ChartLayout layout = stacked_layout(chart, {0, 0, 800, 600}, 12);
  EXPECT_NEAR(layout.panels[1].y.share(0), 0.5, 1e-12);
}

TEST(ComparedRun, OfATableHasItsMeasuredColumns) {
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "rub.csv") << "t_s;x_m;fx_n;note\n0;0;0,5;1\n0,1;1;0,75;2\n";
  std::ofstream(folder / "point.csv") << "t_s;x_m;fx_n;note\n0;0;0.5;1\n0.1;1;0.75;2\n0.2;1;0.75;2\n";
  constexpr double all = std::numeric_limits<double>::infinity();
  const ComparedRun run = read_compared_run((folder / "point.csv").string(), Over::time, -all, 0.15);
  EXPECT_TRUE(is_measured_table((folder / "point.csv").string()));
  ASSERT_EQ(run.columns.size(), 2u);
  EXPECT_EQ(run.columns[1].name, "fx_n");
  EXPECT_THAT(run.columns[1].values, ElementsAre(0.5, 0.75)) << "up to 0.15 s";
  std::ofstream(folder / "tea.csv") << "tea,milk\n1,2\n";
  const auto read = [&](const char* name, Over over) {
    return test::why_not([&] { read_compared_run((folder / name).string(), over, -all, all); });
  };
  EXPECT_THAT(read("tea.csv", Over::time), HasSubstr("plot takes traces, and tables with t_s"));
  EXPECT_THAT(read("point.csv", Over::travel), HasSubstr("only whole traces are drawn over travel or turn"));
  std::ofstream(folder / "back.csv") << "t_s,fx_n\n1,2\n0.5,2\n";
  EXPECT_THAT(read("back.csv", Over::time), HasSubstr("back.csv:3: its time goes back"));
}

TEST(ComparedRun, OfATableWithGapsKeepsThem) {
  const auto folder = test::scratch_dir();
  constexpr double all = std::numeric_limits<double>::infinity();
  const auto written = [&](const char* name, const char* text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  };
  const ComparedRun run = read_compared_run(
      written("gaps.csv", "t_s,px_m,fn_n\n0,nan,0\n0.1,,1\n0.2,0.5,2\n"), Over::time, -all, all);
  ASSERT_EQ(run.columns.size(), 2u);
  EXPECT_TRUE(std::isnan(run.columns[0].values[0]) && std::isnan(run.columns[0].values[1]));
  EXPECT_EQ(run.columns[0].values[2], 0.5);
  EXPECT_THAT(run.columns[1].values, ElementsAre(0, 1, 2));
  const std::string lost = written("lost.csv", "t_s,fn_n\n0,0\nnan,1\n");
  EXPECT_THAT(test::why_not([&] { read_compared_run(lost, Over::time, -all, all); }),
              HasSubstr("lost.csv:3: has no time t_s"));
}

TEST(ComparedRun, OfSeveralTrialsSaysHowManyThereAre) {
  const auto folder = test::scratch_dir();
  constexpr double all = std::numeric_limits<double>::infinity();
  const auto why = [&](const char* text) {
    std::ofstream(folder / "lab.csv") << text;
    return test::why_not([&] { read_compared_run((folder / "lab.csv").string(), Over::time, -all, all); });
  };
  EXPECT_THAT(why("t_s,fx_n,trial\n0,1,1\n1,1,1\n0,1,2\n0,1,3\n"),
              HasSubstr("lab.csv:4: its time begins anew: the table holds 3 trials (column trial)"));
  EXPECT_THAT(why("t_s,fx_n,subject,trial\n0,1,1,1\n1,1,1,1\n0,1,2,1\n"), HasSubstr("holds 2 trials"));
  EXPECT_THAT(why("t_s,fx_n,trial\n0,1,1\n1,1,1\n0,1,1\n"), HasSubstr("its time goes back; sort"));
}

/// A rub to and fro over a plane along a direction in it, held back by 0.2 N.
ComparedRun plane_rub(const std::filesystem::path& path, const Vec3& along) {
  const auto writer = TraceWriter::create(path.string(), TraceFormat::csv, {}, World());
  for (int i = 0; i < 200; ++i) {
    TickRecord row;
    row.t_s = 0.01 * i;
    row.phase = Phase::slip;
    row.contact_W = 0.01 * std::sin(5 * row.t_s) * along;
    row.p_WQ = row.contact_W - Vec3(0, 0, 1e-3);
    row.normal_W = Vec3::UnitZ();
    row.normal_force_n = 1;
    const double pace = std::cos(5 * row.t_s);
    row.friction_W_n = (pace > 0 ? -0.2 : 0.2) * along;
    writer->append({&row, 1});
  }
  writer->finish();
  return read_compared_run(path.string(), Over::time, -1, 1e9);
}

// Along the world's axis friction changes its sign where a rub turns, along the sliding it does not: the
// difference of the two would be nothing that acts.
TEST(Comparison, TellsTheFrictionOfAllRunsAlike) {
  const auto folder = test::scratch_dir();
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  const auto compared = [&](const Vec3& first, const Vec3& other) {
    return compare_runs({plane_rub(folder / "a.csv", first), plane_rub(folder / "b.csv", other)},
                        {"friction"}, Over::time);
  };
  const auto sentence = [](const std::string& words) { return testing::Contains(words); };

  const Comparison alike = compared(x, x);
  EXPECT_EQ(alike.friction.along, "x");
  EXPECT_THAT(alike.notes, sentence("friction: along x, positive where it pushes the finger towards +x"));
  EXPECT_NEAR(alike.runs[0].columns.back().values[10], -0.2, 1e-12);
  EXPECT_NEAR(alike.runs[0].columns.back().values[50], 0.2, 1e-12) << "on the way back";
  EXPECT_EQ(alike.residuals[0].rms, 0);
  const Chart chart = comparison_chart(alike, Over::time);
  EXPECT_EQ(chart.panels[0].y_label, "friction along x (+ pushes towards +x) [N]");
  EXPECT_EQ(chart.panels[0].short_y_label, "friction x [N]");
  EXPECT_EQ(chart.panels[1].y_label, "residual [N]");

  const Comparison across = compared(x, y);
  EXPECT_EQ(across.friction.along, "sliding");
  EXPECT_THAT(
      across.notes,
      sentence("friction: along the sliding direction of each, negative where it holds the finger back"));
  for (const std::size_t run : {0u, 1u})
    for (const std::size_t tick : {10u, 50u})
      EXPECT_NEAR(across.runs[run].columns.back().values[tick], -0.2, 1e-9) << run << " at " << tick;
  EXPECT_EQ(comparison_chart(across, Over::time).panels[0].y_label,
            "friction along sliding (- against it) [N]");

  const Vec3 turned = Vec3(3, 4, 0) / 5;
  EXPECT_THAT(
      compared(turned, turned).notes,
      sentence("friction: along u, positive where it pushes the finger towards +u; u is (0.60, 0.80, 0.00)"));
}

TEST(Abscissa, OfARoundRubIsItsArcAndItsTurn) {
  const ViewInput input = test::torus_rub(0.25);
  const std::vector<double> travel_mm = abscissa(input.rows, Over::travel);
  const std::vector<double> turn_deg = abscissa(input.rows, Over::turn);
  // A quarter of a second later the finger has swung through 0.5 rad, from the middle to the end of its
  // swing, less what it had done in the air: round the torus' axis at the finger's own radius.
  const auto& rows = input.rows;
  const auto around = [](const TickRecord& row) { return std::atan2(row.p_WQ.y(), row.p_WQ.x()); };
  double swung_rad = 0;
  for (std::size_t i = 101; i < rows.size(); ++i)
    swung_rad += std::abs(around(rows[i]) - around(rows[i - 1]));
  const double radius_m = std::hypot(rows.back().p_WQ.x(), rows.back().p_WQ.y());
  EXPECT_NEAR(travel_mm.back(), 1e3 * radius_m * swung_rad, 0.01 * travel_mm.back());
  // The normal leans 1.2 rad out of the plane of the swing.
  EXPECT_NEAR(turn_deg.back(), swung_rad * std::cos(1.2) * 180 / 3.14159265, 0.01 * turn_deg.back());
  EXPECT_EQ(travel_mm[100], 0) << "in the air";
}

TEST(Friction, OnARoundPartIsAlongTheSlidingAndSaysSo) {
  const ViewInput input = test::torus_rub(1.0);
  const TouchSeries series = touch_series(input.rows, main_direction(input.rows));
  EXPECT_EQ(series.friction_name, "friction along the sliding direction");
  EXPECT_EQ(series.friction_sign, "- against it");
  for (std::size_t i = 101; i < input.rows.size(); ++i) {
    const TickRecord& row = input.rows[i];
    if (row.phase != Phase::slip) continue;
    EXPECT_NEAR(series.friction_n[i], -row.friction_W_n.norm(), 1e-3) << "to and fro alike; i = " << i;
  }
}

TEST(Friction, OnAFlatPartRubbedStraightIsTheWorldsComponent) {
  std::vector<TickRecord> rows(200);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].t_s = 0.01 * static_cast<double>(i);
    rows[i].phase = Phase::slip;
    rows[i].contact_W = Vec3(0.01 * std::sin(5 * rows[i].t_s), 0, 0);
    rows[i].p_WQ = rows[i].contact_W - Vec3(0, 0, 1e-3);
    rows[i].normal_W = Vec3::UnitZ();
    rows[i].friction_W_n = Vec3(-0.2 * std::cos(5 * rows[i].t_s), 0.1, 0);
  }
  const TouchSeries series = touch_series(rows, main_direction(rows));
  EXPECT_EQ(series.friction_name, "friction along x");
  EXPECT_EQ(series.friction_sign, "+ pushes towards +x");
  EXPECT_EQ(series.friction_n[7], rows[7].friction_W_n.x());
}

TEST(Friction, OfAFingerThatRestsIsTheWorldsComponent) {
  std::vector<TickRecord> rows(301);
  for (TickRecord& row : rows) {
    row.phase = Phase::stick;
    row.contact_W = Vec3(0.0031, 0.0017, 0.005);  // whose mean is rounded
    row.p_WQ = row.contact_W - Vec3(0, 0, 1e-3);
    row.normal_W = Vec3::UnitZ();
  }
  EXPECT_EQ(touch_series(rows, main_direction(rows)).friction_name, "friction along x");
}

TEST(LogAxis, KeepsMoreDecadesOfAPower) {
  ChartPanel panel{"", "f [Hz]", "power density [N\xC2\xB2/Hz]", false, true, {{"", {}, {1, 2}, {1, 1e-12}}}};
  EXPECT_LT(page_layout({"", "", {}, 1, {panel}}).panels[0].y.min, 1e-12) << "no curve falls below the axis";
  panel.y_label = "error [1]";
  EXPECT_GT(page_layout({"", "", {}, 1, {panel}}).panels[0].y.min, 1e-9) << "that is rounding";
}

TEST(LeastSpan, KeepsRoundingFlat) {
  EXPECT_EQ(least_span("force on the finger [N]"), 1e-3);
  EXPECT_EQ(least_span("time [s]"), 0);
  ChartPanel panel{
      "", "displacement [mm]", "friction [N]", false, false, {{"", {}, {-1e-15, 1e-15}, {0.7, 0.7 + 1e-16}}}};
  const ChartLayout layout = page_layout({"", "", {}, 1, {panel}});
  const Axis &x = layout.panels[0].x, &y = layout.panels[0].y;
  EXPECT_GE(x.max - x.min, 1e-3) << "a micrometre";
  EXPECT_LE(x.max - x.min, 1.1e-3);
  EXPECT_GE(y.max - y.min, 0.07) << "a tenth of what is nearly constant";
  panel.curves[0].x = {0, 0.5};
  panel.curves[0].y = {0, 2e-17};
  panel.y_from_zero = true;
  const Axis from_zero = page_layout({"", "", {}, 1, {panel}}).panels[0].y;
  EXPECT_EQ(from_zero.min, 0);
  EXPECT_GE(from_zero.max, 1e-3);
}

}  // namespace
}  // namespace fingerpad::comparison_test
