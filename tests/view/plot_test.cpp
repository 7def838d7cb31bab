#include "view/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "trace/trace_choice.hpp"
#include "view/left_out_ticks.hpp"
#include "view/rub.hpp"
#include "view/run_title.hpp"

namespace fingerpad::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Plot, SvgHoldsItsLabelsAsText) {
  const auto path = scratch_dir() / "plot.svg";
  write_plot(torus_rub(), path.string(), 1000);
  const std::string svg = text_of(path);
  for (const char* label :
       {"time [s]", "[mm]", "speed [mm/s]", "force [N]", "mu [1]", "stick centre", "normal", "friction along",
        "frequency [Hz]", "N\xC2\xB2/Hz", "phase", "slip", ">torus<"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

/// A title is bold, which is wider: what is too wide is first written smaller, then cut in its middle.
TEST(Plot, KeepsBothEndsOfALongTitleInsideThePage) {
  const auto path = scratch_dir() / "long.svg";
  const double width = 600;
  for (const std::size_t letters : {20u, 30u, 45u, 300u}) {
    ViewInput input = torus_rub();
    input.title = "first-" + std::string(letters, 'W') + "-last.stl";
    write_plot(input, path.string(), 600);
    const std::string svg = text_of(path);
    const std::size_t begin = svg.rfind(">first-") + 1;
    ASSERT_GT(begin, svg.find(">first-") + 1) << "behind the file's own title";
    const std::string shown = svg.substr(begin, svg.find("</text>", begin) - begin);
    EXPECT_TRUE(shown.ends_with("W-last.stl")) << shown;
    const std::string size_key = "font-size=\"";
    const double size = std::stod(svg.substr(svg.rfind(size_key, begin) + size_key.size()));
    EXPECT_LE(text_width(shown, size, true), width) << shown;
    EXPECT_EQ(shown.find("...") != std::string::npos, letters > 30) << shown;
  }
}

TEST(Plot, OfAThinnedTraceSaysSo) {
  const auto folder = scratch_dir();
  ViewInput input = torus_rub();
  const auto subtitle_is_there = [&](const char* words, PlotSubject subject) {
    write_plot(input, (folder / "thin.svg").string(), 800, subject, Over::time);
    return text_of(folder / "thin.svg").find(words) != std::string::npos;
  };
  EXPECT_FALSE(subtitle_is_there("1 in ", PlotSubject::history));
  input.every = 10;
  EXPECT_TRUE(subtitle_is_there("1000 ticks a second, of which 1 in 10 is here", PlotSubject::history));
  EXPECT_TRUE(subtitle_is_there("ticks were left out", PlotSubject::spectrum));
  EXPECT_FALSE(subtitle_is_there("peaks at", PlotSubject::spectrum));
  input.every = 1;
  EXPECT_TRUE(subtitle_is_there("peaks at", PlotSubject::spectrum));
}

TEST(Plot, OfAThinnedTraceSaysWhatItsSpectrumIsNot) {
  const auto path = scratch_dir() / "thin.svg";
  ViewInput input = torus_rub();
  const std::string folded = "ticks were left out: what is faster than 500 Hz appears as something slower";
  const auto page = [&](PlotSubject subject) {
    write_plot(input, path.string(), 800, subject, Over::time);
    return text_of(path);
  };
  EXPECT_THAT(page(PlotSubject::history), Not(HasSubstr("slower")));
  input.every = 10;
  EXPECT_THAT(page(PlotSubject::history),
              AllOf(HasSubstr(">spectrum: " + folded + "<"), HasSubstr("no rings where slip ended")));
  EXPECT_THAT(page(PlotSubject::spectrum), AllOf(HasSubstr(">" + folded + "<"), Not(HasSubstr("rings"))));
  input.scene.reset();
  EXPECT_THAT(page(PlotSubject::history), HasSubstr(">1 tick in 10 is here: no rings where slip ended"));
}

TEST(Plot, OfAThinnedTraceOverItsWaySaysThatTheWayIsLonger) {
  const auto path = scratch_dir() / "thin.svg";
  ViewInput input = torus_rub();
  const auto page = [&](Over over) {
    write_plot(input, path.string(), 800, PlotSubject::history, over);
    return text_of(path);
  };
  for (const Over over : {Over::travel, Over::turn}) EXPECT_THAT(page(over), Not(HasSubstr("summed")));
  input.every = 10;
  EXPECT_THAT(page(Over::time), Not(HasSubstr("summed")));
  EXPECT_THAT(
      page(Over::travel),
      HasSubstr(">travel: summed from each tick that is here to the next; with those between it is longer<"));
  EXPECT_THAT(
      page(Over::turn),
      HasSubstr(">turn: summed from each tick that is here to the next; with those between it is larger<"));
}

TEST(Plot, OfAThinnedTraceInCsvSaysSoAsFarAsItsRowsTell) {
  const auto folder = scratch_dir();
  Trace trace;
  trace.rows = torus_rub(3.004).rows;
  const auto last = static_cast<long>(trace.rows.size()) - 1;
  EXPECT_EQ(view_of_trace(trace, "whole.csv").every, 1u);
  long k = 0;
  std::erase_if(trace.rows, [&](const TickRecord&) { return !is_kept(k++, last, 10); });
  const ViewInput input = view_of_trace(trace, "thin.csv");
  EXPECT_EQ(input.every, 10u) << "the last of 3104 ticks comes 3 after the one before it";
  write_plot(input, (folder / "thin.svg").string(), 800);
  const std::string history = text_of(folder / "thin.svg");
  EXPECT_THAT(history, HasSubstr("ticks were left out"));
  EXPECT_THAT(history, Not(HasSubstr("end of slip")));
  write_plot(input, (folder / "thin.svg").string(), 800, PlotSubject::spectrum);
  const std::string spectrum = text_of(folder / "thin.svg");
  EXPECT_THAT(spectrum, Not(HasSubstr("peaks at")));
  EXPECT_THAT(spectrum, Not(HasSubstr(">; ")));
  trace.info.scene_text = "name = \"t\"";
  EXPECT_EQ(ticks_a_row(trace), 1u) << "a trace that has its scene says it itself";
}

TEST(Plot, SaysTheRateThatServedWhereTheSceneLeftItToTheRecording) {
  const auto path = scratch_dir() / "own.svg";
  Trace trace;
  trace.rows = torus_rub().rows;
  trace.info.scene_text = "name = \"t\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  trace.info.rate_hz = 200;
  write_plot(view_of_trace(trace, "own.h5"), path.string(), 800);
  EXPECT_THAT(text_of(path), HasSubstr("200 ticks a second"));
}

TEST(Plot, OfATraceInCsvSaysWhereItsSpectrumPeaksAndNothingBeforeThat) {
  const auto path = scratch_dir() / "csv.svg";
  Trace trace;
  trace.rows = torus_rub().rows;
  write_plot(view_of_trace(trace, "whole.csv"), path.string(), 800, PlotSubject::spectrum);
  EXPECT_THAT(text_of(path), HasSubstr("peaks at"));
  EXPECT_THAT(text_of(path), Not(HasSubstr(">; ")));
}

TEST(RunTitle, NamesAMeshOnce) {
  TraceInfo info;
  info.scene_name = "torus";
  info.mesh_files = {"parts/torus.stl"};
  EXPECT_EQ(run_title(info, "run.h5"), "torus.stl");
  info.mesh_files.emplace_back("lid.stl");
  EXPECT_EQ(run_title(info, "run.h5"), "torus: torus.stl, lid.stl");
  info.scene_name = "rub";
  info.mesh_files.pop_back();
  EXPECT_EQ(run_title(info, "run.h5"), "rub: torus.stl");
  const ViewInput input = torus_rub(0.1);
  EXPECT_THAT(subtitle_of(input, "run.h5"), StartsWith("torus.stl, finger-pad"));
  for (const char* beside : {"torus", "torus.stl", "rub: torus.stl"})
    EXPECT_THAT(subtitle_of(input, beside), StartsWith("finger-pad, mu ")) << beside;
}

TEST(RunTitle, TellsAWindowWhatVariesInASet) {
  EXPECT_EQ(varied_words("t: knob.stl \xC2\xB7 job 3 \xC2\xB7 mu_static 0.3"), "job 3, mu_static 0.3");
  EXPECT_EQ(varied_words("t: knob.stl"), "");
}

TEST(Plot, SvgIsTheSameTwiceAndKeepsWithinItsPage) {
  const auto folder = scratch_dir();
  write_plot(torus_rub(), (folder / "a.svg").string(), 800);
  write_plot(torus_rub(), (folder / "b.svg").string(), 800);
  const std::string svg = text_of(folder / "a.svg");
  EXPECT_EQ(svg, text_of(folder / "b.svg"));
  std::istringstream words(svg);
  for (std::string word; words >> word;) {
    double x = 0, y = 0;
    if (word.starts_with("points=\"")) word = word.substr(8);
    if (std::sscanf(word.c_str(), "%lf,%lf", &x, &y) != 2) continue;
    EXPECT_TRUE(x >= 0 && x <= 800 && y >= 0 && y <= 960) << word;
  }
}

TEST(Plot, PngIsWritten) {
  const auto path = scratch_dir() / "plot.png";
  write_plot(torus_rub(), path.string(), 500);
  const std::string png = text_of(path);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_GT(png.size(), 10'000u);  // a blank page of this size takes under 2 kB
}

TEST(Plot, EscapesTheTitle) {
  const auto path = scratch_dir() / "plot.svg";
  ViewInput input = torus_rub(0.1);
  input.title = "a < b & \"c\"";
  write_plot(input, path.string(), 500);
  EXPECT_THAT(text_of(path), HasSubstr("a &lt; b &amp;"));
}

TEST(Plot, RefusesWhatItCannotDraw) {
  const auto kind_of = [](const ViewInput& input, const std::string& name) {
    try {
      write_plot(input, (scratch_dir() / name).string(), 500);
    } catch (const Error& error) {
      return static_cast<int>(error.kind());
    }
    return 0;
  };
  EXPECT_EQ(kind_of(torus_rub(0.1), "plot.jpg"), 2);
  EXPECT_EQ(kind_of(torus_rub(0.1), "no/such/folder/plot.svg"), 2);
  ViewInput empty = torus_rub(0.1);
  empty.rows.resize(1);
  EXPECT_EQ(kind_of(empty, "plot.svg"), 3);
}

}  // namespace
}  // namespace fingerpad::test
