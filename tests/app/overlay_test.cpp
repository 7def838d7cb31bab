#ifdef FINGERPAD_VIEW
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// Plots of several traces, and of traces beside measurements.

namespace fingerpad::overlay_test {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two jobs on a mesh, which differ in mu_dynamic.
fs::path folder_with_set() {
  const fs::path folder = test::scratch_dir();
  fs::copy(test::source_dir() / "scenes" / "parts" / "bracket_coarse.stl", folder / "bracket.stl");
  std::ofstream(folder / "t.toml")
      << "name = \"t\"\n[[part]]\nmesh = \"bracket.stl\"\n[contact]\nmethod = \"proxy\"\nnormals = "
         "\"smooth\"\n"
         "[motion]\nkind = \"circle\"\ncentre_m = [0.06, 0.04, 0.003]\nradius_m = 0.01\nfrequency_hz = 2\n"
         "duration_s = 0.5\n[[set]]\npart.mu_dynamic = [0.2, 0.1]\n";
  EXPECT_EQ(test::fingerpad("replay t.toml --out o --quiet", folder).exit_code, 0);
  return folder;
}

TEST(Overlay, OfTwoJobsTellsWhatDiffersAndByHowMuch) {
  const fs::path folder = folder_with_set();
  const auto result = test::fingerpad("plot o/t-0001.h5 o/t-0002.h5 --out p.svg", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("friction: RMS 0.36"));  // 3 to 5 N pressed, 0.1 between the coefficients
  EXPECT_THAT(result.out, HasSubstr("'mu_dynamic 0.1' less 'mu_dynamic 0.2', 501 ticks"));
  const std::string svg = test::bytes_of(folder / "p.svg");
  for (const char* label : {">t: bracket.stl<", ">mu_dynamic 0.2<", ">mu_dynamic 0.1<",
                            "mu_dynamic 0.1: RMS 0.36", ">time [s]<", "residual"}) {
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  }
}

TEST(Overlay, LaysMeasuredForcesOverATrace) {
  const fs::path folder = folder_with_set();
  std::ofstream(folder / "measured.csv") << "t_s,x_m,fz_n,fn_n\n0,0,0,0\n0.25,0,1,1\n0.5,0,0,0\n";
  const auto result = test::fingerpad("plot o/t-0001.h5 measured.csv --columns fz_n --out p.svg", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("'measured' less 't-0001', 3 ticks"));
  EXPECT_THAT(test::bytes_of(folder / "p.svg"), HasSubstr(">fz_n [N]<"));
  EXPECT_EQ(test::fingerpad("plot measured.csv --out q.svg", folder).exit_code, 0) << "a table alone";
}

/// A table of 0.5 s at 100 Hz, with its time in seconds times `per_second`.
void write_table(const fs::path& path, double per_second) {
  std::ofstream file(path);
  file << "t_s,fz_n\n";
  for (int k = 0; k <= 50; ++k) file << 0.01 * k * per_second << "," << k << "\n";
}

TEST(Overlay, DoubtsATableWhoseTimeIsHardlyInSeconds) {
  const fs::path folder = folder_with_set();
  const auto told = [&](const std::string& call) {
    const auto result = test::fingerpad("plot " + call + " --out p.svg", folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err;
  };
  write_table(folder / "ms.csv", 1e3);
  EXPECT_EQ(told("o/t-0001.h5 ms.csv --columns fz_n"),
            "fingerpad: warning: ms.csv: its rows are 10 s apart, 500 s in all, beside 0.5 s of o/t-0001.h5: "
            "t_s is "
            "in seconds; if it holds ms, divide it by 1000\n");
  EXPECT_THAT(told("ms.csv o/t-0001.h5 --columns fz_n --to 0.4"), HasSubstr("divide it by 1000"))
      << "whatever is left out";
  write_table(folder / "us.csv", 1e6);
  EXPECT_THAT(told("o/t-0001.h5 us.csv --columns fz_n"), HasSubstr("if it holds us, divide it by 1000000"));
  write_table(folder / "s.csv", 1);
  EXPECT_EQ(told("o/t-0001.h5 s.csv --columns fz_n"), "");
  EXPECT_EQ(told("ms.csv s.csv --columns fz_n"), "") << "nothing tells which is right";
}

TEST(Overlay, OfColumnsOfOneTraceSaysWhichThereAre) {
  const fs::path folder = folder_with_set();
  const auto result = test::fingerpad("plot o/t-0001.h5 --columns fn_n,mu --out p.svg", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "wrote p.svg (fn_n, mu of 501 rows)\n");
  const auto two = test::fingerpad("plot o/t-0001.h5 o/t-0002.h5 --columns fn_n --out p.svg", folder);
  EXPECT_THAT(two.out, HasSubstr("wrote p.svg (2 overlaid)\n"));
}

TEST(Overlay, OfThinnedColumnsOverTheTurnSaysThatItIsLarger) {
  const fs::path folder = folder_with_set();
  ASSERT_EQ(test::fingerpad("replay t.toml --out thin --every 10 --quiet --format csv", folder).exit_code, 0);
  const auto words = [&](const std::string& trace) {
    return test::fingerpad("plot " + trace + " --over angle --columns fn_n --out p.svg", folder).out;
  };
  EXPECT_THAT(words("thin/t-0001.csv"), HasSubstr("turn: summed from each tick that is here to the next"));
  EXPECT_THAT(words("o/t-0001.h5"), Not(HasSubstr("summed")));
}

TEST(Overlay, OverTravelAndTurnNamesItsAxis) {
  const fs::path folder = folder_with_set();
  EXPECT_EQ(test::fingerpad("plot o/t-0001.h5 o/t-0002.h5 --over s --out p.svg", folder).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder / "p.svg"), HasSubstr(">travel along the surface [mm]<"));
  EXPECT_EQ(test::fingerpad("plot o/t-0001.h5 --over s --out q.svg", folder).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder / "q.svg"), HasSubstr(">travel along the surface [mm]<"));
  std::ofstream(folder / "flat.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\n"
                                         "kind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\n"
                                         "amplitude_m = 0.05\nfrequency_hz = 1\nduration_s = 1\n";
  ASSERT_EQ(test::fingerpad("replay flat.toml --out o --quiet", folder).exit_code, 0);
  const auto flat = test::fingerpad("plot o/flat.h5 --over angle --out r.svg", folder);
  EXPECT_EQ(flat.exit_code, 3);
  EXPECT_THAT(flat.err, HasSubstr("stays where the surface does not turn: nothing to plot over its turn"));
}

TEST(Overlay, ThatCannotBeIsRefusedForAPerson) {
  const fs::path folder = folder_with_set();
  std::ofstream(folder / "tea.csv") << "tea,milk\n1,2\n";
  const auto tea = test::fingerpad("plot o/t-0001.h5 tea.csv --out p.svg", folder);
  EXPECT_EQ(tea.exit_code, 3);
  EXPECT_THAT(tea.err, HasSubstr("tea.csv:1: no column 't_s'"));
  const auto show = test::fingerpad("plot o/t-0001.h5 o/t-0002.h5 --show spectrum --out p.svg", folder);
  EXPECT_EQ(show.exit_code, 2);
  EXPECT_THAT(show.err, HasSubstr("shows one trace; name only one"));
  EXPECT_FALSE(fs::exists(folder / "p.svg"));
}

TEST(Titles, NameMeshJobAndWhatVaries) {
  const fs::path folder = folder_with_set();
  EXPECT_EQ(test::bytes_of(folder / "o" / "jobs.csv"),
            "number,file,scene,mesh,motion,part.mu_dynamic\n1,t-0001.h5,t,bracket.stl,,0.2\n"
            "2,t-0002.h5,t,bracket.stl,,0.1\n");
  EXPECT_EQ(test::fingerpad("plot o/t-0002.h5 --out p.svg", folder).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder / "p.svg"),
              HasSubstr(">t: bracket.stl \xC2\xB7 job 2 \xC2\xB7 mu_dynamic 0.1<"));
  fs::remove(folder / "o" / "jobs.csv");
  EXPECT_EQ(test::fingerpad("plot o/t-0002.h5 --out p.svg", folder).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder / "p.svg"), HasSubstr(">t: bracket.stl \xC2\xB7 job 2<"));
}

}  // namespace
}  // namespace fingerpad::overlay_test
#endif
