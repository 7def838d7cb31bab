#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/calm_scene.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// Who reads a trace says where it ends early: its last row lacks its line end, and perhaps digits.

namespace fingerpad::cut_trace_test {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;
using testing::Not;

constexpr const char* floor_and =
    "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\n";

/// A folder `whole` with a trace of 101 ticks as CSV, and one `cut` where its last digit and line end are
/// gone.
class CutTrace : public testing::Test {
 protected:
  const fs::path folder = test::scratch_dir();
  const std::string words = ": ends within a row (line 102); read up to t = 0.099 s\n";

  void SetUp() override {
    test::write_file(
        folder, "s.toml",
        std::string(floor_and) +
            "kind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.02, 0, -0.001]\nspeed_m_per_s = "
            "0.2\n");
    ASSERT_EQ(test::fingerpad("replay s.toml --quiet --format csv --out whole", folder).exit_code, 0);
    const std::string text = bytes_of(folder / "whole/s.csv");
    fs::create_directory(folder / "cut");
    test::write_file(folder / "cut", "s.csv", text.substr(0, text.size() - 2));
    whole_rows = text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  }

  /// What the program says on standard error; it ends with `code`.
  std::string told(const std::string& call, int code = 0) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, code) << call << ": " << result.err;
    return result.err;
  }

  std::string whole_rows;
};

TEST_F(CutTrace, IsExportedUpToItsLastWholeRowWithAWarning) {
  EXPECT_EQ(told("export cut/s.csv --out e.csv"), "fingerpad: warning: cut/s.csv" + words);
  EXPECT_EQ(bytes_of(folder / "e.csv"), whole_rows);
  EXPECT_EQ(told("export cut/s.csv --out e.vtp"), "fingerpad: warning: cut/s.csv" + words);
  EXPECT_EQ(told("export whole/s.csv --out e.csv"), "");
}

TEST_F(CutTrace, IsComparedWithAWarning) {
  const auto found = test::fingerpad("compare whole cut", folder);
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_EQ(found.err, "fingerpad: warning: cut/s.csv" + words);
  EXPECT_THAT(found.out, HasSubstr("101 ticks, then 100; 100 times are in both"));
}

TEST_F(CutTrace, IsFollowedWithAWarningAndARecordingOfOnesOwnNeedsNoLastLineEnd) {
  test::write_file(folder, "again.toml", std::string(floor_and) + "file = \"cut/s.csv\"\n");
  EXPECT_THAT(told("replay again.toml --out o --format csv"),
              HasSubstr("fingerpad: warning: cut/s.csv" + words));
  test::write_file(folder, "mine.csv", "t_s,x_m,y_m,z_m\n0,0,0,-0.001\n0.1,0.01,0,-0.0012");
  test::write_file(folder, "mine.toml", std::string(floor_and) + "file = \"mine.csv\"\nrate_hz = 1000\n");
  EXPECT_THAT(told("replay mine.toml --out mine --format csv"), Not(HasSubstr("ends")));
  EXPECT_THAT(bytes_of(folder / "mine/s.csv"), HasSubstr("\n0.1,0.01,0,-0.0012,")) << "its last row";
}

TEST_F(CutTrace, IsTouchedAgainWithAWarning) {
  test::write_file(folder, "again.toml", std::string(floor_and) + "file = \"cut/s.csv\"\n");
  EXPECT_THAT(told("touch again.toml --device recorded --headless --seconds 0.01"),
              HasSubstr("fingerpad: warning: cut/s.csv" + words));
}

/// The words of a table whose last row, on this line, has no end.
std::string left_out(const std::string& file, int line) {
  return "fingerpad: warning: " + file + ": ends within a row (line " + std::to_string(line) +
         "), which is left out: its last number may lack digits\n";
}

TEST_F(CutTrace, OfSomeColumnsIsFollowedWithoutItsCutRow) {
  ASSERT_EQ(
      test::fingerpad("replay s.toml --quiet --format csv --columns x_m,y_m,z_m,depth_m --out some", folder)
          .exit_code,
      0);
  const std::string text = bytes_of(folder / "some/s.csv");
  test::write_file(folder, "some.csv", text.substr(0, text.size() - 2));
  test::write_file(folder, "again.toml", std::string(floor_and) + "file = \"some.csv\"\n");
  EXPECT_THAT(told("replay again.toml --out again --format csv"), HasSubstr(left_out("some.csv", 102)));
  EXPECT_EQ(test::lines_of(bytes_of(folder / "again/s.csv")), 101) << "the header and 100 ticks";
  test::write_file(folder, "some.csv", text);
  EXPECT_THAT(told("replay again.toml --out again --format csv"), Not(HasSubstr("left out")));
  EXPECT_EQ(test::lines_of(bytes_of(folder / "again/s.csv")), 102);
}

TEST_F(CutTrace, WhoseChangesAreCutSaysSo) {
  test::write_file(folder / "cut", "s.csv", bytes_of(folder / "whole/s.csv"));
  test::write_file(folder / "cut", "s.changes.csv",
                   "t_s,key,value\n0.01,plane.mu_static,0.4\n0.02,plane.mu_st");
  EXPECT_EQ(
      told("export cut/s.csv --out e.csv"),
      "fingerpad: warning: cut/s.csv: lacks a change, for cut/s.changes.csv ends within a row; read up to t "
      "= 0.1 s\n");
}

/// A file whose header is cut, and one that has no rows, with what is said of each.
const std::pair<const char*, const char*> without_rows[] = {
    {"header.csv", ": ends within its header (line 1): no row of it is left; make it again\n"},
    {"none.csv", ": holds no row, and so nothing to show: was its run one of no ticks?\n"},
    {"row.csv", ": ends within a row (line 2); no row of it is left, and so nothing to show\n"}};

TEST_F(CutTrace, WithoutARowIsRefused) {
  const std::string text = bytes_of(folder / "whole/s.csv");
  test::write_file(folder, "header.csv", text.substr(0, 40));
  test::write_file(folder, "none.csv", text.substr(0, text.find('\n') + 1));
  test::write_file(folder, "row.csv", text.substr(0, text.find('\n') + 20));
  for (const auto& [file, why] : without_rows) {
    for (const std::string call : {"export ", "export --out e.csv "}) {
      const std::string out = call == "export " ? " --out e.vtp" : "";
      EXPECT_EQ(told(call + file + out, 3), std::string("fingerpad: error: ") + file + why) << call;
    }
    EXPECT_FALSE(fs::exists(folder / "e.csv"));
#ifdef FINGERPAD_VIEW
    for (const std::string call :
         {"plot --out p.svg ", "plot --out p.svg --columns fn_n ", "plot --out p.svg whole/s.csv ",
          "plot --out p.svg --show stick-region ", "view --png v.png ", "export --out e.vtm --with-parts "})
      EXPECT_EQ(told(call + file, 3), std::string("fingerpad: error: ") + file + why) << call;
#endif
  }
}

#ifdef FINGERPAD_VIEW
TEST_F(CutTrace, IsPlottedAndShownWithAWarning) {
  for (const char* call : {"plot cut/s.csv --out p.svg", "plot cut/s.csv whole/s.csv --out p.svg",
                           "plot cut/s.csv --columns fn_n --out p.svg", "view cut/s.csv --png v.png"})
    EXPECT_EQ(told(call), "fingerpad: warning: cut/s.csv" + words) << call;
  EXPECT_EQ(told("plot whole/s.csv --out p.svg"), "");
}

TEST_F(CutTrace, ThatARecordingLeftIsShown) {
  test::write_file(folder, "mine.csv.part", bytes_of(folder / "whole/s.csv"));
  EXPECT_THAT(told("view mine.csv.part --png v.png"),
              HasSubstr("fingerpad: warning: mine.csv.part: is of a recording that was cut short or is still "
                        "being written; read up to"));
  EXPECT_TRUE(fs::exists(folder / "v.png"));
}
#endif

}  // namespace
}  // namespace fingerpad::cut_trace_test
