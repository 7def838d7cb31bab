#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

// `replay --columns LIST --every N`: smaller traces, and what reads them.

namespace fingerpad::trace_choice_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// 101 ticks over a plane.
fs::path folder_with_scene() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, "
         "-0.001]\nto_m = [0.02, 0, -0.001]\nspeed_m_per_s = 0.2\nrate_hz = 1000\n";
  return folder;
}

ShellResult replay(const fs::path& folder, const std::string& options) {
  return test::fingerpad("replay s.toml --quiet " + options, folder);
}

TEST(ChosenColumns, AreTheWholeTracesNumbers) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out whole").exit_code, 0);
  ASSERT_EQ(replay(folder, "--out some --columns mu,fn_n").exit_code, 0);
  ASSERT_EQ(replay(folder, "--out text --columns mu,fn_n --format csv").exit_code, 0);
  const Trace whole = read_trace((folder / "whole" / "s.h5").string());
  const Trace some = read_trace((folder / "some" / "s.h5").string(), TraceContents::some_rows);
  const std::vector<std::string> expected{"t_s", "fn_n", "mu"};
  EXPECT_EQ(some.info.columns, expected);
  ASSERT_EQ(some.rows.size(), whole.rows.size());
  for (std::size_t i = 0; i < whole.rows.size(); ++i) {
    EXPECT_EQ(some.rows[i].t_s, whole.rows[i].t_s);
    EXPECT_EQ(some.rows[i].mu, whole.rows[i].mu);
    EXPECT_EQ(some.rows[i].normal_force_n, whole.rows[i].normal_force_n);
  }
  EXPECT_EQ(bytes_of(folder / "whole" / "summary.csv"), bytes_of(folder / "some" / "summary.csv"));
  EXPECT_LT(fs::file_size(folder / "some" / "s.h5"), fs::file_size(folder / "whole" / "s.h5") / 3);
  ASSERT_EQ(test::fingerpad("export some/s.h5 --out e.csv --quiet", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "e.csv"), bytes_of(folder / "text" / "s.csv"));
  EXPECT_TRUE(bytes_of(folder / "e.csv").starts_with("t_s,fn_n,mu\n"));
}

TEST(ChosenColumns, WhatIsNotThereIsNamedByWhoeverNeedsIt) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out o --columns fn_n,mu").exit_code, 0);
  ASSERT_EQ(replay(folder, "--out whole").exit_code, 0);
  const std::string words =
      "o/s.h5: has no column x_m, y_m, z_m and 20 more: it was written with t_s, fn_n, mu";
  EXPECT_THAT(test::fingerpad("export o/s.h5 --out e.vtp", folder).err, HasSubstr(words));
  EXPECT_THAT(
      test::fingerpad("fit o/s.h5 --out f.toml", folder).err,
      HasSubstr("o/s.h5: has no column x_m, y_m, z_m: it was written with t_s, fn_n, mu alone (replay "
                "--columns), and a whole trace is needed here; replay its scene without --columns"));
#ifdef FINGERPAD_VIEW
  for (const char* command : {"plot o/s.h5 --out p.svg --over s", "plot o/s.h5 --show spectrum --out p.svg",
                              "view o/s.h5 --png v.png"}) {
    const auto result = test::fingerpad(command, folder);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr(words)) << command;
  }
#endif
  const auto compared = test::fingerpad("compare o whole", folder);
  EXPECT_EQ(compared.exit_code, 4);
  EXPECT_THAT(compared.out, HasSubstr("columns are in the second trace alone, and not compared: x_m y_m"));
  EXPECT_THAT(compared.out, Not(HasSubstr(" mu"))) << "both have it";
  const auto unknown = replay(folder, "--out u --columns fn");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--columns: 'fn' is no column of a trace"));
  EXPECT_EQ(replay(folder, "--out u --columns mu --format none").exit_code, 2);
  for (const char* list : {"'fn_n;mu'", "'fn_n mu'", "'fn_n; mu'"}) {
    const auto parted = replay(folder, std::string("--out u --columns ") + list);
    EXPECT_EQ(parted.exit_code, 2);
    EXPECT_THAT(parted.err, HasSubstr(" is no column of a trace; commas part them: fn_n,mu\n")) << list;
  }
  const auto apart = replay(folder, "--out u --columns fn_n mu");
  EXPECT_EQ(apart.exit_code, 2);
  EXPECT_EQ(
      apart.err,
      "fingerpad: error: --columns: 'mu' stands apart from fn_n, and so for a file; commas part columns, "
      "without blanks: fn_n,mu\n");
  EXPECT_THAT(replay(folder, "--out u --columns fn_n, mu").err, HasSubstr("without blanks: fn_n,mu\n"));
}

#ifdef FINGERPAD_VIEW
TEST(ChosenColumns, OfACsvAreNotCalledMeasurementsNorOneFileSeveral) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out o --columns fn_n,mu --every 10 --format csv").exit_code, 0);
  const auto shown = test::fingerpad("plot o/s.csv --show spectrum --out p.svg", folder);
  EXPECT_EQ(shown.exit_code, 3);
  EXPECT_THAT(shown.err, HasSubstr("o/s.csv: holds some of a trace's columns alone, measured or written by "
                                   "replay --columns, and --show spectrum needs a whole trace"));
  const auto over = test::fingerpad("plot o/s.csv --over s --out p.svg", folder);
  EXPECT_EQ(over.exit_code, 3);
  EXPECT_THAT(over.err, HasSubstr("o/s.csv: does not tell what the finger touched"));
  EXPECT_THAT(over.err, HasSubstr("none that replay --columns wrote"));
}

TEST(EveryNthTick, IsToldByAPlotOfSomeColumns) {
  const fs::path folder = folder_with_scene();
  for (const std::string format : {"h5", "csv"}) {
    ASSERT_EQ(replay(folder, "--out o --columns fn_n,mu --every 10 --format " + format).exit_code, 0);
    const auto result = test::fingerpad("plot o/s." + format + " --out p.svg", folder);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("1 tick in 10 is here")) << format;
    EXPECT_FALSE(result.out.starts_with(": ")) << format << ": a name that is none";
    EXPECT_THAT(bytes_of(folder / "p.svg"), AllOf(HasSubstr("1 tick in 10 is here"), Not(HasSubstr(">: "))))
        << format;
  }
}

TEST(ChosenColumns, AreAllPlotted) {
  const fs::path folder = folder_with_scene();
  for (const std::string format : {"h5", "csv"}) {
    ASSERT_EQ(replay(folder, "--out o --columns fn_n,mu,fx_n --format " + format).exit_code, 0);
    const auto result = test::fingerpad("plot o/s." + format + " --out p.svg", folder);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char* label : {">fn_n [N]<", ">fx_n [N]<", ">mu [1]<"})
      EXPECT_THAT(bytes_of(folder / "p.svg"), HasSubstr(label)) << format;
  }
}
#endif

TEST(EveryNthTick, IsWrittenWithTheLast) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out whole").exit_code, 0);
  for (const std::string format : {"h5", "csv"}) {
    ASSERT_EQ(replay(folder, "--out " + format + " --every 30 --format " + format).exit_code, 0);
    const Trace whole = read_trace((folder / "whole" / "s.h5").string());
    const Trace thin = read_trace((folder / format / ("s." + format)).string());
    ASSERT_EQ(thin.rows.size(), 5u);
    const int ticks[] = {0, 30, 60, 90, 100};
    for (std::size_t i = 0; i < 5; ++i) {
      const TickRecord& same = whole.rows[static_cast<std::size_t>(ticks[i])];
      EXPECT_EQ(thin.rows[i].t_s, same.t_s);
      EXPECT_EQ(thin.rows[i].force_W_n, same.force_W_n);
    }
    EXPECT_EQ(bytes_of(folder / "whole" / "summary.csv"), bytes_of(folder / format / "summary.csv"))
        << "figures are of every tick";
  }
}

TEST(EveryNthTick, IsToldByACsvTraceItself) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out o --every 10 --format csv").exit_code, 0);
  const std::string csv = (folder / "o" / "s.csv").string(), text = bytes_of(csv);
  EXPECT_THAT(text.substr(0, text.find('\n')), testing::EndsWith(",part,triangle,every"));
  const Trace thin = read_trace(csv);
  ASSERT_EQ(thin.rows.size(), 11u) << "the last of 101 ticks is a tenth one, so that no time tells";
  EXPECT_EQ(thin.info.every, 10u);
  ASSERT_EQ(replay(folder, "--out h --every 10").exit_code, 0);
  ASSERT_EQ(test::fingerpad("export h/s.h5 --out e.csv --quiet", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "e.csv"), text);
  ASSERT_EQ(replay(folder, "--out whole --format csv").exit_code, 0);
  EXPECT_THAT(bytes_of(folder / "whole" / "s.csv"), Not(HasSubstr("every")));

  const auto refusal_of = [&](std::size_t at, const std::string& cell) {
    std::string spoilt = text;
    spoilt.replace(at - 2, 2, cell);
    std::ofstream(folder / "spoilt.csv") << spoilt;
    return test::fingerpad("export spoilt.csv --out x.csv", folder).err;
  };
  EXPECT_THAT(refusal_of(text.size() - 1, "11"),
              HasSubstr("spoilt.csv:12: column 'every' says 11, and 10 in the row before"));
  EXPECT_THAT(refusal_of(text.size() - 1, "0"), HasSubstr("'0' in column 'every' is no whole number from 1"));
  EXPECT_THAT(refusal_of(text.size() - 1, "1.5"), HasSubstr("'1.5' in column 'every'"));
}

TEST(EveryNthTick, IsToldByACsvOfSomeColumnsToo) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(replay(folder, "--out o --columns fn_n,mu --every 10 --format csv").exit_code, 0);
  const std::string csv = (folder / "o" / "s.csv").string(), text = bytes_of(csv);
  EXPECT_TRUE(text.starts_with("t_s,fn_n,mu,every\n0,"));
  EXPECT_EQ(every_of_csv(csv), 10u);
  const Trace thin = read_trace(csv, TraceContents::some_rows);
  EXPECT_EQ(thin.info.every, 10u);
  const std::vector<std::string> columns{"t_s", "fn_n", "mu"};
  EXPECT_EQ(thin.info.columns, columns);
  ASSERT_EQ(replay(folder, "--out h --columns fn_n,mu --every 10").exit_code, 0);
  for (const char* trace : {"o/s.csv", "h/s.h5"}) {
    ASSERT_EQ(test::fingerpad(std::string("export ") + trace + " --out e.csv --quiet", folder).exit_code, 0);
    EXPECT_EQ(bytes_of(folder / "e.csv"), text) << trace;
  }
  ASSERT_EQ(replay(folder, "--out all --columns fn_n,mu --format csv").exit_code, 0);
  EXPECT_TRUE(bytes_of(folder / "all" / "s.csv").starts_with("t_s,fn_n,mu\n"));
  EXPECT_EQ(every_of_csv((folder / "all" / "s.csv").string()), 1u);
}

TEST(EveryNthTick, IsNoMotionNorMeasurementWithoutAWarning) {
  const fs::path folder = folder_with_scene();
  const std::string columns = " --columns x_m,y_m,z_m,fx_n,fy_n,fz_n --format csv";
  ASSERT_EQ(replay(folder, "--out h5 --every 5").exit_code, 0);
  ASSERT_EQ(replay(folder, "--out csv --every 5 --format csv").exit_code, 0);
  ASSERT_EQ(replay(folder, "--out some --every 5" + columns).exit_code, 0);
  ASSERT_EQ(replay(folder, "--out all" + columns).exit_code, 0);
  const std::string words = ": is a trace with 1 row in 5 ticks (replay --every): ";
  for (const std::string trace : {"h5/s.h5", "csv/s.csv", "some/s.csv", "all/s.csv"}) {
    std::ofstream(folder / "again.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\n"
                                            "rate_hz = 1000\nfile = \""
                                         << trace << "\"\n";
    const bool is_thin = trace != "all/s.csv";
    const auto replayed = test::fingerpad("replay again.toml --out r --quiet", folder);
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_EQ(replayed.err.find("warning: " + trace + words) != std::string::npos, is_thin) << replayed.err;
    const auto fitted = test::fingerpad("fit " + trace + " --out p.toml --quiet", folder);
    EXPECT_EQ(fitted.err.find("warning: " + trace + words) != std::string::npos, is_thin) << fitted.err;
  }
}

TEST(ChosenTraces, AreKeptByResumeWhereTheChoiceIsTheSame) {
  const fs::path folder = folder_with_scene();
  for (const std::string format : {"h5", "csv"}) {
    const std::string again = "replay s.toml --out " + format + " --resume --format " + format;
    const auto kept = [&](const std::string& choice) {
      return test::fingerpad(again + choice, folder).out.find("kept from before") != std::string::npos;
    };
    EXPECT_FALSE(kept(" --columns mu --every 7"));
    EXPECT_TRUE(kept(" --columns mu,t_s --every 7")) << "t_s is always there";
    EXPECT_FALSE(kept(" --columns mu --every 8"));
    EXPECT_FALSE(kept(" --columns fn_n --every 8"));
    EXPECT_FALSE(kept(""));
    EXPECT_TRUE(kept(""));
  }
}

}  // namespace
}  // namespace fingerpad::trace_choice_test
