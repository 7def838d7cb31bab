#ifdef FINGERPAD_VIEW
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// The page of a replay's folder: what stands in it, and what a browser makes of it.

namespace fingerpad::report_test {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Two meshes, of which one is no mesh, by three laws: the sound one's name is markup.
fs::path folder_with_set(const std::string& options = "") {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "<b>&.stl") << test::binary_stl(test::box_soup(Vec3(20, 10, 5)));
  std::ofstream(folder / "torn.stl") << "solid torn\nfacet";
  std::ofstream(folder / "s.toml") << R"(name = "s"
[[part]]
mesh = "<b>&.stl"
[motion]
kind = "line"
from_m = [-0.008, 0, 0.003]
to_m = [0.008, 0, 0.002]
speed_m_per_s = 0.05
[[set]]
mesh = ["<b>&.stl", "torn.stl"]
friction.law = ["coulomb", "dahl", "finger-pad"]
)";
  EXPECT_EQ(test::fingerpad("replay s.toml --quiet --out 'a<b' " + options, folder).exit_code, 4);
  return folder;
}

std::string page_of(const fs::path& folder) {
  const auto result = test::fingerpad("report 'a<b' --out page.html --quiet", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return test::bytes_of(folder / "page.html");
}

/// What the page's scripts are given.
json results_in(const std::string& page) {
  const std::string mark = "<script type=\"application/json\" id=\"results\">";
  const std::size_t begin = page.find(mark) + mark.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Report, HoldsEachJobAndFetchesNothing) {
  const fs::path folder = folder_with_set();
  const std::string page = page_of(folder);
  const json results = results_in(page);
  ASSERT_EQ(results["jobs"].size(), 6u);
  EXPECT_EQ(results["shapes"].size(), 1u) << "three runs share a part";
  EXPECT_EQ(results["shapes"][0]["triangles"], 12);
  for (std::size_t i = 0; i < 6; ++i) {
    const json& job = results["jobs"][i];
    EXPECT_EQ(job["number"], i + 1);
    EXPECT_EQ(job["mesh"], i < 3 ? "<b>&.stl" : "torn.stl");
    EXPECT_EQ(job.contains("run"), i < 3);
    if (i >= 3) continue;
    EXPECT_GT(job["run"]["thumbnail"].get<std::string>().size(), 1000u);
    EXPECT_EQ(job["run"]["shape"], 0);
    EXPECT_NEAR(job["run"]["maxForce"].get<double>(), 0.5, 0.1) << "half a millimetre on 1000 N/m";
  }
  EXPECT_THAT(page, HasSubstr("<h1>a&lt;b</h1>"));
  EXPECT_THAT(page, Not(HasSubstr("<b>&.stl"))) << "a name that is markup";
  for (const std::string attribute : {"src=", "href=", "url("}) {
    for (const char* quote : {"\"", "'", ""}) {
      for (const char* address : {"http", "//"})
        EXPECT_THAT(page, Not(HasSubstr(attribute + quote + address)));
    }
  }
  EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
  EXPECT_THAT(page, HasSubstr("Permission is hereby granted")) << "the libraries' licence";
}

TEST(Report, PutsFailedJobsFirstWithTheirReason) {
  const json results = results_in(page_of(folder_with_set()));
  for (std::size_t i = 0; i < 6; ++i) {
    const json& job = results["jobs"][i];
    EXPECT_EQ(job["rank"].get<int>() <= 3, i >= 3) << i;
    if (i < 3) continue;
    EXPECT_THAT(job["status"], HasSubstr("torn.stl"));
    EXPECT_EQ(job["trouble"], "failed");
    EXPECT_TRUE(job["figures"][0].is_null());
  }
}

TEST(Report, DrawsNoTraceOfAnEarlierRunForAJobThatFailed) {
  const fs::path folder = folder_with_set();
  fs::copy_file(folder / "a<b/s-0001.h5", folder / "a<b/s-0004.h5");
  const json job = results_in(page_of(folder))["jobs"][3];
  EXPECT_EQ(job["trouble"], "failed");
  EXPECT_FALSE(job.contains("run"));
  EXPECT_EQ(job["trace"], "");
  EXPECT_THAT(job["note"], HasSubstr("failed"));
}

TEST(Report, TakesLessThanFifteenKilobytesAJobBesideItsLibraries) {
  const std::string page = page_of(folder_with_set());
  json results = results_in(page);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(results["jobs"][i].dump().size(), 15'000u);
  EXPECT_LT(page.size() - results.dump().size(), 1'600'000u) << "libraries and the page's own scripts";
}

TEST(Report, WithoutTracesHasTablesAlone) {
  const fs::path folder = folder_with_set("--format none");
  const json results = results_in(page_of(folder));
  EXPECT_EQ(results["jobs"].size(), 6u);
  EXPECT_THAT(results["jobs"][0]["note"], HasSubstr("no trace of this job"));
  EXPECT_THAT(results["jobs"][3]["note"], HasSubstr("failed"));
}

TEST(Report, ShowsAJobWhoseTraceIsDamagedWithTheReason) {
  const fs::path folder = folder_with_set();
  std::ofstream(folder / "a<b" / "s-0002.h5") << "no HDF5";
  const auto told = test::fingerpad("report 'a<b' --out page.html --quiet", folder);
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_THAT(told.err, HasSubstr("fingerpad: warning: a<b/s-0002.h5"));
  EXPECT_THAT(told.err, HasSubstr("; `fingerpad replay --resume` makes it again\n"));
  const json results = results_in(test::bytes_of(folder / "page.html"));
  EXPECT_THAT(results["jobs"][1]["trouble"], HasSubstr("trace cannot be read"));
  EXPECT_THAT(results["jobs"][1]["damage"], HasSubstr("a<b/s-0002.h5"));
  EXPECT_FALSE(results["jobs"][2].contains("damage"));
  EXPECT_THAT(results["jobs"][1]["note"], HasSubstr("trace cannot be read"));
  EXPECT_FALSE(results["jobs"][1].contains("run"));
  EXPECT_TRUE(results["jobs"][2].contains("run"));
}

TEST(Report, FlagsATraceThatIsCutShort) {
  const fs::path folder = folder_with_set("--format csv");
  const fs::path trace = folder / "a<b" / "s-0002.csv";
  fs::resize_file(trace, fs::file_size(trace) - 2);
  const auto told = test::fingerpad("report 'a<b' --out page.html --quiet", folder);
  EXPECT_THAT(told.err, HasSubstr("fingerpad: warning: a<b/s-0002.csv: ends within a row"));
  const json results = results_in(test::bytes_of(folder / "page.html"));
  EXPECT_THAT(results["jobs"][1]["trouble"], HasSubstr("trace cut short"));
  EXPECT_THAT(results["jobs"][1]["damage"], HasSubstr("s-0002.csv: ends within a row"));
}

TEST(Report, DrawsTheWorstOfTheJobsThatHaveATrace) {
  const fs::path folder = folder_with_set();
  const auto told = test::fingerpad("report 'a<b' --details 2 --out page.html", folder);
  EXPECT_THAT(told.out, HasSubstr("6 jobs, 2 of them drawn")) << "those that failed take no place";
}

/// What it says is done here, and mends the folder.
TEST(Report, SaysOfAReplayThatWasKilledHowItEnds) {
  for (const std::string format : {"h5", "none"}) {
    for (const std::string shard : {"", " --shard 1/2"}) {
      const std::string options = "--format " + format + shard;
      const fs::path folder = folder_with_set(options);
      const std::string of_shard = shard.empty() ? ".csv" : "-1of2.csv";
      for (const char* table : {"summary", "timing"})
        ASSERT_TRUE(fs::remove(folder / "a<b" / (table + of_shard)));
      const auto told = test::fingerpad("report 'a<b'", folder);
      EXPECT_EQ(told.exit_code, 3);
      const std::string begin = "its replay did not end: the same `fingerpad replay` ";
      ASSERT_THAT(told.err, HasSubstr(begin));
      const std::string advice = told.err.substr(told.err.find(begin) + begin.size());
      EXPECT_EQ(advice, format == "h5"
                            ? "with --resume does the rest and writes it\n"
                            : "does all its jobs again, of which it keeps no traces, and writes it\n");
      const std::string resume = advice.find("--resume") == std::string::npos ? "" : " --resume";
      const auto again = test::fingerpad("replay s.toml --quiet --out 'a<b' " + options + resume, folder);
      EXPECT_EQ(again.exit_code, 4) << "one mesh is none: " << again.err;
      EXPECT_EQ(test::fingerpad("report 'a<b' --quiet", folder).exit_code, 0);
    }
  }
}

TEST(Report, TakesNoOtherTableForASignOfAReplay) {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "o");
  for (const char* name :
       {"jobs-list.csv", "jobs-3of2.csv", "jobs-1of2x.csv", "jobs-01of2.csv", "jobs-1of2.csv.csv"})
    std::ofstream(folder / "o" / name) << "a,b\n1,2\n";
  EXPECT_THAT(test::fingerpad("report o", folder).err, HasSubstr("o: holds no summary.csv: name the folder"));
  std::ofstream(folder / "o" / "summary-of-mine.csv") << "a,b\n1,2\n";
  EXPECT_THAT(test::fingerpad("report o", folder).err, HasSubstr("o: holds no summary.csv: name the folder"));
}

TEST(Report, LooksAtTheEndsOfTheTracesThatItDoesNotDraw) {
  for (const std::string format : {"h5", "csv"}) {
    const fs::path folder = folder_with_set("--format " + format), out = folder / "a<b";
    const auto report = [&] {
      const auto told = test::fingerpad("report 'a<b' --details 0 --out page.html", folder);
      EXPECT_THAT(told.out, HasSubstr("6 jobs, 0 of them drawn"));
      return told.err;
    };
    EXPECT_EQ(report(), "");
    fs::resize_file(out / ("s-0001." + format), fs::file_size(out / ("s-0001." + format)) / 2);
    fs::remove(out / ("s-0003." + format));
    const std::string told = report();
    EXPECT_THAT(told, HasSubstr("fingerpad: warning: a<b/s-0001." + format));
    EXPECT_THAT(told, HasSubstr("fingerpad: warning: a<b/s-0003: has no trace, as other jobs have; "));
    const json results = results_in(test::bytes_of(folder / "page.html"));
    EXPECT_THAT(results["jobs"][0]["trouble"], HasSubstr("trace c")) << "cut short, or cannot be read";
    EXPECT_THAT(results["jobs"][0]["note"], HasSubstr("only the beginning and the end are looked at"));
    EXPECT_FALSE(results["jobs"][1].contains("damage")) << "a sound one";
    EXPECT_THAT(results["jobs"][2]["trouble"], HasSubstr("trace is missing"));
    EXPECT_FALSE(results["jobs"][4].contains("damage")) << "a job that failed has none";
  }
}

TEST(Report, TellsTheFirstOfManyDamagedTraces) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = "
         "\"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, "
         "-0.001]\nspeed_m_per_s = 0.2\n[[set]]\nseed = { from = 1, to = 13, steps "
         "= 13 }\n";
  ASSERT_EQ(test::fingerpad("replay s.toml --quiet --format csv --out o", folder).exit_code, 0);
  for (int k = 1; k <= 12; ++k)
    std::ofstream(folder / "o" / ("s-00" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ".csv"))
        << "";
  const auto told = test::fingerpad("report o --quiet", folder);
  EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 11) << told.err;
  EXPECT_THAT(told.err, HasSubstr("warning: o/s-0010.csv: is empty; "));
  EXPECT_THAT(told.err, HasSubstr("warning: and 2 more damaged traces in the page's column `trouble`\n"));
}

TEST(Report, OfCsvTracesShowsThePathAndSaysWhyThereIsNoPart) {
  const fs::path folder = folder_with_set("--format csv");
  const json results = results_in(page_of(folder));
  EXPECT_EQ(results["jobs"][0]["run"]["shape"], -1);
  EXPECT_GT(results["jobs"][0]["run"]["path"]["count"], 100);
  EXPECT_THAT(results["jobs"][0]["run"]["notice"], HasSubstr("CSV"));
}

TEST(Report, RefusesWhatItCannotMakeAPageOf) {
  const fs::path folder = folder_with_set();
  const auto told = [&](const std::string& arguments, int code) {
    const auto result = test::fingerpad("report " + arguments, folder);
    EXPECT_EQ(result.exit_code, code) << arguments;
    return result.err;
  };
  fs::create_directory(folder / "empty");
  EXPECT_THAT(told("none", 3), HasSubstr("none: is no folder"));
  EXPECT_THAT(told("empty", 3), HasSubstr("holds no summary.csv"));
  EXPECT_THAT(told("'a<b' --libraries empty", 2), HasSubstr("`apt install libjs-jquery` brings it"));
  EXPECT_THAT(told("'a<b' --out nowhere/page.html", 2), HasSubstr("nowhere"));
  EXPECT_THAT(told("'a<b' --out 'a<b/summary.csv'", 2), HasSubstr(".html"));
  std::ofstream(folder / "empty" / "summary.csv") << "a,b\n1,2\n";
  EXPECT_THAT(told("empty", 3), HasSubstr("has no column `status`"));
}

TEST(Summary, IsReadByOtherProgramsAsItsSchemaSays) {
  const fs::path folder = folder_with_set("--format none");
  std::ofstream(folder / "read.py") << R"python(import csv, json
fields = json.load(open("a<b/summary.schema.json"))["fields"]
header, *rows = csv.reader(open("a<b/summary.csv"))
assert header == [field["name"] for field in fields], header
for i, field in enumerate(fields):
    for row in rows:
        if field["type"] != "string": float(row[i])
)python";
  const auto result = test::shell("/usr/bin/python3 read.py", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(Summary, IsReadByPandasAsItIs) {
  if (test::shell("/usr/bin/python3 -c 'import pandas'", test::scratch_dir()).exit_code != 0)
    GTEST_SKIP() << "python3-pandas is not installed";
  const fs::path folder = folder_with_set("--format none");
  std::ofstream(folder / "read.py") << R"python(import json, pandas
fields = json.load(open("a<b/summary.schema.json"))["fields"]
table = pandas.read_csv("a<b/summary.csv")
assert table.loc[0, "max_normal_force_n"] > 0.3 and table.loc[0, "mesh"] == "<b>&.stl"
for field in fields:
    assert field["type"] == "string" or table[field["name"]].dtype.kind in "if", field["name"]
)python";
  const auto result = test::shell("/usr/bin/python3 read.py", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

/// What a browser says to these steps (tests/support/open_in_chromium), a line each.
std::vector<json> browsed(const fs::path& folder, const std::string& steps, const std::string& size = "") {
  std::ofstream(folder / "steps") << steps;
  const std::string driver = (test::source_dir() / "tests" / "support" / "open_in_chromium").string();
  const auto result = test::shell("'" + driver + "' page.html " + size + " < steps", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::vector<json> answers;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
  return answers;
}

TEST(Report, InABrowserShowsAllColumnsOfItsTableInASmallWindowAndSaysWhereMoreAreWiderThanIt) {
  if (test::shell("command -v chromium", test::scratch_dir()).exit_code != 0)
    GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = folder_with_set("--format none");
  page_of(folder);
  const auto answers = browsed(folder, R"steps(until document.documentElement.dataset.ready === "yes"
js (window.table = document.getElementById("job-table_wrapper"), window.fits = () => [table.scrollWidth <= table.clientWidth, document.getElementById("wide").hidden])()
js fits()
click #all-figures
js fits()
click #all-figures
js fits()
)steps",
                               "1024x768");
  ASSERT_EQ(answers.size(), 5u);
  EXPECT_EQ(answers[1], json::parse("[true, true]"));
  EXPECT_EQ(answers[2], json::parse("[false, false]"));
  EXPECT_EQ(answers[3], json::parse("[true, true]"));
}

/// A chart's labels go by how wide they are, not by how many letters they have.
TEST(Report, InABrowserHangsWideLabelsAtASlantAndKeepsAllInsideThePicture) {
  if (test::shell("command -v chromium", test::scratch_dir()).exit_code != 0)
    GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = folder_with_set("--format none");
  page_of(folder);
  const auto answers = browsed(folder, R"steps(until document.documentElement.dataset.ready === "yes"
js (location.hash = "charts", 1)
until document.querySelectorAll("#chart circle").length === 3
js (window.drawn = letters => { categories = () => [{ name: "x", of: job => letters + report.jobs.indexOf(job) % 3 }]; chosen.across = 0; chosen.colour = 1; drawDots(); const page = document.querySelector("#chart svg").getBoundingClientRect(), labels = [...document.querySelectorAll("#chart text")]; return [labels.some(label => (label.getAttribute("transform") || "").startsWith("rotate(-35")), labels.every(label => { const box = label.getBoundingClientRect(); return box.left >= page.left - 1 && box.bottom <= page.bottom + 1; })]; }, 1)
js drawn("W".repeat(40))
js drawn("i".repeat(60))
js drawn("W".repeat(300))
)steps");
  ASSERT_EQ(answers.size(), 6u);
  EXPECT_EQ(answers[2], json({true, true})) << "40 wide letters";
  EXPECT_EQ(answers[3], json({false, true})) << "60 narrow ones";
  EXPECT_EQ(answers[4], json({true, true})) << "far too many";
  EXPECT_EQ(answers[5], json({{"requests", json::array()}, {"errors", json::array()}}));
}

TEST(Report, InABrowserIsClickedFilteredAndTurned) {
  if (test::shell("command -v chromium", test::scratch_dir()).exit_code != 0)
    GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = folder_with_set();
  page_of(folder);
  const auto answers = browsed(folder, R"steps(until document.documentElement.dataset.ready === "yes"
js document.querySelectorAll("#job-table tbody tr").length
js document.querySelector("#job-table tbody tr td:nth-child(3)").textContent
type #job-table_filter>label>input finger-pad
js document.querySelectorAll("#job-table tbody tr").length
js Object.assign(document.querySelector("[data-filter=status]"), { value: 2 }).dispatchEvent(new Event("change"))
js document.querySelectorAll("#job-table tbody tr").length
click #job-table tbody tr
until document.querySelector("#job canvas")
js document.querySelector("#job-head h2").textContent
js (window.picture = () => document.querySelector("#shape canvas").toDataURL(), window.before = picture(), 1)
js before.length
drag #shape canvas 120 60
js picture() !== before
js document.querySelectorAll("#strips canvas").length >= 4
js [...document.querySelectorAll("#strips .dygraph-xlabel")].filter(label => label.textContent === "time [s]").length
js document.querySelector("#figures td").textContent + document.querySelectorAll("#figures wbr").length
js (document.querySelector("[data-look=whole]").click(), window.seen = [...Array(shapeView.shapePoints.length / 3).keys()].map(i => new THREE.Vector3().fromArray(shapeView.shapePoints, 3 * i).project(shapeView.camera)).map(p => Math.max(Math.abs(p.x), Math.abs(p.y))), Math.max(...seen))
js (location.hash = "charts", 1)
until document.querySelectorAll("#chart circle").length === 3
js document.querySelectorAll("#matrix td").length
js (window.teeth = { inPairs: true, times: [...Array(40).keys()], values: [...Array(40).keys()].map(i => i % 2) }, [denseStretches(teeth).every(Boolean), denseStretches({ inPairs: true, values: teeth.times }).some(Boolean)])
js (window.fills = 0, curvePlotter(teeth)({ points: teeth.times.map((t, i) => ({ xval: t, yval: teeth.values[i], canvasx: t, canvasy: teeth.values[i] })), drawingContext: new Proxy({}, { get: (_, name) => () => { fills += name === "fill"; }, set: () => true }), color: "red", strokeWidth: 1 }), fills)
js (window.between = (count, value) => { const up = [...Array(40).keys()].map(i => i % 2), other = [...Array(2 * count).keys()].map(value); return { inPairs: true, values: [...up, ...other, ...up] }; }, [between(4, i => 0.04 * i), between(20, i => 0.04 * i), between(4, i => 0.5)].map(curve => { const dense = denseStretches(curve); return [dense.slice(0, 19).every(Boolean), dense.slice(20, -20).filter(Boolean).length, dense.slice(-19).every(Boolean)]; }))
js [[1, 1.001, 2], [1, 1.001], [1, 1000], [0, 10, 1, 1000]].map(values => { const scale = colourScale(values); return Math.round(1000 * (scale.share(values[1]) - scale.share(values[0]))); })
js ["use --unit m", "a_b.stl: bad", "part-0003.csv", "x.stl.txt", "at 0.001227 mm"].map(text => { const p = element("p", {}, breakable(text)); return [p.textContent === text, p.querySelectorAll("wbr").length, p.querySelectorAll(".option").length]; })
js axisEnds(0, 0.73, 6).concat(axisEnds(-0.2, 31, 6)).map(end => +end.toPrecision(3))
js [[0, 255], [255, 0], [6, 249], [1, 254], [64, 64], [0, 0], [255, 1]].map(([slip, stick]) => phaseHeights(slip, stick, 100).map(Math.round))
click nav a[href="#licences"]
until getComputedStyle(document.getElementById("licences")).display === "block"
)steps");
  ASSERT_EQ(answers.size(), 23u);
  EXPECT_EQ(answers[0], 6) << "rows";
  EXPECT_THAT(answers[1], HasSubstr("failed: ")) << "the worst stand first";
  EXPECT_EQ(answers[2], 2) << "of the law that was typed";
  EXPECT_EQ(answers[4], 1) << "of these that is ok";
  EXPECT_EQ(answers[5], "s job 3 \xC2\xB7 <b>&.stl");
  EXPECT_GT(answers[7], 4000) << "something is drawn";
  EXPECT_EQ(answers[8], true) << "the part has turned";
  EXPECT_EQ(answers[9], true) << "strip charts";
  EXPECT_EQ(answers[10], 4) << "each strip chart's axis is labelled";
  EXPECT_THAT(answers[11].get<std::string>(), testing::StartsWith("mesh"))
      << "names can break where they have signs";
  EXPECT_NE(answers[11], "mesh0");
  EXPECT_GT(answers[12], 0.8) << "the whole part fills the view";
  EXPECT_LE(answers[12], 1);
  EXPECT_EQ(answers[14], 3) << "medians, a law each";
  EXPECT_EQ(answers[15], json({true, false})) << "teeth are dense, a rise is not";
  EXPECT_EQ(answers[16], 1) << "a band";
  EXPECT_EQ(answers[17], json::parse("[[true, 4, true], [true, 0, true], [true, 0, true]]"))
      << "a few stretches of a rise between dense ones belong to their band; many do not, nor do level ones";
  EXPECT_EQ(answers[18], json({1, 0, 1000, 433}))
      << "what differs by a thousandth looks alike, and 0 is none";
  EXPECT_EQ(answers[19],
            json::parse("[[true, 0, 1], [true, 0, 0], [true, 1, 0], [true, 1, 0], [true, 0, 0]]"))
      << "no break before a file's ending, nor within an option or a number";
  EXPECT_EQ(answers[20], json({0, 0.8, -10, 40})) << "ends at ticks";
  EXPECT_EQ(answers[21], json::parse("[[0, 100], [100, 0], [3, 97], [3, 97], [25, 25], [0, 0], [97, 3]]"))
      << "slip is as high as its share, and never too low to be seen";
  EXPECT_EQ(answers[22], json({{"requests", json::array()}, {"errors", json::array()}}));
}

}  // namespace
}  // namespace fingerpad::report_test
#endif
