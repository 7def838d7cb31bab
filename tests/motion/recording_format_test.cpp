#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "motion/finger_path.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::recording_format_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Motion read(const std::string& text, RecordingFormat format) {
  const auto path = test::scratch_dir() / "m.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_motion_csv(path.string(), format);
}

RecordingFormat laboratory() {
  RecordingFormat format;
  format.headers = {"Zeit", "X", "Y", "Z"};
  format.headers.back() = "Fz";
  format.metres_per_unit = 1e-3;
  format.seconds_per_unit = 1e-3;
  format.dialect.decimal = ',';
  format.reads_normal_force = true;
  return format;
}

TEST(RecordingFormat, ReadsARowOfUnitsOrSaysWhatToDo) {
  RecordingFormat format;
  format.headers = {"t", "X", "Y", "Z"};
  format.headers.back() = "F";
  format.reads_normal_force = true;
  const Motion motion = read("t,X,Y,Z,F\nms,mm,mm,mm,mN\n0,1,2,3,100\n2,1,2,3,200\n", format);
  EXPECT_THAT(motion.t_s, ElementsAre(0, 0.002));
  EXPECT_LT((motion.p_WQ.col(0) - Vec3(1e-3, 2e-3, 3e-3)).norm(), 1e-18);
  EXPECT_THAT(motion.normal_force_n, ElementsAre(testing::DoubleEq(0.1), testing::DoubleEq(0.2)));
  format.says_unit = true;
  format.metres_per_unit = 1e-2;
  EXPECT_THAT(test::why_not([&] { read("t,X,Y,Z,F\nms,mm,mm,mm,mN\n0,1,2,3,1\n", format); }),
              HasSubstr("unit in [motion] says another unit"));
}

TEST(RecordingFormat, TakesNoColumnInAnotherUnitThanItsNameSays) {
  RecordingFormat format;
  format.headers = {"t_s", "x_m", "y_mm", "z_m"};
  const std::string text = "t_s,x_m,y_mm,z_m,t_ms\n0,1,2,3,0\n1,1,2,3,1000\n";
  EXPECT_THAT(
      test::why_not([&] { read(text, format); }),
      HasSubstr("has the column 'y_mm', whose name says a unit that is not said: say unit in [motion], "
                "\"mm\" if it is right"));
  format.headers = {"t_ms", "x_m", "x_m", "z_m"};
  EXPECT_THAT(test::why_not([&] { read(text, format); }), HasSubstr("say time_unit in [motion], \"ms\""));
  format.seconds_per_unit = 1e-3;
  format.says_time_unit = true;
  EXPECT_THAT(read(text, format).t_s, ElementsAre(0, 1));
}

TEST(RecordingFormat, ANameSaysItsUnitInBracketsToo) {
  RecordingFormat format;
  format.headers = {"t [s]", "X [mm]", "Y [mm]", "Z [mm]"};
  const std::string text = "t [s],X [mm],Y [mm],Z [mm]\n0,1,2,3\n1,1,2,3\n";
  EXPECT_THAT(test::why_not([&] { read(text, format); }),
              HasSubstr("has the column 'X [mm]', whose name says a unit that is not said: say unit in "
                        "[motion], \"mm\" if it is right"));
  format.headers = {"t (s)", "x (m)", "y(2)", "z ()"};
  EXPECT_EQ(read("t (s),x (m),y(2),z ()\n0,1,2,3\n1,1,2,3\n", format).t_s.size(), 2U);
}

TEST(RecordingFormat, ForcesAreInTheUnitThatIsSaid) {
  RecordingFormat format;
  for (std::size_t k = 11; k < 14; ++k) format.headers[k] = recording_columns[k].header;
  format.headers.back() = "fz_n";
  format.reads_normal_force = true;
  format.says_force_unit = true;
  format.newtons_per_unit = 9.80665e-3;
  const std::string table = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n", row = "0,0,0,0,-30,0,100\n";
  const Motion motion = read(table + row, format);
  EXPECT_LT((motion.force_W_n.col(0) - Vec3(-0.2941995, 0, 0.980665)).norm(), 1e-15);
  EXPECT_THAT(motion.normal_force_n, ElementsAre(testing::DoubleEq(0.980665)));
  EXPECT_THAT(test::why_not([&] { read(table + "s,m,m,m,N,N,N\n" + row, format); }),
              HasSubstr("'N' below 'fx_n', and force_unit in [motion] says another unit"));
  format.newtons_per_unit = 1;
  EXPECT_EQ(read(table + "s,m,m,m,N,N,N\n" + row, format).force_W_n(2, 0), 100);
  format.headers[13] = "fz_mN";
  format.headers.back() = "fz_mN";
  const std::string named = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_mN\n";
  EXPECT_EQ(read(named + row, format).force_W_n(2, 0), 100) << "it is said";
  format.says_force_unit = false;
  EXPECT_THAT(test::why_not([&] { read(named + row, format); }),
              HasSubstr("has the column 'fz_mN', whose name says a unit that is not said: say force_unit in "
                        "[motion], \"mN\" if it is right"));
}

TEST(RecordingFormat, ReadsALaboratorysTableAsItIs) {
  const Motion motion = read(
      "\xef\xbb\xbf# Versuch 3; Finger 2\r\nX;Y;Z;Zeit;\"Fz\"\r\n1,5;0;-2;0;-0,1\r\n2,5;0,25;-2;4,2;0,75\r\n",
      laboratory());
  EXPECT_THAT(motion.t_s, ElementsAre(0, testing::DoubleEq(0.0042)));
  EXPECT_LT((motion.p_WQ.col(1) - Vec3(2.5e-3, 2.5e-4, -2e-3)).norm(), 1e-18);
  EXPECT_THAT(motion.normal_force_n, ElementsAre(-0.1, 0.75));
  const FingerPath path(motion, 1 / 0.0021, Vec3::UnitX());
  EXPECT_NEAR(path.at(1).normal_force_n.value(), (0.75 - 0.1) / 2, 1e-12);
}

TEST(RecordingFormat, WhatIsNotNamedHasItsOwnName) {
  RecordingFormat format;
  format.headers[0] = "time";
  const Motion motion = read("time x_m y_m z_m dx dy dz\n0 1 2 3 0 0 -1\n", format);
  EXPECT_EQ(motion.p_WQ.col(0), Vec3(1, 2, 3));
  EXPECT_EQ(motion.direction_W.col(0), Vec3(0, 0, -1));
  EXPECT_TRUE(motion.normal_force_n.empty());
}

TEST(RecordingFormat, AMeasuredForceIsReadWhereAllOfItIsNamed) {
  const std::string table = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n0,0,0,0,1,2,3\n1,0,0,0,3,2,5\n";
  EXPECT_EQ(read(table, {}).force_W_n.cols(), 0);
  RecordingFormat format;
  for (std::size_t k = 11; k < 14; ++k) format.headers[k] = recording_columns[k].header;
  format.headers.back() = "fz_n";  // a normal force may be one of them
  format.reads_normal_force = true;
  const Motion motion = read(table, format);
  EXPECT_EQ(motion.force_W_n.col(0), Vec3(1, 2, 3));
  EXPECT_THAT(motion.normal_force_n, ElementsAre(3, 5));
  const FingerPath path(motion, 2, Vec3::UnitX());
  ASSERT_TRUE(path.has_measured_force());
  EXPECT_EQ(path.measured_force_W_n(1), Vec3(2, 2, 4));
  format.forces_on_surface = true;
  EXPECT_EQ(read(table, format).force_W_n.col(0), Vec3(-1, -2, -3));
  format.headers[12].clear();
  EXPECT_THAT(test::why_not([&] { read(table, format); }), HasSubstr("all of fx, fy and fz"));
}

TEST(RecordingFormat, ANormalForceOnThePlateIsTurnedRound) {
  RecordingFormat format = laboratory();
  format.dialect.decimal = '.';
  format.forces_on_surface = true;
  const std::string header = "Zeit,X,Y,Z,Fz\n";
  EXPECT_THAT(read(header + "0,0,0,0,-1.5\n1,0,0,0,-2\n2,0,0,0,0.25\n", format).normal_force_n,
              ElementsAre(1.5, 2, -0.25));
  // One that is above 0 where it presses is that on the finger, whatever the other forces act on.
  EXPECT_THAT(read(header + "0,0,0,0,1.5\n1,0,0,0,2\n", format).normal_force_n, ElementsAre(1.5, 2));
}

TEST(RecordingFormat, TheSideOrTheUnitOfAForceIsRefusedWhereNoneIsRead) {
  RecordingFormat format;
  format.forces_on_surface = true;
  EXPECT_THAT(test::why_not([&] { read("t_s,x_m,y_m,z_m\n0,0,0,0\n", format); }),
              AllOf(HasSubstr("force_on"), HasSubstr("name fx, fy and fz, or fn, in columns")));
  format.forces_on_surface = false;
  format.says_force_unit = true;
  EXPECT_THAT(test::why_not([&] { read("t_s,x_m,y_m,z_m\n0,0,0,0\n", format); }),
              AllOf(HasSubstr("force_unit says what a measured force is in"),
                    HasSubstr("name fx, fy and fz, or fn, in columns, or leave force_unit out")));
}

TEST(RecordingFormat, SaysWhatToDoAboutGapsAndSeveralTrials) {
  EXPECT_THAT(test::why_not([] { read("t_s,x_m,y_m,z_m\n0,0,0,0\n1,,0,0\n", {}); }),
              AllOf(HasSubstr("m.csv:3"), HasSubstr("holds nothing in column 'x_m'"),
                    HasSubstr("leave such rows out")));
  const std::string trials = "t_s,x_m,y_m,z_m,subject,trial\n0,0,0,0,1,1\n1,0,0,0,1,1\n0,0,0,0,2,1\n";
  EXPECT_THAT(test::why_not([&] { read(trials, {}); }), HasSubstr("say which one: 'trial' in [motion]"));
  RecordingFormat first;
  first.trial = 1;
  EXPECT_THAT(test::why_not([&] { read(trials, first); }), HasSubstr("say 'subject' in [motion] too"));
}

TEST(RecordingFormat, OneTrialOfATableIsReadByItself) {
  const std::string table =
      "t_s,x_m,y_m,z_m,subject,trial\n0,1,0,0,1,1\n1,2,0,0,1,1\n0,3,0,0,1,2\n1,4,0,0,1,2\n0,5,0,0,2,2\n";
  RecordingFormat format;
  EXPECT_THAT(test::why_not([&] { read(table, format); }), HasSubstr("m.csv:4"));
  format.trial = 2;
  format.subject = 1;
  const Motion motion = read(table, format);
  EXPECT_THAT(motion.t_s, ElementsAre(0, 1));
  EXPECT_EQ(motion.p_WQ(0, 0), 3);
  format.trial = 3;
  EXPECT_THAT(test::why_not([&] { read(table, format); }), HasSubstr("has no row of subject 1 trial 3"));
  EXPECT_THAT(test::why_not([&] { read("t_s,x_m,y_m,z_m\n0,1,0,0\n", format); }),
              HasSubstr("no column 'subject'"));
}

TEST(RecordingFormat, AnAttitudeMayBeNamedToo) {
  RecordingFormat format;
  for (std::size_t k = 7; k < 11; ++k) format.headers[k] = std::string("q") + "rijk"[k - 7];
  EXPECT_EQ(read("t_s,x_m,y_m,z_m,qr,qi,qj,qk\n0,0,0,0,0,1,0,0\n", format).attitude[0].x(), 1);
}

TEST(RecordingFormat, WhatIsNamedMustBeThere) {
  RecordingFormat format = laboratory();
  format.headers[1] = "x";
  EXPECT_THAT(test::why_not([&] { read("Zeit;X;Y;Z;Fz\n0;0;0;0;0\n", format); }),
              AllOf(HasSubstr("m.csv:1: no column 'x' (did you mean 'X'?)"),
                    HasSubstr("it names Zeit, X, Y, Z, Fz"), HasSubstr("[motion] columns = {")));
  format = RecordingFormat();
  format.reads_normal_force = true;
  EXPECT_THAT(test::why_not([&] { read("t_s,x_m,y_m,z_m\n0,0,0,0\n", format); }),
              HasSubstr("no column 'fn_n'"));
  format = RecordingFormat();
  format.headers[4] = "nx";
  EXPECT_THAT(test::why_not([&] { read("t_s,x_m,y_m,z_m\n0,0,0,0\n", format); }),
              HasSubstr("no column 'nx'"));
}

TEST(RecordingFormat, BoundsAreThoseOfMetresSecondsAndNewtons) {
  EXPECT_THAT(test::why_not([] { read("Zeit;X;Y;Z;Fz\n0;2e12;0;0;0\n", laboratory()); }),
              HasSubstr("m.csv:2: x_m is 2000000000 m; a finger is at most"));
  EXPECT_THAT(test::why_not([] { read("Zeit;X;Y;Z;Fz\n0;0;0;0;0\n\n3;0;0;0;1e9\n", laboratory()); }),
              HasSubstr("m.csv:4: the normal force is 1000000000 N; at most"));
  // A force that is not used may be what it will.
  EXPECT_EQ(read("t_s,x_m,y_m,z_m,fn_n\n0,0,0,0,nan\n", {}).t_s.size(), 1u);
}

}  // namespace
}  // namespace fingerpad::recording_format_test
