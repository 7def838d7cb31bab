#include "study/measurement_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <limits>

#include "study/trial_rows.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "trace/hdf5_file.hpp"

namespace fingerpad::measurement_reader_test {
namespace {

using testing::HasSubstr;

class Reading : public testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }
  const std::filesystem::path folder = test::scratch_dir();
};

/// Rows 0 .. 19 of a millisecond each.
template <typename Row>
std::string table(const std::string& header, const Row& row) {
  std::string text = header + "\n";
  for (int i = 0; i < 20; ++i) text += row(i) + "\n";
  return text;
}

TEST_F(Reading, NamesTheHeaderThatIsAColumnWithoutItsUnit) {
  const std::string path = written("short.csv", "t_s;x;y;z;fx;fy;fz\n0;0;0;0;0;0;1\n");
  EXPECT_THAT(test::why_not([&] { read_measurements({path}, {}); }),
              HasSubstr("no column 'x_m' (did you mean 'x'?)"));
}

TEST_F(Reading, TakesColumnsUnitsAndSeparatorsAsItIsTold) {
  const std::string path =
      written("other.csv", table("Zeit;X;Y;Z;Fx;Fy;Fz;wer", [](int i) {
                return std::to_string(i) + ";1,5;" + std::to_string(i) + ",0;0;0,1;0;1000;7";
              }));
  MeasurementFormat format;
  const char* const names[] = {"Zeit", "X", "Y", "Z", "Fx", "Fy", "Fz"};
  std::copy(std::begin(names), std::end(names), format.headers.begin());
  format.headers[22] = "wer";
  format.metres_per_unit = 1e-3;
  format.seconds_per_unit = 1e-3;
  format.newtons_per_unit = 1e-3;
  format.dialect.decimal = ',';
  format.force_on_plate = true;
  const RecordedMeasurement read = read_measurements({path}, format);
  ASSERT_EQ(read.trials.size(), 1u);
  const RecordedTrial& trial = read.trials.front();
  EXPECT_EQ(trial.subject, 7);
  EXPECT_EQ(trial.samples(), 20);
  EXPECT_EQ(trial.rate_hz, 1000);
  EXPECT_NEAR(trial.position_W(0, 3), 1.5e-3, 1e-12);
  EXPECT_NEAR(trial.position_W(1, 3), 3e-3, 1e-12);
  EXPECT_NEAR(trial.force_W(2, 3), -1, 1e-12);
}

TEST_F(Reading, AUnitThatAColumnsNameSaysIsNotPassedOver) {
  const auto why_not = [&](const std::string& force, bool is_said) {
    const std::string path = written("named.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n," + force, [](int i) {
                                       return std::to_string(i) + "e-3,0,0,0,0,0,1";
                                     }));
    MeasurementFormat format;
    format.headers[6] = force;
    format.says_force_unit = is_said;
    return test::why_not([&] { read_measurements({path}, format); });
  };
  EXPECT_THAT(why_not("Fz [kgf]", false),
              HasSubstr("named.csv: has the column 'Fz [kgf]', whose name says a unit that is not said: say "
                        "--force-unit, \"kgf\" if it is right"));
  EXPECT_THAT(why_not("Fz/g", false), HasSubstr("\"gf\" if it is right"));
  EXPECT_THAT(
      why_not("Fz [V]", false),
      HasSubstr("says the unit 'V', and of a force these are known: N, mN, kN, gf, kgf, cN, lbf; turn "
                "its numbers into one of them, and say --force-unit"));
  for (const char* plain : {"Fz [N]", "Fz/N", "Fz", "Fz (filtered)"})
    EXPECT_EQ(why_not(plain, false), "taken");
  EXPECT_EQ(why_not("Fz [kgf]", true), "taken") << "who says it is believed";
}

TEST_F(Reading, AColumnThatMayNumberTrialsIsToldWhereItIsNotRead) {
  const std::string path = written("trials.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,Trial No", [](int i) {
                                     return std::to_string(i) + "e-3,0,0,0,0,0,1,1";
                                   }));
  EXPECT_THAT(read_measurements({path}, {}).notes,
              testing::Contains(HasSubstr("the column 'Trial No' is not read: where it numbers trials, say "
                                          "--columns \"trial=Trial No\"")));
}

TEST_F(Reading, CellsWithoutANumberAndMissingRowsAreMissingSamples) {
  const std::string path = written(
      "gaps.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n", [](int i) {
        const std::string t = std::to_string(i < 10 ? i : i + 5) + "e-3";
        return t + (i == 4 ? ",nan,,0,0,0,1" : "," + std::to_string(i < 10 ? i : i + 5) + ",0,0,0,0,1");
      }));
  const RecordedMeasurement read = read_measurements({path}, {});
  ASSERT_EQ(read.trials.size(), 1u);
  const RecordedTrial& trial = read.trials.front();
  ASSERT_EQ(trial.samples(), 25);
  EXPECT_EQ(trial.origin[4], SampleOrigin::filled);
  EXPECT_EQ(trial.origin[5], SampleOrigin::recorded);
  EXPECT_EQ(trial.origin[12], SampleOrigin::filled);
  for (Eigen::Index k = 0; k < 25; ++k) EXPECT_NEAR(trial.position_W(0, k), static_cast<double>(k), 1e-9);
}

TEST_F(Reading, TrialsArePartedAndUnnumberedOnesCutWhereTheRecordingStopped) {
  const std::string path = written("two.csv", [] {
    std::string text = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
    for (int i = 0; i < 40; ++i) text += std::to_string(i < 20 ? i : i + 3000) + "e-3,0,0,0,0,0,1\n";
    return text;
  }());
  EXPECT_EQ(read_measurements({path}, {}).trials.size(), 2u);
  const std::string back = written("back.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n", [](int i) {
                                     return std::to_string(i == 7 ? 3 : i) + "e-3,0,0,0,0,0,1";
                                   }));
  EXPECT_THAT(test::why_not([&] { read_measurements({back}, {}); }),
              HasSubstr("back.csv:9: its time 0.003 s comes before 0.006 s"));
  const std::string half = written("half.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dz", [](int i) {
                                     return std::to_string(i) + "e-3,0,0,0,0,0,1,1,0";
                                   }));
  EXPECT_THAT(test::why_not([&] { read_measurements({half}, {}); }),
              HasSubstr("2 of the columns dx, dy, dz"));
}

TEST_F(Reading, ATableWithoutRowsIsToldSo) {
  const std::string path = written("empty.csv", "# none yet\nt_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n\n");
  EXPECT_THAT(test::why_not([&] { read_measurements({path}, {}); }),
              HasSubstr("empty.csv: has a header but no rows"));
}

TEST_F(Reading, Hdf5ColumnsAreReadAsThoseOfATable) {
  const std::string path = (folder / "columns.h5").string();
  {
    hdf5::Handle file = hdf5::create_file(path);
    const char* const names[] = {"t_s", "x_m", "y_m", "z_m", "fx_n", "fy_n", "fz_n", "trial"};
    for (const char* name : names) {
      std::vector<double> values;
      for (int i = 0; i < 40; ++i)
        values.push_back(std::string(name) == "t_s"     ? 1e-3 * (i % 20)
                         : std::string(name) == "trial" ? i / 20
                                                        : 0.25);
      hdf5::append(hdf5::create_column(file, name, hdf5::NumberType::float64, "1"), 0, values);
    }
    hdf5::close_file(std::move(file));
  }
  const RecordedMeasurement read = read_measurements({path}, {});
  ASSERT_EQ(read.trials.size(), 2u);
  EXPECT_EQ(read.trials[1].number, 1);
  EXPECT_EQ(read.trials[1].samples(), 20);
  EXPECT_EQ(read.trials[1].force_W(2, 19), 0.25);
  MeasurementFormat named;
  named.headers[0] = "when";
  EXPECT_THAT(test::why_not([&] { read_measurements({path}, named); }), HasSubstr("has no dataset 'when'"));
}

TEST_F(Reading, AnHdf5DatasetsUnitIsReadAndToldOrRefusedByName) {
  const auto read_with = [this](const std::string& length, const MeasurementFormat& format) {
    const std::string path = (folder / "units.h5").string();
    hdf5::Handle file = hdf5::create_file(path);
    const std::pair<const char*, std::string> columns[] = {{"time", "ms"}, {"X", length}, {"Y", length},
                                                           {"Z", length},  {"fx_n", "N"}, {"fy_n", "N"},
                                                           {"fz_n", "N"}};
    for (const auto& [name, unit] : columns) {
      std::vector<double> values;
      for (int i = 0; i < 20; ++i) values.push_back(i);
      hdf5::append(hdf5::create_column(file, name, hdf5::NumberType::float64, unit), 0, values);
    }
    hdf5::close_file(std::move(file));
    return read_measurements({path}, format);
  };
  MeasurementFormat format;
  const char* const names[] = {"time", "X", "Y", "Z"};
  std::copy(std::begin(names), std::end(names), format.headers.begin());
  const RecordedMeasurement read = read_with("mm", format);
  ASSERT_EQ(read.trials.size(), 1u);
  EXPECT_EQ(read.trials.front().rate_hz, 1000);
  EXPECT_NEAR(read.trials.front().position_W(1, 3), 3e-3, 1e-12);  // rounding
  EXPECT_NEAR(read.trials.front().force_W(2, 3), 3, 1e-12);
  EXPECT_THAT(read.notes,
              testing::Contains(HasSubstr(
                  "units as the attributes of its datasets have them: a time is 0.001 s, a position is "
                  "0.001 m, a force is 1 N")));
  EXPECT_THAT(
      test::why_not([&] { read_with("ell", format); }),
      HasSubstr("has the unit 'ell' at 'X', which is no unit of length that is known (m, mm, cm, in, um): "
                "delete the attribute, and say --unit"));
  format.says_unit = true;
  EXPECT_THAT(test::why_not([&] { read_with("mm", format); }), HasSubstr("and --unit says another unit"));
}

TEST_F(Reading, TwoMarkersGiveTheFingertipAndItsAngle) {
  // The finger points along y and down by 30 degrees; its markers lie 12 mm above it.
  const Vec3 along = Vec3(0, std::cos(M_PI / 6), -0.5), up = Vec3(0, 0.5, std::cos(M_PI / 6));
  const Vec3 tip(0.1, 0.2, 0.3), distal = tip - 0.02 * along + 0.012 * up, proximal = distal - 0.03 * along;
  const std::string path =
      written("markers.csv", table("t_s,m1x_m,m1y_m,m1z_m,m2x_m,m2y_m,m2z_m,fx_n,fy_n,fz_n", [&](int i) {
                std::string row = std::to_string(i) + "e-3";
                for (const Vec3& p : {proximal, distal})
                  for (const double x : p) row += "," + std::to_string(x);
                return row + ",0,0,1";
              }));
  MeasurementFormat format;
  format.markers = TwoMarkers{0.02, 0.012};
  const RecordedMeasurement read = read_measurements({path}, format);
  ASSERT_EQ(read.trials.size(), 1u);
  const RecordedTrial& trial = read.trials.front();
  EXPECT_LT((trial.position_W.col(5) - tip).norm(), 3e-6);  // of six decimals
  EXPECT_LT((trial.direction_W - along).norm(), 1e-4);
  EXPECT_NEAR(trial.least_angle_deg, 30, 0.01);
}

TEST_F(Reading, ASixAxisSensorGivesTheForceAndTheContactPoint) {
  // A sensor 20 mm below the plate z = 5 mm, turned by 90 degrees about z; the finger presses at (30, 40) mm.
  const Vec3 force(0.3, -0.2, 2), at(0.03, 0.04, 0.005), origin(0.01, 0, -0.015);
  const Mat3 turn = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 torque =
      (at - origin).cross(force) + 0.01 * Vec3::UnitZ();  // and a free moment about the normal
  const Vec3 f = turn.transpose() * force, m = turn.transpose() * torque;
  const std::string path =
      written("wrench.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,tx_n_m,ty_n_m,tz_n_m", [&](int i) {
                std::string row = std::to_string(i) + "e-3,9,9,0.006";
                for (const double x : f) row += "," + std::to_string(x);
                for (const double x : m) row += "," + std::to_string(x);
                return row;
              }));
  MeasurementFormat format;
  format.sensor = SixAxisSensor{turn, origin, 0.005, true};
  const RecordedTrial trial = read_measurements({path}, format).trials.at(0);
  EXPECT_LT((trial.force_W.col(3) - force).norm(), 1e-5);
  EXPECT_LT((trial.position_W.col(3) - Vec3(0.03, 0.04, 0.006)).norm(), 2e-6);
  // Of a sensor whose place is not said, no torque tells one.
  format.sensor->says_place = false;
  EXPECT_LT((read_measurements({path}, format).trials.at(0).position_W.col(3) - Vec3(9, 9, 0.006)).norm(),
            1e-12);
}

TEST_F(Reading, ARowOfUnitsIsReadWhereItIsClear) {
  const auto rows = [](const std::string& units) {
    return table("t,x_m,y_m,z_m,A,B,C,nx,ny,nz,trial\n" + units,
                 [](int i) { return std::to_string(i) + ",1,2,3,100,200,1000,0,0,1,4"; });
  };
  MeasurementFormat format;
  format.headers[0] = "t";
  format.headers[4] = "A";
  format.headers[5] = "B";
  format.headers[6] = "C";
  const auto read = read_measurements({written("units.csv", rows("ms,m,m,m,mN,mN,mN,-,-,-,"))}, format);
  ASSERT_EQ(read.trials.size(), 1U);
  EXPECT_EQ(read.trials[0].rate_hz, 1000);
  EXPECT_NEAR(read.trials[0].force_W(2, 3), 1, 1e-12);
  EXPECT_NEAR(read.trials[0].position_W(1, 3), 2, 1e-12);
  EXPECT_THAT(read.notes, testing::Contains(HasSubstr("units as the line below its header has them")));
  const auto why = [&](const std::string& units) {
    return test::why_not([&] { read_measurements({written("units.csv", rows(units))}, format); });
  };
  EXPECT_THAT(why("ms,mm,mm,mm,mN,mN,mN,-,-,-,"),
              HasSubstr("'mm' below 'x_m', whose name says another unit"));
  EXPECT_THAT(
      why("ms,m,m,m,V,V,V,-,-,-,"),
      HasSubstr(
          "no unit of force that is known (N, mN, kN, gf, kgf, cN, lbf): put # before the line, and say "
          "--force-unit"));
}

TEST_F(Reading, ANamedSeparatorThatTheTableHasNotIsToldWithAWayOut) {
  MeasurementFormat format;
  format.dialect.separator = ',';
  const std::string path = written("semicolons.csv", "t_s;x_m;y_m;z_m;fx_n;fy_n;fz_n\n0;0;0;0;0;0;1\n");
  const std::string why = test::why_not([&] { read_measurements({path}, format); });
  EXPECT_THAT(why, HasSubstr("its cells are parted by ';', not by ','"));
  EXPECT_THAT(why, HasSubstr("leave the separator out, and it is found"));
}

/// Forces and torques in N and N mm at 1 kHz, of a sensor 20 mm below the plate; positions in mm at 100 Hz.
TEST_F(Reading, Sens3TorquesTellTheContactPointWhereTheSensorsPlaceIsSaid) {
  const Vec3 force(0.3, -0.2, 2), at(0.03, 0.04, 0), origin(0.01, 0, -0.02);
  const Vec3 torque = 1e3 * (at - origin).cross(force);
  std::string forces = "time,Fx,Fy,Fz,Tx,Ty,Tz\n", positions = "time,px,py,v\n";
  for (int i = 0; i < 400; ++i)
    forces += fmt::format("{},{},{},{},{},{},{}\n", i * 1e-3, force.x(), force.y(), force.z(), torque.x(),
                          torque.y(), torque.z());
  for (int i = 0; i <= 40; ++i) positions += fmt::format("{},{},5,100\n", i * 1e-2, i);
  MeasurementFormat format;
  for (const auto& [key, name] : std::vector<std::pair<std::string_view, const char*>>{{"t", "time"},
                                                                                       {"x", "px"},
                                                                                       {"y", "py"},
                                                                                       {"fx", "Fx"},
                                                                                       {"fy", "Fy"},
                                                                                       {"fz", "Fz"},
                                                                                       {"tx", "Tx"},
                                                                                       {"ty", "Ty"},
                                                                                       {"tz", "Tz"},
                                                                                       {"speed", "v"}}) {
    for (std::size_t k = 0; k < measurement_columns.size(); ++k)
      if (measurement_columns[k].key == key) format.headers[k] = name;
  }
  format.positions_path = written("positions.csv", positions);
  format.says_unit = true;
  format.metres_per_unit = 1e-3;
  const std::string path = written("forces.csv", forces);
  const RecordedMeasurement tracked = read_measurements({path}, format, "sens3");
  EXPECT_NEAR(tracked.trials.at(0).position_W(0, 100), 0.01, 1e-9);
  EXPECT_THAT(tracked.notes, testing::Contains(HasSubstr("torques up to ")));
  EXPECT_THAT(tracked.notes, testing::Contains(HasSubstr("its speeds are 1 times what its positions give")));
  EXPECT_THAT(tracked.warnings, testing::IsEmpty());
  format.sensor = SixAxisSensor{Mat3::Identity(), origin, 0, true};
  const RecordedMeasurement told = read_measurements({path}, format, "sens3");
  EXPECT_LT((told.trials.at(0).position_W.col(100) - at).norm(), 1e-6);
  format.sensor.reset();
  for (std::size_t k = 0; k < measurement_columns.size(); ++k)
    if (measurement_columns[k].key == "tz") format.headers[k].clear();
  EXPECT_THAT(test::why_not([&] { read_measurements({path}, format, "sens3"); }),
              HasSubstr("a torque needs all of tx, ty and tz"));
}

TEST_F(Reading, ATorqueOrSpeedIsNotPassedOverInSilenceWhereItIsNotRead) {
  MeasurementFormat speed, sensor;
  speed.headers[static_cast<std::size_t>(measurement_columns.size() - 1)] = "v";
  EXPECT_THAT(test::why_not(
                  [&] { read_measurements({written("own.csv", "t_s,x_m,y_m,z_m,v\n0,0,0,0,0\n")}, speed); }),
              HasSubstr("speed of --columns is read with --reader sens3"));
  const std::string path = written("s.csv", "time,px,py,Fx,Fy,Fz\n0,0,0,0,0,1\n");
  sensor.sensor = SixAxisSensor{};
  EXPECT_THAT(test::why_not([&] { read_measurements({path}, sensor, "sens3"); }),
              HasSubstr("no torque is named"));
}

TEST_F(Reading, ASensorsPlaceIsNotPassedOverInSilenceWhereNoTorqueIsFound) {
  const std::string path = written("t.csv", table("t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,tx,ty,tz", [](int i) {
                                     return std::to_string(i) + "e-3,9,9,0,0,0,2,0,0.04,0";
                                   }));
  MeasurementFormat format;
  format.sensor = SixAxisSensor{Mat3::Identity(), Vec3(0.01, 0, 0), 0, true};
  const auto why = [&] { return test::why_not([&] { read_measurements({path}, format); }); };
  EXPECT_THAT(why(),
              HasSubstr("--sensor-at has no effect without torque, and the columns tx_n_m, ty_n_m, "
                        "tz_n_m are missing: where yours are called otherwise, say --columns tx=NAME"));
  const std::string motion =
      written("motion.csv", table("t_s,x_m,y_m,z_m", [](int i) { return std::to_string(i) + "e-3,9,9,0"; }));
  EXPECT_EQ(test::why_not([&] { read_measurements({motion}, format); }), "taken")
      << "it is left out as any file without force";
  const auto torque = static_cast<std::size_t>(19);
  for (std::size_t k = 0; k < 3; ++k) format.headers[torque + k] = std::array{"tx", "ty", "tz"}[k];
  // Named, they are read: 2 N press at x = 10 mm - 0.04 N m / 2 N.
  const RecordedTrial trial = read_measurements({path}, format).trials.at(0);
  EXPECT_LT((trial.position_W.col(3) - Vec3(-0.01, 0, 0)).norm(), 1e-9);
  format.markers = TwoMarkers{};
  for (std::size_t k = 13; k < 19; ++k) format.headers[k] = "fx_n";
  EXPECT_THAT(why(), HasSubstr("--sensor-at has no effect beside --markers"));
  format.markers.reset();
  for (std::string& header : format.headers) header.clear();
  format.sensor->says_place = false;  // turned alone: the forces are
  EXPECT_EQ(why(), "taken");
}

TEST(TrialRows, NamesThePiecesOfALongTrialApart) {
  TrialRows rows("long.csv", 1, 3, false);
  for (int i = 0; i < 450; ++i) {
    RecordedRow row;
    row.t_s = 0.1 * i;
    rows.add(row);
  }
  RecordedMeasurement read;
  rows.finish(read);
  ASSERT_EQ(read.trials.size(), 3u);
  EXPECT_EQ(trial_name(read.trials.front()), "long.csv, subject 1, trial 3, piece 1");
  EXPECT_EQ(trial_name(read.trials.back()), "long.csv, subject 1, trial 3, piece 3");
}

TEST(TrialRows, TimesALittleOffTheirGridDrawNoLineAcrossARupture) {
  TrialRows rows("uneven.csv", 1, 3, true);
  for (int i = 0; i < 60; ++i) {
    RecordedRow row;
    row.t_s = 1e-3 * (i + 0.1 * ((i * 7) % 3 - 1));
    row.force_W.x() = i < 30 ? 0.3 : 0.2;
    row.position_W.x() = 1e-4 * i;
    rows.add(row);
  }
  RecordedMeasurement read;
  rows.finish(read);
  ASSERT_EQ(read.trials.size(), 1u);
  const RecordedTrial& trial = read.trials.front();
  ASSERT_GE(trial.samples(), 58);
  for (Eigen::Index k = 0; k < trial.samples(); ++k) {
    const double x = trial.position_W(0, k) / 1e-4;
    EXPECT_NEAR(x, std::round(x), 1e-9) << k << ": no row's own position";
    EXPECT_NEAR(trial.force_W(0, k), x < 29.5 ? 0.3 : 0.2, 1e-12) << k << ": another row's force";
  }
}

TEST(TrialRows, ARowWithoutItsTorqueIsNotRecorded) {
  TrialRows rows("sensor.csv", 1, 3, true);
  for (int i = 0; i < 60; ++i) {
    RecordedRow row;
    row.t_s = 1e-3 * i;
    row.wrench = RecordedWrench{{}, Vec3(0.01 * i, 0, 0), Vec3::Zero()};
    if (i == 30) row.wrench->torque_W_n_m.y() = std::numeric_limits<double>::quiet_NaN();
    rows.add(row);
  }
  RecordedMeasurement read;
  rows.finish(read);
  ASSERT_EQ(read.trials.size(), 1u);
  const RecordedTrial& trial = read.trials.front();
  EXPECT_TRUE(trial.torque_W_n_m.allFinite());
  EXPECT_NEAR(trial.torque_W_n_m(0, 30), 0.3, 1e-9) << "a straight line across the gap";
  EXPECT_EQ(trial.origin[30], SampleOrigin::filled);
  EXPECT_EQ(trial.origin[31], SampleOrigin::recorded);
}

/// Rows of `step_s`, with a gap in the middle.
TrialRows short_trial(double step_s, double gap_s) {
  TrialRows rows("short.csv", 1, 3, true);
  for (int i = 0; i < 20; ++i) {
    RecordedRow row;
    row.t_s = step_s * i + (i < 10 ? 0 : gap_s);
    rows.add(row);
  }
  return rows;
}

TEST(TrialRows, AShortTrialWithAGapIsLeftOutAndOneOfAnotherUnitIsRefused) {
  RecordedMeasurement read;
  short_trial(1e-3, 3).finish(read);
  EXPECT_TRUE(read.trials.empty());
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_THAT(read.warnings.front(), testing::HasSubstr("20 rows between long gaps are left out"));
  for (const auto& [step_s, likely] : {std::pair(2.0, "--time-unit ms (or us)"),
                                       {1000.0, "--time-unit us (or ms)"},
                                       {1e6, "--time-unit ns (or ms)"}}) {
    try {
      short_trial(step_s, 0).finish(read);
      FAIL() << "it was taken";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(likely));
    }
  }
}

/// Forces in the surface's axes and positions in the tracker's are no measurement of a finger pad.
TEST_F(Reading, ALayoutOfTwoFramesIsLeftOutWithItsReason) {
  const std::string path =
      written("foam.xml",
              "<R><SampleRate>1000</SampleRate><PositionUnits>mm</PositionUnits>"
              "<Force><x>0 0</x><y>0 0</y><z>1 2</z></Force><ForceNormal>1 2</ForceNormal>"
              "<Position><x>0 1</x><y>0 1</y><z>0 0</z></Position></R>");
  const RecordedMeasurement read = read_measurements({path}, {}, "hatt");
  EXPECT_TRUE(read.trials.empty());
  ASSERT_EQ(read.without_force.size(), 1u);
  EXPECT_THAT(read.without_force.front(), HasSubstr("forces in the surface's axes and positions in others"));
}

TEST_F(Reading, WhatAPublishedLayoutDoesNotReadIsRefused) {
  const std::string path = written("force.csv", "time,F\n");
  MeasurementFormat markers, normal, plate;
  markers.markers = TwoMarkers{};
  normal.headers[7] = "N";  // nx
  plate.force_on_plate = true;
  const auto refusal_of = [&](const MeasurementFormat& format) {
    return test::why_not([&] { read_measurements({path}, format, "cluster-texture"); });
  };
  EXPECT_THAT(refusal_of(markers), HasSubstr("--markers is not read with --reader cluster-texture"));
  EXPECT_THAT(refusal_of(normal), HasSubstr("the column nx of --columns is not read"));
  EXPECT_THAT(refusal_of(plate), HasSubstr("'force_on' is said of it"));
}

TEST_F(Reading, ASceneOrAProfileIsNoMeasurement) {
  const std::string scene = written("rub.toml", "name = \"rub\"\n[motion]\nfile = \"rub.csv\"\n");
  EXPECT_THAT(test::why_not([&] { read_measurements({scene}, {}); }),
              testing::AllOf(HasSubstr("is TOML, as scenes and profiles are, and no measurement"),
                             HasSubstr("as a scene's [motion] has it in `file`")));
}

}  // namespace
}  // namespace fingerpad::measurement_reader_test
