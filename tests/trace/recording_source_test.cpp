// Motions of a laboratory, as a scene asks for them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "scene/scene_file.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "touch/closed_loop.hpp"
#include "trace/motion_source.hpp"
#include "trace_rows.hpp"

namespace fingerpad::recording_source_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_with(const std::string& motion) {
  return read_scene_text("[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\n" + motion,
                         (test::scratch_dir() / "s.toml").string())
      .scene;
}

/// Written into the scratch folder, which scene_with empties: so it stands after it.
void write_recording(long samples, double rate_hz, const std::string& header = "t_s,x_m,y_m,z_m",
                     double step_m = 1e-5) {
  std::ofstream file(test::scratch_dir() / "m.csv");
  file << header << "\n";
  for (long i = 0; i < samples; ++i)
    file << fmt::format("{:.6f},{:.6f},0,0.001\n", static_cast<double>(i) / rate_hz,
                        step_m * static_cast<double>(i));
}

LoadedMotion loaded(const std::string& motion, long samples = 500, double rate_hz = 240,
                    double step_m = 1e-5) {
  const Scene scene = scene_with("file = \"m.csv\"\n" + motion);
  write_recording(samples, rate_hz, "t_s,x_m,y_m,z_m", step_m);
  return load_motion(scene);
}

TEST(RecordingSource, FollowsAFileAtItsOwnRateAndSaysSo) {
  const LoadedMotion motion = loaded("");
  EXPECT_EQ(motion.path.rate_hz(), 240);
  EXPECT_EQ(motion.path.tick_count(), 500);
  EXPECT_THAT(motion.notes, ElementsAre(HasSubstr("m.csv: no rate_hz: ticks at the file's own 240 Hz (")));
  EXPECT_THAT(motion.warnings, IsEmpty());
  EXPECT_EQ(at_rate(scene_with("file = \"m.csv\"\n"), motion.path).motion.rate_hz, 240);
}

TEST(RecordingSource, AUnitThatAColumnsNameContradictsIsTakenAndTold) {
  const auto warnings = [](const std::string& header, const std::string& units) {
    const Scene scene =
        scene_with("file = \"m.csv\"\ncolumns = { t = \"" + header.substr(0, header.find(',')) +
                   "\", x = \"X [mm]\", y = \"Y\", z = \"Z\" }\n" + units);
    write_recording(500, 240, header);
    return load_motion(scene).warnings;
  };
  EXPECT_THAT(warnings("time [s],X [mm],Y,Z", "unit = \"mm\"\n"), IsEmpty());
  EXPECT_THAT(
      warnings("time [s],X [mm],Y,Z", "unit = \"cm\"\n"),
      ElementsAre(HasSubstr("its column 'X [mm]' says by its name another unit than unit in [motion]")));
  EXPECT_THAT(
      warnings("time [ms],X [mm],Y,Z", "unit = \"mm\"\ntime_unit = \"s\"\n"),
      testing::Contains(HasSubstr("its column 'time [ms]' says by its name another unit than time_unit")));
}

TEST(RecordingSource, PositionsMayBeInMicrometres) {
  const LoadedMotion motion = loaded("unit = \"um\"\n", 500, 250, 10);
  EXPECT_NEAR(motion.path.at(100).p_WQ.x(), 1e-3, 1e-12);
}

TEST(RecordingSource, AFingerThatGoesFasterThanAnyIsToldWhateverUnitIsSaid) {
  EXPECT_THAT(loaded("time_unit = \"ms\"\nrate_hz = 1000\n", 100, 1, 0.1).warnings,
              ElementsAre(HasSubstr("its finger goes at 100 m/s on average, as none does")));
  EXPECT_THAT(loaded("time_unit = \"ms\"\nrate_hz = 1000\n", 100, 1, 1e-3).warnings, IsEmpty());
}

TEST(RecordingSource, ColumnsThatHoldAnOrientationUnderOtherNamesAreToldAsNotRead) {
  const auto notes = [](const std::string& more) {
    const Scene scene = scene_with("file = \"m.csv\"\nrate_hz = 10\n");
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m," << more << "\n";
    for (int i = 0; i < 30; ++i) file << fmt::format("{},{:.6f},0,0.001,1,0,0,0\n", i / 10.0, 1e-5 * i);
    file.close();
    return load_motion(scene).notes;
  };
  EXPECT_THAT(notes("q0,q1,q2,q3"), ElementsAre(HasSubstr("q0, q1, q2, q3 are not read: an orientation")));
  EXPECT_THAT(notes("a,b,Roll [deg],quiet"), ElementsAre(HasSubstr("Roll [deg] is not read")));
  EXPECT_THAT(notes("qw,qx,qy,qz"), IsEmpty());
  EXPECT_THAT(notes("a,b,rolled_qw,quiet"), IsEmpty());
}

TEST(RecordingSource, ANameThatSaysAUnitIsAskedForItHoweverItIsWritten) {
  const auto told = [](const std::string& x) {
    const Scene scene = scene_with("file = \"m.csv\"\ncolumns = { x = '" + x + "' }\n");
    write_recording(500, 240, "t_s,\"" + x + "\",y_m,z_m");
    return test::why_not([&] { load_motion(scene); });
  };
  for (const char* x : {"x/mm", "X [mm]", "X, mm", "X mm"}) {
    EXPECT_THAT(told(x),
                HasSubstr("whose name says a unit that is not said: say unit in [motion], \"mm\" if it "
                          "is right"))
        << x;
  }
  EXPECT_THAT(told("X (\u00b5m)"), HasSubstr("\"um\" if it is right"));
  EXPECT_THAT(told("X (ft)"),
              HasSubstr("says the unit 'ft', and of a length these are known: m, mm, cm, in, um"));
  for (const char* x : {"x/m", "X", "X (raw data)", "pos x"}) EXPECT_EQ(told(x), "taken") << x;
}

TEST(RecordingSource, RowsOfSeveralTrialsAreNotTakenForOneMotionUntold) {
  const auto notes = [](const std::string& more) {
    const Scene scene = scene_with("file = \"m.csv\"\nrate_hz = 10\n" + more);
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m,trial,Subject\n";
    for (int i = 0; i < 30; ++i) file << fmt::format("{},{:.6f},0,0.001,1,1\n", i / 10.0, 1e-5 * i);
    file.close();
    return load_motion(scene).notes;
  };
  const auto not_read = [](const std::string& name) {
    return HasSubstr("the column '" + name + "' is not read: its rows of all numbers are one motion");
  };
  EXPECT_THAT(notes(""), ElementsAre(not_read("trial"), not_read("Subject")));
  EXPECT_THAT(notes("trial = 1\n"), ElementsAre(not_read("Subject")));
  EXPECT_THAT(notes("trial = 1\nsubject = 1\ncolumns = { subject = \"Subject\" }\n"),
              ElementsAre("m.csv: subject is 'Subject'"));
}

TEST(RecordingSource, RowsWhereATrackerLostItsMarkerAreTold) {
  const auto warnings = [](int lost) {
    const Scene scene = scene_with("file = \"m.csv\"\nrate_hz = 200\n");
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m\n";
    for (int i = 0; i < 400; ++i)
      file << (i >= 200 && i < 200 + lost ? fmt::format("{},0,0,0\n", i / 200.0)
                                          : fmt::format("{},{:.6f},0,0.001\n", i / 200.0, 0.05 + 1e-4 * i));
    file.close();
    return load_motion(scene).warnings;
  };
  EXPECT_THAT(warnings(0), IsEmpty());
  EXPECT_THAT(warnings(4),
              ElementsAre(HasSubstr("its finger leaps by 69.9 mm within 5 ms at t = 1 s, and at 1 "
                                    "more of its steps: are rows wrong there")));
}

TEST(RecordingSource, ATraceBelowOtherLinesIsNotTakenForARecording) {
  const Scene scene = scene_with("file = \"m.csv\"\n");
  std::string header = "copied by hand\n", row;
  for (const TraceColumn& column : trace_columns()) {
    header += std::string(column.name) + ",";
    row += column.name == "dx" || column.name == "qw" ? "1," : "0,";
  }
  std::ofstream(test::scratch_dir() / "m.csv") << header << "\n" << row << "\n";
  EXPECT_THAT(test::why_not([&] { load_motion(scene); }),
              HasSubstr("is a trace of this program below other lines"));
}

TEST(RecordingSource, ATimeThatStandsTwiceIsToldOtherwiseThanRowsThatAreNotSorted) {
  const auto told = [](const char* rows) {
    const Scene scene = scene_with("file = \"m.csv\"\n");
    std::ofstream(test::scratch_dir() / "m.csv") << "t_s,x_m,y_m,z_m\n" << rows;
    return test::why_not([&] { load_motion(scene); });
  };
  EXPECT_THAT(told("0,0,0,0\n0.1,0,0,0\n0.1,0,0,0\n"),
              HasSubstr("m.csv:4: time 0.1 s does not come after 0.1 s; leave one of the two rows out"));
  EXPECT_THAT(told("0,0,0,0\n0.1,0,0,0\n0.05,0,0,0\n"),
              HasSubstr("m.csv:4: time 0.05 s does not come after 0.1 s; sort the rows by time"));
}

TEST(RecordingSource, ARateThatIsWrittenStandsAndNeedsNoWords) {
  const LoadedMotion motion = loaded("rate_hz = 1000\n");
  EXPECT_EQ(motion.path.rate_hz(), 1000);
  EXPECT_THAT(motion.notes, IsEmpty());
}

TEST(RecordingSource, AFileOfFewSamplesIsToldWhatElseThereIs) {
  EXPECT_THAT(loaded("", 20, 20).notes,
              ElementsAre(HasSubstr("20 Hz (19 even steps), few for friction; with rate_hz = 1000")));
}

TEST(RecordingSource, OneSampleHasNoRateOfItsOwn) {
  EXPECT_EQ(loaded("", 1).path.rate_hz(), 1000);
}

TEST(RecordingSource, ARateBeyondAllTicksIsRefused) {
  EXPECT_THAT(test::why_not([] { loaded("", 5, 0.5); }),
              AllOf(HasSubstr("m.csv: its own rate is 0.5 Hz"), HasSubstr("give rate_hz"),
                    HasSubstr("say time_unit")));
  EXPECT_EQ(loaded("rate_hz = 100\n", 5, 0.5).path.tick_count(), 801);
  EXPECT_THAT(test::why_not([] { loaded("time_unit = \"us\"\n", 50, 240); }),
              HasSubstr("ticks go at 1 to 1000000 Hz"));
}

TEST(RecordingSource, WarnsOfAnIrregularClockWhereThatDecides) {
  const std::string rows = "t_s,x_m,y_m,z_m\n0,0,0,0\n0.01,0,0,0\n0.02,0,0,0\n0.07,0,0,0\n0.08,0,0,0\n";
  const Scene own = scene_with("file = \"m.csv\"\n");
  Scene given = own;
  given.motion.rate_given = true;
  std::ofstream(test::scratch_dir() / "m.csv") << rows;
  EXPECT_THAT(
      load_motion(own).warnings,
      ElementsAre("m.csv: its clock is irregular: 1 of 4 steps are off by more than half, the longest is "
                  "50 ms at t = 0.02 s; in between the finger goes straight"));
  EXPECT_THAT(load_motion(given).warnings, IsEmpty());
}

TEST(RecordingSource, SuspectsTimesThatWereReadAsSeconds) {
  // A kilohertz in ms, and in us, as its user forgot to say: a step of 10 um is 10 mm/s in truth.
  EXPECT_THAT(
      loaded("rate_hz = 1000\n", 100, 1).warnings,
      ElementsAre("m.csv: its samples are 1 s apart, 99 s in all, if its time is in seconds; time_unit "
                  "= \"ms\" in [motion] makes it 1000 Hz and 0.099 s (time_unit = \"s\" if it is "
                  "right)"));
  EXPECT_THAT(loaded("rate_hz = 1000\n", 25, 1e-3).warnings, ElementsAre(HasSubstr("time_unit = \"us\"")));
  EXPECT_THAT(loaded("time_unit = \"s\"\nrate_hz = 1000\n", 100, 1).warnings, IsEmpty()) << "it is said";
  EXPECT_THAT(loaded("time_unit = \"ms\"\n", 100, 1).warnings, IsEmpty());
  EXPECT_THAT(loaded("rate_hz = 1000\n", 15, 1).warnings, IsEmpty()) << "written by hand";
  EXPECT_THAT(loaded("rate_hz = 1000\n", 100, 12).warnings, IsEmpty()) << "a slow recorder";
  // Some four hundred a second at 0.08 m/s, in minutes.
  EXPECT_THAT(loaded("rate_hz = 1000\n", 100, 25000, 2e-4).warnings,
              ElementsAre(HasSubstr("time_unit = \"min\" in [motion] makes it 0.0833 m/s and 416.7 Hz")));
  EXPECT_THAT(loaded("rate_hz = 1000\ntime_unit = \"min\"\n", 100, 25000, 2e-4).warnings, IsEmpty());
  EXPECT_THAT(loaded("rate_hz = 1000\n", 100, 25000, 2e-5).warnings, IsEmpty()) << "a quick recorder";
  // In steps of 100 mm a finger in ms would go at 100 m/s.
  EXPECT_THAT(loaded("rate_hz = 10\n", 30, 1, 0.1).warnings, IsEmpty());
}

TEST(RecordingSource, ALineOfUnitsSaysWhatItsTimesAreIn) {
  const Scene scene = scene_with("file = \"m.csv\"\nrate_hz = 10\n");
  for (const auto& [unit, warnings] : {std::pair{"s", 0u}, {"", 1u}}) {
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m\n" << unit << ",m,m,m\n";
    for (int i = 0; i < 30; ++i) file << fmt::format("{},{:.6f},0,0.001\n", i, 1e-5 * i);
    file.close();
    EXPECT_EQ(load_motion(scene).warnings.size(), warnings) << unit;
  }
}

TEST(RecordingSource, TellsWhatSmoothingDid) {
  const LoadedMotion motion = loaded("smoothing_hz = 20\n");
  ASSERT_EQ(motion.notes.size(), 2u);
  EXPECT_THAT(motion.notes[1], AllOf(HasSubstr("smoothed without delay"), HasSubstr("20 Hz is halved"),
                                     HasSubstr("mm RMS, at most")));
  EXPECT_EQ(motion.path.tick_count(), 500);
  EXPECT_LT((motion.path.at(250).p_WQ - Vec3(2.5e-3, 0, 1e-3)).norm(), 1e-8) << "a steady motion stays";
  EXPECT_THAT(test::why_not([] { loaded("smoothing_hz = 120\n"); }),
              AllOf(HasSubstr("s.toml: 'smoothing_hz' in [motion] is 120"),
                    HasSubstr("must be below half of the 240 Hz")));
  EXPECT_EQ(loaded("smoothing_hz = 119\n").path.tick_count(), 500);
}

TEST(RecordingSource, AnEncoderGivesTheFingerItsVelocity) {
  const LoadedMotion motion = loaded("encoder_m = 1e-3\n");
  ASSERT_TRUE(motion.path.at(300).velocity_W.has_value());
  EXPECT_NEAR(motion.path.at(300).velocity_W->x(), 2.4e-3, 1e-7);  // its times are rounded to 1 us
  EXPECT_THAT(motion.notes.back(), HasSubstr("adaptive window over positions rounded to 1 mm, at 240 Hz"));
  EXPECT_FALSE(loaded("").path.at(300).velocity_W.has_value());
}

TEST(RecordingSource, SaysHowATableWasRead) {
  const Scene scene = scene_with(
      "file = \"m.csv\"\ncolumns = { t = \"time\", x = \"X\" }\nunit = \"cm\"\ntime_unit = \"ms\"\n"
      "decimal = \",\"\nrate_hz = 1000\n");
  std::ofstream(test::scratch_dir() / "m.csv") << "time;X;y_m;z_m\n0;1;2;3\n5,5;1,5;2;3\n";
  const LoadedMotion motion = load_motion(scene);
  EXPECT_THAT(
      motion.notes,
      ElementsAre("m.csv: t is 'time', x is 'X'; cells parted by ';'; decimal mark ','; positions in cm; "
                  "times in ms"));
  EXPECT_NEAR(motion.path.at(5).p_WQ.x(), 0.01 + 0.005 * 5 / 5.5, 1e-15);
}

TEST(RecordingSource, TakesMicrosecondsAsPeopleWriteThem) {
  for (const char* micro : {"us", "\u00b5s", "\u03bcs"}) {
    const Scene scene = scene_with(std::string("file = \"m.csv\"\ntime_unit = \"") + micro + "\"\n");
    EXPECT_EQ(scene.motion.format.seconds_per_unit, 1e-6) << micro;
  }
  EXPECT_THAT(test::why_not([] { scene_with("file = \"m.csv\"\ntime_unit = \"uss\"\n"); }),
              AllOf(HasSubstr("unknown time_unit 'uss'"), HasSubstr("did you mean 'us'?")));
}

TEST(RecordingSource, ATraceSaysItselfWhatItHolds) {
  for (const char* key : {"unit = \"m\"", "columns = { t = \"t_s\" }", "separator = \",\"", "decimal = \".\"",
                          "time_unit = \"s\"", "force_unit = \"N\""}) {
    const Scene scene = scene_with(std::string("file = \"t.h5\"\n") + key + "\n");
    test::write_trace(test::scratch_dir() / "t.h5", TraceFormat::hdf5, test::some_rows(20));
    EXPECT_THAT(test::why_not([&] { load_motion(scene); }),
                AllOf(HasSubstr("s.toml: '" + std::string(key).substr(0, std::string(key).find(' '))),
                      HasSubstr("t.h5 is a trace"), HasSubstr("leave the key out")));
  }
}

TEST(RecordingSource, ATraceHasARateAndNormalForcesToo) {
  const Scene scene = scene_with("file = \"t.h5\"\nnormal_force = \"measured\"\n");
  auto rows = test::some_rows(50);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].normal_force_n = 0.1 * static_cast<double>(i);
  test::write_trace(test::scratch_dir() / "t.h5", TraceFormat::hdf5, rows);
  const LoadedMotion motion = load_motion(scene);
  EXPECT_EQ(motion.path.rate_hz(), 1000);
  ASSERT_EQ(motion.path.tick_count(), 50);
  EXPECT_NEAR(motion.path.at(30).normal_force_n.value(), 3, 1e-9);
}

TEST(RecordingSource, NamesTheKeyOfANormalForceThatIsCalledOtherwise) {
  const Scene scene = scene_with("file = \"m.csv\"\nnormal_force = \"measured\"\n");
  std::ofstream(test::scratch_dir() / "m.csv") << "t_s,x_m,y_m,z_m,press\n0,0,0,0,1\n0.01,0,0,0,1\n";
  EXPECT_THAT(
      test::why_not([&] { load_motion(scene); }),
      AllOf(HasSubstr("no column 'fn_n'"), HasSubstr("fn = \"press\" }, whose fn is the normal force")));
}

TEST(RecordingSource, WarnsOfForcesThatPressNothing) {
  const Scene scene = scene_with("file = \"m.csv\"\nnormal_force = \"measured\"\nrate_hz = 100\n");
  const auto warnings = [&](const std::string& forces) {
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m,fn_n\n";
    std::istringstream each(forces);
    int row = 0;
    for (std::string force; each >> force;) file << fmt::format("{},0,0,0,{}\n", row++, force);
    file.close();
    return load_motion(scene).warnings;
  };
  // What a plate feels, whose noise is above 0 now and then.
  EXPECT_THAT(warnings("0.02 -1 -1.5 -1.2 0.01"),
              ElementsAre(AllOf(HasSubstr("m.csv: its measured normal force is -1.2 N where it presses"),
                                HasSubstr("the finger feels no force"), HasSubstr("force_on = \"plate\""))));
  EXPECT_THAT(warnings("0 0 0"), ElementsAre(HasSubstr("is 0 throughout")));
  EXPECT_THAT(warnings("-0.02 1 1.5 -0.01"), IsEmpty());
}

TEST(RecordingSource, WarnsOfAForceThatDrivesTheFingerOrIsTooHard) {
  const auto warnings = [](double fx_n, double fz_n) {
    const Scene scene = scene_with(
        "file = \"m.csv\"\nnormal_force = \"measured\"\n"
        "columns = { fx = \"fx_n\", fy = \"fy_n\", fz = \"fz_n\", fn = \"fz_n\" }\n");
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
    for (int i = 0; i < 100; ++i) file << fmt::format("{},{},0,0,{},0,{}\n", 0.01 * i, 1e-4 * i, fx_n, fz_n);
    file.close();
    return load_motion(scene).warnings;
  };
  EXPECT_THAT(warnings(-0.3, 1), IsEmpty());
  EXPECT_THAT(warnings(0.3, 1), ElementsAre(HasSubstr("drives the finger along its way")));
  EXPECT_THAT(warnings(-30, 100), ElementsAre(HasSubstr("its measured normal force is 100 N")));
}

TEST(RecordingSource, ADrivingForceIsNotToldToTurnWhatIsTurnedAlready) {
  const auto warnings = [](double fx_n, const std::string& keys) {
    const Scene scene =
        scene_with("file = \"m.csv\"\ncolumns = { fx = \"fx_n\", fy = \"fy_n\", fz = \"fz_n\" }\n" + keys);
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
    for (int i = 0; i < 100; ++i) file << fmt::format("{},{},0,0,{},0,1\n", 0.01 * i, 1e-4 * i, fx_n);
    file.close();
    return load_motion(scene).warnings;
  };
  const auto turns = HasSubstr("that on the surface (force_on = \"plate\")?");
  EXPECT_THAT(warnings(0.3, ""), ElementsAre(turns));
  EXPECT_THAT(warnings(-0.3, "force_on = \"plate\"\n"),
              ElementsAre(AllOf(HasSubstr("drives the finger"), testing::Not(turns),
                                HasSubstr("was it that on the finger already?"))));
}

/// A sensor in mN. Forces that are only compared with the model's are asked about too.
TEST(RecordingSource, AsksForTheUnitOfForcesThatNoFingerRubsWith) {
  const auto warnings = [](const std::string& keys, double normal, const std::string& units = "") {
    const Scene scene = scene_with(
        "file = \"m.csv\"\ncolumns = { fx = \"fx_n\", fy = \"fy_n\", fz = \"fz_n\", fn = \"fz_n\" }\n" +
        keys);
    std::ofstream file(test::scratch_dir() / "m.csv");
    file << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n" << units;
    for (int i = 0; i < 100; ++i)
      file << fmt::format("{},{},0,0,{},0,{}\n", 0.01 * i, 1e-4 * i, -0.75 * normal, normal);
    file.close();
    return load_motion(scene).warnings;
  };
  const std::string measured = "normal_force = \"measured\"\n";
  const auto mend = [](const char* unit) {
    return HasSubstr(fmt::format(
        "say force_unit = \"{}\" in [motion]{}, or force_unit = \"N\" in [motion] if it is newtons", unit,
        std::string_view(unit) == "mN" ? " (or gf)" : ""));
  };
  EXPECT_THAT(
      warnings(measured, 1000),
      ElementsAre(AllOf(HasSubstr("m.csv: taken as newtons, its measured normal force is 1000 N where "
                                  "it presses, harder than a finger rubs"),
                        mend("mN"))));
  EXPECT_THAT(warnings("", 1000), ElementsAre(AllOf(HasSubstr("its measured force is 1250 N"), mend("mN"))));
  EXPECT_THAT(warnings("", 1e-3),
              ElementsAre(AllOf(HasSubstr("is 0.00125 N where it presses, lighter"), mend("kN"))));
  EXPECT_THAT(warnings("", 1), IsEmpty());
  for (const std::string& keys : {measured, std::string()}) {
    EXPECT_THAT(warnings(keys + "force_unit = \"mN\"\n", 1000), IsEmpty()) << keys;
    EXPECT_THAT(warnings(keys + "force_unit = \"N\"\n", 1e-3), IsEmpty()) << "a touch of 1 mN, as is said";
    EXPECT_THAT(warnings(keys, 1e-3, "s,m,m,m,N,N,N\n"),
                ElementsAre(HasSubstr("lighter than a finger rubs: is its unit the right one?")));
    EXPECT_THAT(warnings(keys + "force_unit = \"mN\"\n", 1),
                ElementsAre(AllOf(HasSubstr("lighter than a finger rubs: is its unit the right one?"),
                                  HasSubstr("the name of its column 'f"), HasSubstr("says another"))))
        << "a column in newtons, said to be in mN";
    EXPECT_THAT(warnings(keys + "force_unit = \"N\"\n", 1000), IsEmpty()) << keys;
  }
}

TEST(RecordingSource, AHandIsAskedWhetherItIsTooQuickForTheFilesOwnRate) {
  const Scene scene = scene_with(
      "file = \"m.csv\"\n[hand]\nmass_kg = 1e-6\nstiffness_n_per_m = 5e5\ndamping_n_s_per_m = 0\n");
  write_recording(20, 240);
  EXPECT_THAT(test::why_not([&] { load_motion(scene); }), HasSubstr("moves too quickly for ticks at 240 Hz"));
  write_recording(20, 1000);
  EXPECT_EQ(load_motion(scene).path.rate_hz(), 1000);
}

}  // namespace
}  // namespace fingerpad::recording_source_test
