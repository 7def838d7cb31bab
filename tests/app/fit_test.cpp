#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::fit_test {
namespace {
namespace fs = std::filesystem;

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const fs::path shipped = test::source_dir() / "scenes/measurements/synthetic_finger.csv";

class Fit : public testing::Test {
 protected:
  test::ShellResult fit(const std::string& words) const {
    return test::shell(test::program().string() + " fit " + words, folder);
  }
  const fs::path folder = test::scratch_dir();
};

TEST_F(Fit, TellsEachNumberAndGivesTheSameProfileEachTime) {
  const auto first = fit(shipped.string() + " --out one.toml"),
             second = fit(shipped.string() + " --out two.toml");
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("lateral_axis_m"));
  EXPECT_THAT(first.out, HasSubstr("95 %:"));
  EXPECT_THAT(first.out, testing::ContainsRegex("\nlateral_axis_m +[0-9.e-]+ +m +95 %: "));
  EXPECT_THAT(first.out, testing::ContainsRegex("\nv_min_m_per_s +[0-9.e-]+ +m/s +"));
  EXPECT_THAT(first.out, testing::ContainsRegex("\nmu_static +[0-9.e-]+ +1 +95 %: "));
  EXPECT_THAT(first.out, HasSubstr("wrote one.toml (6 trials of 2 subjects)"));
  const std::string profile = test::bytes_of(folder / "one.toml");
  EXPECT_THAT(profile, HasSubstr("[interval]"));
  EXPECT_EQ(profile, test::bytes_of(folder / "two.toml"));
}

TEST_F(Fit, SaysThatItReplacedAProfile) {
  const std::string call = shipped.string() + " --out pad.toml";
  const std::string words = "fingerpad: pad.toml: replaced the file that was there\n";
  EXPECT_THAT(fit(call).err, Not(HasSubstr(words)));
  EXPECT_THAT(fit(call).err, HasSubstr(words));
}

TEST_F(Fit, ReplayTakesTheProfile) {
  ASSERT_EQ(fit(shipped.string() + " --out finger.toml --quiet").exit_code, 0);
  std::ofstream(folder / "rub.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[friction]\nlaw = \"finger-pad\"\n[finger]\n"
         "profile = \"finger.toml\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, "
         "-0.001]\n"
         "speed_m_per_s = 0.05\nrate_hz = 1000\n";
  const auto replay = test::shell(test::program().string() + " replay rub.toml --out out", folder);
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

TEST_F(Fit, SaysWhatItDidToTheSamplesAndLeavesStepsOut) {
  const auto told = fit(shipped.string() + " --out all.toml");
  EXPECT_THAT(told.out, HasSubstr("tare: taken off 6 of 6 trials"));
  EXPECT_THAT(told.out, HasSubstr("mains hum: taken out of 6 of 6 trials"));
  EXPECT_THAT(told.out, HasSubstr("delay: force lags position by 7."));
  EXPECT_THAT(told.out, HasSubstr("the pad's law fits"));
  EXPECT_THAT(test::bytes_of(folder / "all.toml"), HasSubstr("# tare: taken off"));
  const auto raw = fit(shipped.string() + " --out raw.toml --no-tare --mains off --delay off --fill 0");
  EXPECT_EQ(raw.exit_code, 0) << raw.err;
  EXPECT_THAT(raw.out, HasSubstr("tare: left as it is (off)"));
  EXPECT_THAT(raw.out, HasSubstr("left in (off)"));
  EXPECT_EQ(fit(shipped.string() + " --out bad.toml --delay soon").exit_code, 2);
  const auto unknown = fit(shipped.string() + " --out bad.toml --columns q=Q");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("'q=Q' is no KEY=NAME"));
}

TEST_F(Fit, TakesAUnitBehindANumber) {
  const auto plain = fit(shipped.string() + " --out same.toml --delay 0.0073 --fill 15 --smoothing 80");
  for (const char* words :
       {"--delay 7.3ms --fill 15ms --smoothing 80Hz", "--delay '7.3 ms' --fill 0.015s --smoothing '0.08 kHz'",
        "--delay 7300us --fill 15000us --smoothing 80"}) {
    const auto other = fit(shipped.string() + " --out same.toml " + words);
    EXPECT_EQ(other.exit_code, 0) << words << other.err;
    EXPECT_EQ(other.out, plain.out) << words;
  }
  const std::string to_none = shipped.string() + " --out none.toml ";
  for (const auto& [words, said] : {std::pair("--delay 7",
                                              "--delay: '7' is more than a second, which no delay is; "
                                              "milliseconds are 7ms"),
                                    {"--delay 7mm", "'7mm' is no time (7ms, or 0.007 for seconds)"},
                                    {"--delay 2s", "'2s' is more than a second, which no delay is\n"},
                                    {"--fill 20mm", "'20mm' is no number, nor one of ms, us, s"},
                                    {"--smoothing 50ms", "'50ms' is no number, nor one of Hz, kHz"},
                                    {"--smoothing -5", "-5 Hz: a frequency is 0 or more"},
                                    {"--markers 12mm,8s", "'8s' is no number, nor one of mm, cm, m, in"}}) {
    const auto wrong = fit(to_none + words);
    EXPECT_EQ(wrong.exit_code, 2) << words;
    EXPECT_THAT(wrong.err, HasSubstr(said)) << words;
    EXPECT_THAT(wrong.err, testing::Not(HasSubstr("understood as"))) << words;
  }
}

TEST_F(Fit, TakesMicrosecondsAsPeopleWriteThem) {
  const auto told = [&](const char* unit) {
    return fit(shipped.string() + " --out p.toml --time-unit " + unit).err;
  };
  EXPECT_EQ(told("\u00b5s"), told("us"));
  EXPECT_EQ(told("\u03bcs"), told("us"));
  EXPECT_THAT(told("furlong"), HasSubstr("'furlong' is none of s, ms, us, ns, min"));
}

TEST_F(Fit, SaysWhatATraceAndAnUnfinishedRecordingAreTakenFor) {
  std::ofstream(folder / "rub.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind "
                                        "= \"line\"\nfrom_m = [0, 0, -0.001]\n"
                                        "to_m = [0.05, 0, -0.001]\nspeed_m_per_s = 0.05\nrate_hz = 500\n";
  for (const char* format : {"h5", "csv"}) {
    ASSERT_EQ(test::shell(test::program().string() + " replay rub.toml --out o --format " + format, folder)
                  .exit_code,
              0);
    EXPECT_THAT(fit(std::string("o/rub.") + format + " --out p.toml").err,
                HasSubstr(std::string("o/rub.") + format + ": is a trace of this program"));
  }
  std::ofstream(folder / "noted.csv") << "copied by hand\n" << std::ifstream(folder / "o/rub.csv").rdbuf();
  EXPECT_THAT(fit("noted.csv --out p.toml").err,
              HasSubstr("noted.csv: is a trace of this program below other lines: take those out"));
  fs::copy_file(folder / "o/rub.csv", folder / "live.csv.part");
  EXPECT_THAT(
      fit("live.csv.part --out p.toml").err,
      HasSubstr("warning: live.csv.part: is of a recording that was cut short or is still being written"));
  std::ofstream(folder / "begun.csv.part") << "t_s,x_m\n0,0\n";
  EXPECT_THAT(fit("begun.csv.part --out p.toml").err,
              AllOf(HasSubstr("no column"), HasSubstr("the file is of a recording that was cut short")));
}

/// Not zeroed, and pressed with less than the sensor is off by.
TEST_F(Fit, TakesAPullInTheAirForAnOffsetAndRefusesSwappedForces) {
  std::ifstream whole(shipped);
  std::ofstream off(folder / "off.csv"), swapped(folder / "swapped.csv");
  bool is_header = true;
  for (std::string line; std::getline(whole, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells;
    for (std::stringstream rest(line); std::getline(rest, line, ',');) cells.push_back(line);
    const auto joined = [&] { return fmt::format("{}\n", fmt::join(cells, ",")); };
    std::swap(cells[5], cells[6]);
    if (!is_header) swapped << joined();
    std::swap(cells[5], cells[6]);
    if (is_header) swapped << joined();
    if (!is_header) cells[6] = fmt::format("{:.3f}", std::stod(cells[6]) - 4);
    off << joined();
    is_header = false;
  }
  off.close();
  swapped.close();
  const auto zeroed = fit("off.csv --out p.toml");
  EXPECT_EQ(zeroed.exit_code, 0) << zeroed.err;
  EXPECT_THAT(zeroed.err,
              HasSubstr("warning: off.csv: its force reads -4.04 N along the plate's normal in the air"));
  EXPECT_THAT(zeroed.out, ContainsRegex("mu_dynamic +0\\.(199|200)"));
  const auto kept = fit("off.csv --no-tare --out p.toml");
  EXPECT_EQ(kept.exit_code, 3);
  EXPECT_THAT(kept.err, AllOf(HasSubstr("a sensor that was not zeroed"), Not(HasSubstr("--force-on"))));
  const auto refused = fit("swapped.csv --out none.toml");
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("two columns of force are swapped"));
  EXPECT_FALSE(fs::exists(folder / "none.toml"));
}

TEST_F(Fit, LeavesOutTrialsByNameAndTellsIt) {
  const auto told = fit(shipped.string() + " --out some.toml --leave-out 'trial 2' --leave-out 'trial 5'");
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("understood as 4 trials"));
  for (const std::string& text : {told.out, test::bytes_of(folder / "some.toml")})
    EXPECT_THAT(text, ContainsRegex("left out \\(--leave-out\\): .*, trial 2; .*, trial 5"));
  const auto none = fit(shipped.string() + " --out none.toml --leave-out 'trial 77'");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err,
              HasSubstr("--leave-out: no trial is called 'trial 77'; there are 'subject 1, trial 1'"));
}

TEST_F(Fit, TakesOneTrialInItsOwnUnit) {
  std::ofstream(folder / "third.awk")
      << "BEGIN { FS = OFS = \",\" } /^[0-9]/ && $12 == 3 { $5 *= 1000; $6 *= 1000; $7 *= 1000 } { print }\n";
  ASSERT_EQ(test::shell("awk -f third.awk " + shipped.string() + " > other.csv", folder).exit_code, 0);
  const auto plain = fit("other.csv --out plain.toml");
  EXPECT_THAT(plain.err, HasSubstr("--trial-unit 'subject 1, trial 3=UNIT'"));
  const auto mended = fit("other.csv --out mended.toml --trial-unit 'trial 3=mN'"),
             whole = fit(shipped.string() + " --out whole.toml");
  EXPECT_THAT(mended.err, Not(HasSubstr("warning")));
  EXPECT_THAT(mended.out, HasSubstr("trial 3: its forces are taken to be in mN (--trial-unit)"));
  const auto number = [](const std::string& text) {
    return text.substr(text.find("\nmu_static ")).substr(0, 40);
  };
  EXPECT_EQ(number(mended.out), number(whole.out));
}

TEST_F(Fit, SaysWhichShareIsLight) {
  const auto far = fit(shipped.string() + " --out none.toml --light 95");
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_THAT(far.err, HasSubstr("--light: '95' is out of range; 0 to 90 % is asked for"));
  EXPECT_THAT(fit(shipped.string() + " --out none.toml --light 25mN").err,
              HasSubstr("--light: '25mN' is no number, nor one of %"));
}

TEST_F(Fit, TakesNoColumnThatItReadsForAMisspeltOne) {
  ASSERT_EQ(test::shell("sed 's/,fz_n,/,Fz,/' " + shipped.string() + " > other.csv", folder).exit_code, 0);
  const auto named = fit("other.csv --out none.toml --columns fx=fx_n,fy=fy_n,fz=fz_n");
  EXPECT_EQ(named.exit_code, 3);
  EXPECT_THAT(named.err, HasSubstr("no column 'fz_n'; its header must name"));
  const auto plain = fit("other.csv --out none.toml");
  EXPECT_EQ(plain.exit_code, 3);
  EXPECT_THAT(plain.err, HasSubstr("column fz_n missing (it has, and nothing reads: Fz); where it is called "
                                   "otherwise, say --columns fz=NAME\n"));
}

TEST_F(Fit, ReadsOtherColumnsAndUnits) {
  // Metres as millimetres, seconds as milliseconds, forces as those on the plate.
  std::ofstream(folder / "convert.awk")
      << "BEGIN { FS = \",\"; OFS = \";\" } /^#/ { next } /^t_s/ { print "
         "\"ms;X;Y;Z;A;B;C;dx;dy;dz;subject;trial\"; next }\n"
         "{ print 1000 * $1, 1000 * $2, 1000 * $3, 1000 * $4, -$5, -$6, -$7, $8, $9, $10, $11, $12 }\n";
  ASSERT_EQ(test::shell("awk -f convert.awk " + shipped.string() + " > other.csv", folder).exit_code, 0);
  ASSERT_EQ(fit(shipped.string() + " --quiet --out one.toml").exit_code, 0);
  const auto other =
      fit("other.csv --quiet --out two.toml --unit mm --time-unit ms --force-on plate --columns "
          "t=ms,x=X,y=Y,z=Z,fx=A,fy=B,fz=C");
  EXPECT_EQ(other.exit_code, 0) << other.err;
  const auto number = [&](const char* file) {
    const std::string text = test::bytes_of(folder / file);
    return std::stod(text.substr(text.find("\nmu_static = ") + 13));
  };
  EXPECT_NEAR(number("one.toml"), number("two.toml"), 1e-9);
}

TEST_F(Fit, AsksWhereATableIsDoubtful) {
  std::ofstream(folder / "turn.awk")
      << "BEGIN { FS = OFS = \",\" } /^[0-9]/ { $5 = -$5; $6 = -$6 } { print }\n";
  ASSERT_EQ(test::shell("awk -f turn.awk " + shipped.string() + " > turned.csv", folder).exit_code, 0);
  const auto turned = fit("turned.csv --out none.toml");
  EXPECT_EQ(turned.exit_code, 3);
  EXPECT_THAT(turned.err, HasSubstr("turned.csv: its force drives the finger along its way"));
  EXPECT_EQ(fit("turned.csv --out mended.toml --quiet --sensor-turned 0,0,0,1").exit_code, 0);
  const auto unread = fit(shipped.string() + " --out none.toml --torque-unit N.mm");
  EXPECT_EQ(unread.exit_code, 2);
  EXPECT_THAT(unread.err, HasSubstr("--torque-unit: is read with --sensor-at"));
  const auto unnamed = fit(shipped.string() + " --out none.toml --reader sens3 --torque-unit N.mm");
  EXPECT_EQ(unnamed.exit_code, 2);
  EXPECT_THAT(unnamed.err, HasSubstr("--torque-unit: no torque is named: name tx, ty and tz"));
}

TEST_F(Fit, SaysWhatItUnderstoodAndWarnsOfAUnitThatIsNoFingers) {
  const auto told = fit(shipped.string() + " --out a.toml");
  EXPECT_THAT(told.err,
              HasSubstr("understood as 6 trials of 2 subjects, 2.1 s each at 1000 samples a second"));
  EXPECT_THAT(told.err, HasSubstr("m/s; forces up to"));
  EXPECT_THAT(told.err, testing::Not(HasSubstr("warning")));
  EXPECT_EQ(fit(shipped.string() + " --quiet --out a.toml").err, "");
  std::ofstream(folder / "mm.awk")
      << "BEGIN { FS = OFS = \",\" } /^[0-9]/ { for (k = 2; k < 5; ++k) $k *= 1000 } { print }\n";
  ASSERT_EQ(test::shell("awk -f mm.awk " + shipped.string() + " > mm.csv", folder).exit_code, 0);
  const auto centimetres = fit("mm.csv --unit cm --out a.toml");
  EXPECT_EQ(centimetres.exit_code, 0);
  EXPECT_THAT(centimetres.err, HasSubstr("warning: mm.csv: its positions reach over 5"));
  const auto microseconds = fit(shipped.string() + " --time-unit ms --out a.toml");
  EXPECT_THAT(microseconds.err, HasSubstr("1000000 samples a second, at which no finger is measured"));
}

TEST_F(Fit, OneTrialEndsWithWhatItLacksForAScene) {
  std::ofstream(folder / "one.awk") << "BEGIN { FS = \",\" } /^t_s/ || $12 == 1 { print }\n";
  ASSERT_EQ(test::shell("awk -f one.awk " + shipped.string() +
                            " > one.csv && cut -d, -f1-7 one.csv > "
                            "plain.csv",
                        folder)
                .exit_code,
            0);
  const auto steep = fit("one.csv --out one.toml --report report");
  EXPECT_EQ(steep.exit_code, 0);
  EXPECT_THAT(steep.err,
              HasSubstr("warning: no scene takes this profile: it lacks lateral_axis_m (one finger "
                        "angle only"));
  EXPECT_THAT(steep.err, HasSubstr("add a trial with the finger at about 45 degrees"));
  EXPECT_THAT(steep.err, HasSubstr("0.3016 as mu_static of a part or plane"));
  EXPECT_THAT(test::bytes_of(folder / "one.toml"), HasSubstr("# no scene takes this profile"));
  EXPECT_THAT(test::bytes_of(folder / "report/report.html"), HasSubstr("no scene takes this profile"));
  EXPECT_THAT(fit("plain.csv --quiet --out plain.toml").err,
              HasSubstr("give the finger's direction in the columns dx, dy, dz"));
  EXPECT_THAT(fit(shipped.string() + " --out whole.toml").err, testing::Not(HasSubstr("no scene takes")));
}

TEST_F(Fit, OverwritesNoneOfItsInputs) {
  fs::create_directory(folder / "r");
  for (const char* name : {"a", "r/numbers.csv"}) fs::copy_file(shipped, folder / name);
  const std::string before = test::bytes_of(shipped);
  for (const std::string& words : {std::string("a --out a"), shipped.string() + " a --out a",
                                   shipped.string() + " --positions a --out ./a",
                                   std::string("r/numbers.csv --out b.toml --report r")}) {
    const auto result = fit(words);
    EXPECT_EQ(result.exit_code, 3) << words;
    EXPECT_THAT(result.err, HasSubstr("an input of this command")) << words;
    for (const char* name : {"a", "r/numbers.csv"}) EXPECT_EQ(test::bytes_of(folder / name), before) << words;
  }
}

/// A press and release again and again, whose normal force alone is told, in columns of a table.
std::string pressed_table(double yields_m) {
  std::string table = "t_s,x_m,y_m,z_m,fz_n,trial\n";
  for (int trial = 0; trial < 4; ++trial) {
    for (int i = 0; i < 3000; ++i) {
      const double t = 1e-3 * i, load_n = 1 + 0.6 * std::sin((4 + 0.2 * trial) * t);
      table += fmt::format("{:.3f},{:.6f},0,{:.7f},{:.4f},{}\n", t, 0.01 * t, -yields_m * std::sqrt(load_n),
                           load_n, trial);
    }
  }
  return table;
}

TEST_F(Fit, GivesTheNormalLawOfANormalForceAlone) {
  std::ofstream(folder / "pressed.csv") << pressed_table(1.5e-3);
  const auto pressed = fit("pressed.csv --out pressed.toml --report pressed");
  EXPECT_EQ(pressed.exit_code, 0) << pressed.err;
  EXPECT_THAT(pressed.out, ContainsRegex("normal_exponent +(2|1\\.99|2\\.0)"));
  EXPECT_THAT(pressed.out,
              HasSubstr("lateral_axis_m                 refused: pressed.csv: column fx_n missing; so for 17 "
                        "more: longitudinal_axis_m, "));
  EXPECT_THAT(pressed.out, HasSubstr("wrote pressed.toml (4 trials of 1 subject)"));
  EXPECT_THAT(pressed.err,
              HasSubstr("pressed.csv: column fx_n missing: its normal force tells the pad's normal "
                        "law alone, and nothing of friction; where they are called otherwise, say "
                        "--columns fx=NAME,fy=NAME"));
  EXPECT_THAT(pressed.out + pressed.err, Not(HasSubstr("law does not fit")));
  const std::string profile = test::bytes_of(folder / "pressed.toml"),
                    page = test::bytes_of(folder / "pressed/report.html");
  EXPECT_THAT(profile, HasSubstr("\nnormal_stiffness_n_per_m = "));
  EXPECT_THAT(profile, HasSubstr("v_min_m_per_s = \"pressed.csv: column fx_n missing\""));
  EXPECT_THAT(profile, HasSubstr("To have it, measure the force along the plate too, as fx_n and fy_n"));
  EXPECT_THAT(page, HasSubstr("normal law alone, and nothing of friction"));
  EXPECT_THAT(page,
              HasSubstr("<td>mu_dynamic</td><td colspan=\"5\">refused: pressed.csv: column fx_n missing"));
  EXPECT_THAT(page, HasSubstr("<li>figures 3 to 11: pressed.csv: column fx_n missing</li>"));
  const auto both = fit(shipped.string() + " pressed.csv --out both.toml");
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_THAT(both.err, HasSubstr("nothing of friction"));
  EXPECT_THAT(both.out,
              AllOf(ContainsRegex("normal_exponent .* 10 trials"), ContainsRegex("mu_dynamic .* 6 trials")));
  std::ofstream(folder / "rail.csv") << pressed_table(0);
  const auto rail = fit("rail.csv --out none.toml");
  EXPECT_EQ(rail.exit_code, 3);
  EXPECT_THAT(rail.err, HasSubstr("error: rail.csv: nothing can be fitted: column fx_n missing; "
                                  "normal_stiffness_n_per_m: no press is found"));
  EXPECT_FALSE(fs::exists(folder / "none.toml"));
}

TEST_F(Fit, RefusesATextThatIsCalledHdf5AsReplayDoes) {
  fs::copy_file(shipped, folder / "text.h5");
  const auto text = fit("text.h5 --out none.toml");
  EXPECT_EQ(text.exit_code, 3);
  EXPECT_THAT(text.err, HasSubstr("text.h5: is no HDF5 file, as its name says"));
  EXPECT_FALSE(fs::exists(folder / "none.toml"));
#ifdef FINGERPAD_VIEW
  const auto plot = test::shell(test::program().string() + " plot text.h5 --out p.svg", folder);
  EXPECT_EQ(plot.exit_code, 3);
  EXPECT_THAT(plot.err, HasSubstr("text.h5: is no HDF5 file, as its name says"));
#endif
}

TEST_F(Fit, SaysWhyATableCannotBeRead) {
  std::ofstream(folder / "texture.xml") << "<?xml version=\"1.0\"?>\n<Data><A>1</A></Data>\n";
  EXPECT_THAT(fit("texture.xml --out none.toml").err,
              AllOf(HasSubstr("is XML and no table"), HasSubstr("--reader hatt")));
  const auto times = [&](const char* second, const char* trial) {
    std::ofstream(folder / "times.csv")
        << fmt::format("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n{0}\n0.5,0,0,0,0,0,1{1}\n{2},0,0,0,0,0,1{1}\n",
                       *trial == 0 ? "" : ",trial", trial, second);
    return fit("times.csv --out none.toml").err;
  };
  EXPECT_THAT(times("0.5", ""), AllOf(HasSubstr("times.csv:3: its time 0.5 s is the time of the row before"),
                                      HasSubstr("leave out rows that are there twice")));
  EXPECT_THAT(times("0.5", ""), Not(HasSubstr("column 'trial'")));
  std::ofstream(folder / "epoch.csv") << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n1700000000.125,0,0,0,0,0,1\n"
                                         "1700000000.123,0,0,0,0,0,1\n";
  EXPECT_THAT(fit("epoch.csv --out none.toml").err,
              HasSubstr("its time 1700000000.123 s comes before 1700000000.125 s"));
  EXPECT_THAT(times("0.25", ""), AllOf(HasSubstr("its time 0.25 s comes before 0.5 s"),
                                       HasSubstr("number the trials in a column 'trial'")));
  EXPECT_THAT(times("0.25", ",7"),
              AllOf(HasSubstr("of the same trial: put the rows in order"), Not(HasSubstr("column 'trial'"))));
}

TEST_F(Fit, TakesASeparatorAsItIs) {
  ASSERT_EQ(test::shell("tr , ';' < " + shipped.string() + " > semicolons.csv", folder).exit_code, 0);
  for (const char* words : {"';'", "semicolon"})
    EXPECT_EQ(fit(fmt::format("semicolons.csv --quiet --out a.toml --separator {}", words)).exit_code, 0)
        << words;
  EXPECT_THAT(fit("semicolons.csv --out a.toml --separator '!'").err, HasSubstr("semicolon"));
}

TEST_F(Fit, RefusesWhatHoldsNothingForIt) {
  std::ofstream(folder / "normal_only.csv")
      << "t_s,x_m,y_m,z_m,fz_n\n0,0,0,0,1\n0.001,0,0,0,1\n0.002,0,0,0,1\n";
  const auto normal_only = fit("normal_only.csv --out none.toml");
  EXPECT_EQ(normal_only.exit_code, 3);
  EXPECT_THAT(normal_only.err,
              HasSubstr("error: normal_only.csv: nothing can be fitted: column fx_n missing"));
  EXPECT_THAT(normal_only.err, HasSubstr("where they are called otherwise, say --columns fx=NAME,fy=NAME\n"));
  EXPECT_FALSE(fs::exists(folder / "none.toml"));
  const auto both = fit("normal_only.csv " + shipped.string() + " --out both.toml");
  EXPECT_EQ(both.exit_code, 0);
  EXPECT_THAT(both.err, HasSubstr("normal_only.csv: column fx_n missing; the file is left out"));
  std::ofstream still(folder / "still.csv");
  still << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
  for (int i = 0; i < 400; ++i) still << 0.001 * i << ",0,0,0,0,0,1\n";
  still.close();
  const auto motionless = fit("still.csv --out none.toml");
  EXPECT_EQ(motionless.exit_code, 3);
  EXPECT_THAT(motionless.err,
              HasSubstr("error: still.csv: nothing can be fitted: mu_dynamic: no slip was found"));
  std::ofstream drawn(folder / "drawn.csv");
  drawn << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,tx_n_m,ty_n_m,tz_n_m\n";
  for (int i = 0; i < 400; ++i) drawn << 0.001 * i << ',' << 2e-5 * i << ",0,0,0,0,1,0,0,0\n";
  drawn.close();
  const auto tracked = fit("drawn.csv --out none.toml --sensor-at 0,0,0");
  EXPECT_EQ(tracked.exit_code, 3);
  EXPECT_THAT(tracked.err,
              AllOf(HasSubstr("nothing can be fitted"),
                    HasSubstr("contact points: passed over in 1 trial whose finger is tracked")));
  EXPECT_EQ(fit("absent.csv --out none.toml").exit_code, 3);
  EXPECT_EQ(fit(shipped.string() + " --out no/such/folder.toml").exit_code, 2);
}

}  // namespace
}  // namespace fingerpad::fit_test
