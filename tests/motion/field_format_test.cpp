// Recordings in the layouts that others publish, as small synthetic files.
#include "motion/field_format.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "motion/open_layout.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::field_format_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

RecordingFormat named(const std::string& name,
                      const std::vector<std::pair<std::string_view, std::string>>& columns = {}) {
  RecordingFormat format;
  format.name = name;
  for (const auto& [key, header] : columns) format.headers[recording_column_place(key)] = header;
  return format;
}

FieldRecording recording(const fs::path& path, const RecordingFormat& format) {
  return read_field_recording(path.string(), format);
}

std::string refusal_of(const fs::path& path, const RecordingFormat& format) {
  return test::why_not([&] { recording(path, format); });
}

/// The tip of a drag of 40 mm/s from (0, 45) mm at 0.1 s on, as the dataset's description lays it out.
fs::path cluster_files() {
  const fs::path folder = test::scratch_dir();
  std::string force = "time,force\n", position = "time,X,Y\n";
  for (int i = 0; i < 3000; ++i) {
    const double jitter_s = i % 3 == 0 ? 4e-5 : 0;
    force += fmt::format("{:.16g},{:.3f}\n", 0.0009990528727670048 + i / 6000.0 + jitter_s,
                         i < 600 ? 0.003 : 1.009);
  }
  for (int i = 0; i < 50; ++i) {
    const double t_s = 0.000613 + 0.00994 * i;
    position += fmt::format("{:.6f},{:.4f},45.0\n", t_s, 40 * std::max(0.0, t_s - 0.1));
  }
  write(folder / "sensor_data/force/0_0_40_500_0.csv", force);
  write(folder / "sensor_data/position/0_0_40_500_0.csv", position);
  return folder / "sensor_data/force/0_0_40_500_0.csv";
}

TEST(FieldFormat, ClusterTextureJoinsForceAndPositionOfTheirOwnClocks) {
  const fs::path path = cluster_files();
  const FieldRecording read = recording(path, named("cluster-texture"));
  const Motion& motion = read.motion;
  ASSERT_GT(motion.t_s.size(), 2900u);
  EXPECT_EQ(motion.normal_force_n.size(), motion.t_s.size());
  EXPECT_EQ(motion.force_W_n.cols(), 0);  // the normal force alone
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    // One sample of the slower clock at this speed: 0.4 mm where the drag begins, none elsewhere.
    const double off_m = std::abs(motion.p_WQ(0, column) - 0.040 * std::max(0.0, motion.t_s[i] - 0.1));
    EXPECT_LT(off_m, std::abs(motion.t_s[i] - 0.1) < 0.01 ? 4e-4 : 1e-7) << motion.t_s[i];
    EXPECT_NEAR(motion.p_WQ(1, column), 0.045, 1e-15);
    EXPECT_EQ(motion.p_WQ(2, column), 0);
  }
  EXPECT_EQ(motion.normal_force_n.back(), 1.009);
  EXPECT_THAT(read.notes, Contains(HasSubstr("normal force alone")));
  EXPECT_THAT(field_files(path.string(), named("cluster-texture")),
              ElementsAre(HasSubstr("force/0_0_40_500_0.csv"), HasSubstr("position/0_0_40_500_0.csv")));
}

TEST(FieldFormat, ClusterTextureTellsTheAccelerationsBesideIt) {
  const fs::path path = cluster_files();
  EXPECT_THAT(recording(path, named("cluster-texture")).notes, Contains(HasSubstr("no accelerations")));
  // In g, of a clock of their own, from 0.1 s on.
  std::string accel = "time,X,Y,Z\n";
  for (int i = 0; i < 2400; ++i) accel += fmt::format("{:.16g},2,1,-2\n", 0.1 + 7e-5 + i / 6000.0);
  write(path.parent_path().parent_path() / "accel" / path.filename(), accel);
  const FieldRecording read = recording(path, named("cluster-texture"));
  const auto there = std::count_if(read.motion.t_s.begin(), read.motion.t_s.end(),
                                   [](double t_s) { return t_s >= 0.1 + 7e-5; });
  ASSERT_LT(there, static_cast<std::ptrdiff_t>(read.motion.t_s.size()));
  EXPECT_THAT(read.notes, Contains(HasSubstr(fmt::format("accelerations read at {} of {} times", there,
                                                         read.motion.t_s.size()))));
  EXPECT_THAT(read.notes, Contains(HasSubstr("29.4 m/s^2 RMS")));  // three times 9.80665
  EXPECT_THAT(field_files(path.string(), named("cluster-texture")),
              Contains(HasSubstr("accel/0_0_40_500_0")));
}

TEST(FieldFormat, ClusterTextureIsNoneTheWorseForSpoiltAccelerations) {
  const fs::path path = cluster_files();
  write(path.parent_path().parent_path() / "accel" / path.filename(), "time,a,b,c\n0,0,0,0\n");
  const FieldRecording read = recording(path, named("cluster-texture"));
  EXPECT_THAT(read.notes, Contains(AllOf(HasSubstr("no accelerations: "), HasSubstr("0_0_40_500_0.csv"))));
}

TEST(FieldFormat, ClusterTextureTellsWhereItsFilesMustStand) {
  const fs::path path = cluster_files();
  fs::rename(path.parent_path().parent_path() / "position", path.parent_path().parent_path() / "places");
  EXPECT_THAT(refusal_of(path, named("cluster-texture")), HasSubstr("position/0_0_40_500_0.csv"));
  const fs::path elsewhere = path.parent_path().parent_path().parent_path() / "alone.csv";
  fs::rename(path, elsewhere);
  EXPECT_THAT(refusal_of(elsewhere, named("cluster-texture")), HasSubstr("in a folder 'force'"));
  EXPECT_THAT(field_files(elsewhere.string(), named("cluster-texture")), ElementsAre(elsewhere.string()));
}

const std::vector<std::pair<std::string_view, std::string>> finger_columns{
    {"t", "time"}, {"x", "pos x"}, {"y", "pos y"}, {"fx", "Fx"}, {"fy", "Fy"}, {"fz", "Fz"}};

/// Forces (and torques in N mm) at 1 kHz, positions in mm (and speeds) at 60 Hz.
fs::path finger_files(double sense) {
  const fs::path folder = test::scratch_dir();
  std::string forces = "time,Fx,Fy,Fz,Tx,Ty,Tz\n", positions = "time,pos x,pos y,speed\n";
  for (int i = 0; i < 500; ++i)
    forces += fmt::format("{:.3f},{},{},{},0.5,2,0\n", i / 1000.0, -0.3 * sense, 0.1 * sense, 0.8 * sense);
  for (int i = 0; i < 30; ++i) positions += fmt::format("{:.6f},{:.4f},7.5,50\n", i / 60.0, 50 * i / 60.0);
  write(folder / "forces.csv", forces);
  write(folder / "positions.csv", positions);
  return folder / "forces.csv";
}

RecordingFormat sens3(const fs::path& forces) {
  RecordingFormat format = named("sens3", finger_columns);
  format.positions_path = (forces.parent_path() / "positions.csv").string();
  format.says_unit = true;
  format.metres_per_unit = 1e-3;
  return format;
}

TEST(FieldFormat, Sens3JoinsForcesAndPositionsOnceItsColumnsAreSaid) {
  const fs::path path = finger_files(1);
  const Motion motion = recording(path, sens3(path)).motion;
  ASSERT_GT(motion.t_s.size(), 480u);
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i) {
    EXPECT_NEAR(motion.p_WQ(0, i), 0.050 * motion.t_s[static_cast<std::size_t>(i)], 1e-7);
    EXPECT_NEAR(motion.p_WQ(1, i), 7.5e-3, 1e-12);
    EXPECT_EQ(motion.force_W_n.col(i), Vec3(-0.3, 0.1, 0.8));
  }
  EXPECT_EQ(motion.normal_force_n.front(), 0.8);
}

TEST(FieldFormat, Sens3TorquesAndSpeedsAreReadWhereTheyAreNamed) {
  const fs::path path = finger_files(1);
  RecordingFormat format = sens3(path);
  format.torque_headers = {"Tx", "Ty", "Tz"};
  format.speed_header = "speed";
  const FieldRecording read = recording(path, format);
  ASSERT_EQ(read.torque_W_n_m.cols(), read.motion.p_WQ.cols());
  EXPECT_LT((read.torque_W_n_m.col(5) - Vec3(0.5e-3, 2e-3, 0)).norm(), 1e-15);
  EXPECT_THAT(read.notes, Contains(HasSubstr("torques up to 2.06 N mm")));
  EXPECT_THAT(read.notes, Contains(HasSubstr("its speeds are 1 times")));
  EXPECT_THAT(read.warnings, IsEmpty());
  format.says_torque_unit = true;
  format.newton_metres_per_unit = 1;
  format.forces_on_surface = true;
  write(path, "time,Fx,Fy,Fz,Tx,Ty,Tz\n0,0,0,-1,1,2,3\n0.01,0,0,-1,1,2,3\n0.02,0,0,-1,1,2,3\n");
  EXPECT_EQ(recording(path, format).torque_W_n_m.col(0), Vec3(-1, -2, -3));
  // Speeds ten times what the positions give: a unit is wrong.
  std::string positions = "time,pos x,pos y,speed\n";
  for (int i = 0; i < 30; ++i) positions += fmt::format("{:.6f},{:.4f},7.5,500\n", i / 60.0, 50 * i / 60.0);
  const fs::path other = finger_files(1);
  write(other.parent_path() / "positions.csv", positions);
  format = sens3(other);
  format.speed_header = "speed";
  EXPECT_THAT(recording(other, format).warnings, Contains(HasSubstr("its speeds are 10 times")));
  RecordingFormat open = named("4tu-finger-friction", finger_columns);
  open.torque_headers = {"Tx", "Ty", "Tz"};
  open.positions_path = format.positions_path;
  open.says_unit = true;
  EXPECT_THAT(refusal_of(other, open), HasSubstr("does not say the unit of its torques: say --torque-unit"));
}

TEST(FieldFormat, ARowOfUnitsAnswersWhatALayoutLeavesOpen) {
  const fs::path path = test::scratch_dir() / "P02.csv";
  write(path, "ms,Fx,Fn,px,py\nms,N,mN,mm,mm\n0,1,400,0,1\n2,2,500,0.1,1\n");
  const Motion motion =
      recording(path, named("4tu-finger-friction", {{"t", "ms"}, {"x", "px"}, {"y", "py"}, {"fn", "Fn"}}))
          .motion;
  EXPECT_THAT(motion.t_s, ElementsAre(0, 0.002));
  EXPECT_THAT(motion.normal_force_n, ElementsAre(0.4, 0.5));
  EXPECT_NEAR(motion.p_WQ(0, 1), 1e-4, 1e-18);
}

TEST(FieldFormat, WhatALayoutLeavesOpenIsAskedFor) {
  const fs::path path = finger_files(1);
  for (const char* name : {"sens3", "4tu-finger-friction", "ieee-1918-kinaesthetic"}) {
    EXPECT_THAT(refusal_of(path, named(name)),
                AllOf(HasSubstr("does not name its columns"), HasSubstr("t, x, y"), HasSubstr(name),
                      HasSubstr("time,Fx,Fy,Fz,Tx,Ty,Tz")));
    std::vector<std::pair<std::string_view, std::string>> columns = finger_columns;
    columns.emplace_back("z", "pos y");
    RecordingFormat no_unit = named(name, columns);
    no_unit.positions_path = (path.parent_path() / "positions.csv").string();
    EXPECT_THAT(refusal_of(path, no_unit), HasSubstr("the unit of its positions"));
  }
  RecordingFormat no_force = sens3(path);
  for (const char* key : {"fx", "fy", "fz"}) no_force.headers[recording_column_place(key)].clear();
  EXPECT_THAT(refusal_of(path, no_force), HasSubstr("no force is named"));
  RecordingFormat half = sens3(path);
  half.headers[recording_column_place("fy")].clear();
  EXPECT_THAT(refusal_of(path, half), HasSubstr("all of fx, fy and fz"));
}

TEST(FieldFormat, TheLoadOnTheSurfaceIsToldAndTurnedRound) {
  const fs::path path = finger_files(-1);
  RecordingFormat format = sens3(path);
  EXPECT_THAT(refusal_of(path, format), HasSubstr("force_on = \"plate\""));
  format.forces_on_surface = true;
  EXPECT_EQ(recording(path, format).motion.force_W_n.col(3), Vec3(-0.3, 0.1, 0.8));
}

TEST(FieldFormat, OneSpikeDoesNotDecideTheSenseOfAllForces) {
  const fs::path path = finger_files(1);
  std::ifstream file(path);
  std::string rows{std::istreambuf_iterator<char>(file), {}};
  const std::string usual = "0.300,-0.3,0.1,0.8";
  ASSERT_NE(rows.find(usual), std::string::npos);
  write(path, rows.replace(rows.find(usual), usual.size(), "0.300,-0.3,0.1,-9"));
  EXPECT_EQ(recording(path, sens3(path)).motion.force_W_n.col(3), Vec3(-0.3, 0.1, 0.8));
}

TEST(FieldFormat, OneTableOfFingerFrictionNeedsNoOtherFile) {
  const fs::path path = test::scratch_dir() / "P01.csv";
  write(path, "ms;Fx;Fn;px;py\n0;-0,1;0,4;0;1\n2;-0,2;0,5;0,1;1\n");
  RecordingFormat format =
      named("4tu-finger-friction", {{"t", "ms"}, {"x", "px"}, {"y", "py"}, {"fn", "Fn"}});
  format.dialect.decimal = ',';
  format.says_unit = format.says_time_unit = true;
  format.metres_per_unit = format.seconds_per_unit = 1e-3;
  const Motion motion = recording(path, format).motion;
  EXPECT_THAT(motion.t_s, ElementsAre(0, 0.002));
  EXPECT_THAT(motion.normal_force_n, ElementsAre(0.4, 0.5));
  EXPECT_NEAR(motion.p_WQ(0, 1), 1e-4, 1e-18);
}

TEST(FieldFormat, AnOpenLayoutsForcesAreInTheUnitThatIsSaid) {
  const fs::path path = test::scratch_dir() / "P03.csv";
  write(path, "s,Fn,px,py\n0,400,0,1\n0.002,500,0.1,1\n");
  RecordingFormat format = named("4tu-finger-friction", {{"t", "s"}, {"x", "px"}, {"y", "py"}, {"fn", "Fn"}});
  format.says_unit = format.says_force_unit = true;
  format.metres_per_unit = format.newtons_per_unit = 1e-3;
  EXPECT_THAT(recording(path, format).motion.normal_force_n, ElementsAre(0.4, 0.5));
  format.name = "hatt";
  EXPECT_THAT(refusal_of(path, format), HasSubstr("'columns' is said of it"));
  format.headers.fill("");
  format.says_unit = false;
  EXPECT_THAT(refusal_of(path, format), HasSubstr("'force_unit' is said of it"));
}

TEST(FieldFormat, KinaestheticPositionsHaveAHeight) {
  const fs::path path = test::scratch_dir() / "k.csv";
  write(path, "t,x,y,z,vx,vy,vz,fx,fy,fz\n0,1,2,3,0,0,0,0,0,1\n0.001,1,2,3.5,0,0,0,0,0,1\n");
  RecordingFormat format = named("ieee-1918-kinaesthetic", {{"t", "t"}, {"x", "x"}, {"y", "y"}, {"z", "z"}});
  format.says_unit = true;
  format.metres_per_unit = 1e-3;
  EXPECT_LT((recording(path, format).motion.p_WQ.col(1) - Vec3(1e-3, 2e-3, 3.5e-3)).norm(), 1e-18);
  format.headers[recording_column_place("z")].clear();
  EXPECT_THAT(refusal_of(path, format), HasSubstr("say which is z"));
}

std::string hatt_text(const std::string& force_z, const std::string& units = "mm") {
  return "<?xml version=\"1.0\"?>\n<!-- synthetic -->\n<Recording>\n <SampleRate>10000</SampleRate>\n"
         " <ForceUnits>N</ForceUnits>\n <PositionUnits>" +
         units +
         "</PositionUnits>\n <Accel><x>1 2 3</x><y>4 5 6</y><z>7 8 9</z></Accel>\n"
         " <Force><x>0.1,0.2,0.3</x><y>0 0 0</y><z>" +
         force_z +
         "</z></Force>\n <ForceNormal>1; 1.5; 2</ForceNormal>\n <ForceTangential>0.1; 0.2; "
         "0.3</ForceTangential>\n"
         " <Position><x>0 1 2</x><y>3 4 5</y><z>6 7 8</z></Position>\n <Speed>30 30 "
         "30</Speed>\n</Recording>\n";
}

TEST(FieldFormat, HattReadsTheDocumentedElements) {
  const fs::path path = test::scratch_dir() / "foam.xml";
  write(path, hatt_text("-1 -1.5 -2"));
  const FieldRecording read = recording(path, named("hatt"));
  EXPECT_THAT(read.motion.t_s, ElementsAre(0, 1e-4, 2e-4));
  EXPECT_LT((read.motion.p_WQ.col(2) - Vec3(2e-3, 5e-3, 8e-3)).norm(), 1e-18);
  EXPECT_THAT(read.motion.normal_force_n, ElementsAre(1, 1.5, 2));
  EXPECT_EQ(read.motion.force_W_n.col(1), Vec3(-0.2, 0, 1.5));
  EXPECT_THAT(read.notes, Contains(HasSubstr("the opposite of ForceNormal")));
}

TEST(FieldFormat, HattForceWhoseAxesAreUnknownIsPassedOverAndSaid) {
  const fs::path path = test::scratch_dir() / "foam.xml";
  write(path, hatt_text("0 1 0"));
  const FieldRecording read = recording(path, named("hatt"));
  EXPECT_EQ(read.motion.force_W_n.cols(), 0);
  EXPECT_THAT(read.notes, Contains(HasSubstr("its axes against the surface are not known")));
}

TEST(FieldFormat, HattRefusesWhatIsNotAsDescribed) {
  const fs::path path = test::scratch_dir() / "foam.xml";
  const auto refused = [&](const std::string& text) {
    write(path, text);
    return refusal_of(path, named("hatt"));
  };
  EXPECT_THAT(refused(hatt_text("1 1.5 2", "inch")), HasSubstr("PositionUnits is 'inch'"));
  EXPECT_THAT(refused(hatt_text("1 two 2")), HasSubstr("foam.xml:8: 'two' in 'force/z' is no number"));
  EXPECT_THAT(refused(hatt_text("1 2")), HasSubstr("3, 3 and 2 numbers along x, y and z"));
  EXPECT_THAT(refused("<Recording><SampleRate>1</SampleRate></Recording>"), HasSubstr("has no Position"));
  EXPECT_THAT(refused("<Recording></Recording>"), HasSubstr("has no SampleRate"));
  EXPECT_THAT(refused("<!DOCTYPE a [<!ENTITY b \"c\">]><Recording/>"), HasSubstr("declaration"));
  EXPECT_THAT(refused("<Recording><a>1</b></Recording>"), HasSubstr("</b> closes <a>"));
  EXPECT_THAT(refused("<Recording><a>1"), HasSubstr("<a> is not closed"));
  EXPECT_THAT(refused("<Recording><a"), HasSubstr("ends within a tag"));
  EXPECT_THAT(refused("<a/><b/>"), HasSubstr("second root"));
  EXPECT_THAT(refused("no xml"), HasSubstr("holds no element"));
}

TEST(FieldFormat, HattNamesAndElementsAreBounded) {
  const fs::path path = test::scratch_dir() / "foam.xml";
  const auto refused = [&](const std::string& text) {
    write(path, text);
    return refusal_of(path, named("hatt"));
  };
  const std::string longest(64, 'n'), longer(65, 'n');
  EXPECT_THAT(refused(fmt::format("<R>\n<{0}>1</{0}></R>", longest)), HasSubstr("has no SampleRate"));
  EXPECT_THAT(refused(fmt::format("<R>\n<{0}>1</{0}></R>", longer)), HasSubstr("foam.xml:2: <nnnnnnnnnn"));
  EXPECT_THAT(refused(fmt::format("<R>\n<{0}>1</{0}></R>", longer)),
              HasSubstr("has a name of 65 characters (at most 64)"));
  std::string leaves;
  for (int i = 0; i < 10001; ++i) leaves += "<a></a>\n";
  EXPECT_THAT(refused("<R>" + leaves + "</R>"), HasSubstr("foam.xml:10001: has more than 10000 elements"));
}

TEST(FieldFormat, WhatARowDoesNotAskForIsRefusedByItsKey) {
  const fs::path path = finger_files(1);
  RecordingFormat places, subject, trial, columns, plate, decimal;
  places.positions_path = "positions.csv";
  subject.subject = 1;
  trial.trial = 2;
  columns.headers[0] = "time";
  plate.forces_on_surface = true;
  decimal.dialect.decimal = ',';
  const struct {
    const char *name, *key;
    RecordingFormat said;
  } cases[] = {
      {"", "positions", places},     {"hatt", "positions", places}, {"cluster-texture", "positions", places},
      {"sens3", "subject", subject}, {"hatt", "trial", trial},      {"cluster-texture", "columns", columns},
      {"hatt", "force_on", plate},   {"hatt", "decimal", decimal},  {"4tu-finger-friction", "trial", trial},
  };
  for (auto c : cases) {
    c.said.name = c.name;
    EXPECT_THAT(refusal_of(path, c.said),
                AllOf(HasSubstr(fmt::format("'{}' is said of it", c.key)), HasSubstr(c.name)));
  }
  RecordingFormat finger = sens3(path);
  finger.headers[recording_column_place("dx")] = "Tx";
  EXPECT_THAT(refusal_of(path, finger), HasSubstr("the column 'dx' is named, which sens3 does not take"));
}

TEST(FieldFormat, EachRowIsFoundByItsName) {
  for (const FieldFormat& row : field_formats()) {
    EXPECT_EQ(find_field_format(row.name)->summary, row.summary);
    EXPECT_THAT(std::string(row.touched_with), testing::Not(IsEmpty()));
    EXPECT_THAT(field_formats_text(), HasSubstr(fmt::format("| `{}` |", row.name)));
  }
  EXPECT_EQ(find_field_format("other"), nullptr);
  std::ifstream readme(test::source_dir() / "README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  EXPECT_THAT(text, HasSubstr(field_formats_text()));
}

}  // namespace
}  // namespace fingerpad::field_format_test
