// Measurements in published layouts: what a fit is told of their units and axes.
#include "study/measurement_field.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>

#include "study/measurement_doubts.hpp"
#include "study/measurement_reader.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::measurement_field_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Columns called as their keys.
MeasurementFormat named(const std::vector<std::string_view>& keys) {
  MeasurementFormat format;
  for (std::size_t k = 0; k < measurement_columns.size(); ++k)
    for (const std::string_view key : keys)
      if (measurement_columns[k].key == key) format.headers[k] = key;
  return format;
}
const std::vector<std::string_view> plain_keys{"t", "x", "y", "z", "fx", "fy", "fz"};

/// Twenty rows, a millisecond apart, of a finger that goes 1 mm a row and is pushed so.
std::string rows(const std::string& head, const Vec3& force, const std::string& rest = "") {
  std::string text = head + "\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{},{},0,0,{},{},{}{}\n", 1e-3 * i, i, force.x(), force.y(), force.z(), rest);
  return text;
}

class MeasurementField : public testing::Test {
 protected:
  RecordedMeasurement read(const std::string& text, const MeasurementFormat& format) const {
    std::ofstream(path) << text;
    return read_measurements({path}, format, "sens3");
  }
  std::string why(const std::string& text, const MeasurementFormat& format) const {
    return test::why_not([&] { read(text, format); });
  }
  const std::string path = (test::scratch_dir() / "s.csv").string();
};

TEST_F(MeasurementField, AForceUnitIsTakenOnceWhetherTheRowSaysItOrAnOption) {
  const std::string head = "t,x,y,z,fx,fy,fz\n";
  MeasurementFormat format = named(plain_keys);
  const Vec3 force(-500, 100, 1000), in_newtons(-0.5, 0.1, 1);
  const auto off = [&](const std::string& text) {
    return (read(text, format).trials.at(0).force_W.col(3) - in_newtons).norm();
  };
  EXPECT_LT(off(rows(head + "s,mm,mm,mm,mN,mN,mN", force)), 1e-15);
  format.says_force_unit = true;
  format.newtons_per_unit = 1e-3;
  EXPECT_LT(off(rows(head + "s,mm,mm,mm,mN,mN,mN", force)), 1e-15);
  EXPECT_LT(off(rows(head + "s,mm,mm,mm,-,-,-", force)), 1e-15);
  format.newtons_per_unit = 1;
  EXPECT_THAT(why(rows(head + "s,mm,mm,mm,mN,mN,mN", force), format),
              HasSubstr("'mN' below 'fx', and force_unit (--force-unit) says another unit"));
  EXPECT_THAT(why(rows(head + "s,mm,mm,mm,V,V,V", force), named(plain_keys)),
              HasSubstr("say force_unit (--force-unit)"));
}

/// A sensor that hangs over head has its z downwards: only in the plate's axes does the plate push the finger
/// away.
TEST_F(MeasurementField, TheSignOfForcesIsJudgedOnceTheSensorIsTurned) {
  std::vector<std::string_view> keys = plain_keys;
  keys.insert(keys.end(), {"tx", "ty", "tz"});
  MeasurementFormat format = named(keys);
  format.says_unit = true;
  format.metres_per_unit = 1e-3;
  const std::string text = rows("t,x,y,z,fx,fy,fz,tx,ty,tz", {-0.5, -0.1, -1}, ",0,0,0");
  EXPECT_THAT(why(text, format), HasSubstr("--force-on plate"));
  format.sensor = SixAxisSensor{Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix(), Vec3::Zero(), 0};
  const RecordedMeasurement turned = read(text, format);
  EXPECT_LT((turned.trials.at(0).force_W.col(3) - Vec3(-0.5, 0.1, 1)).norm(), 1e-12);
  format.sensor->rotation_WS = Mat3::Identity();
  EXPECT_THAT(test::why_not([&] { refuse_doubtful(read(text, format), format, 0); }),
              HasSubstr("how the sensor stands (--sensor-turned)"));
}

/// A metre a row is no finger's way, but its row of units says metres: then no unit is left to be said.
TEST_F(MeasurementField, WhatARowOfUnitsTellsIsNotAskedForAgain) {
  const std::string head = "t,x,y,z,fx,fy,fz\n";
  const MeasurementFormat format = named(plain_keys);
  const RecordedMeasurement told = read(rows(head + "s,m,m,m,N,N,N", {-0.5, 0, 1}), format);
  EXPECT_NO_THROW(refuse_doubtful(told, format, 0));
  EXPECT_THAT(doubts_of(told, format), Contains(HasSubstr("its positions reach over 19000 mm, farther")));
  EXPECT_THAT(told.notes, Contains(HasSubstr("s.csv: units as the line below its header has them: a time is "
                                             "1 s, a position is 1 m, a force is 1 N")));
  MeasurementFormat in_metres = format;  // of the program's own tables
  std::ofstream(path) << rows(head + "s,m,m,m,-,-,-", {-50, 0, 100});
  const RecordedMeasurement own = read_measurements({path}, in_metres);
  EXPECT_THAT(test::why_not([&] { refuse_doubtful(own, in_metres, 0); }), HasSubstr("say --force-unit mN"));
}

TEST_F(MeasurementField, SeveralTrialsInOneFileHaveAWayOut) {
  std::vector<std::string_view> keys = plain_keys;
  keys.push_back("trial");
  const std::string by_column =
      why(rows("t,x,y,z,fx,fy,fz,trial\ns,mm,mm,mm,N,N,N,", {-0.5, 0, 1}, ",1"), named(keys));
  EXPECT_THAT(by_column, HasSubstr("it takes t, x, y, z, fx, fy, fz, fn, tx, ty, tz, speed"));
  EXPECT_THAT(by_column, HasSubstr("--reader table, with subject=... and trial=..."));
  const std::string once = rows("t,x,y,z,fx,fy,fz\ns,mm,mm,mm,N,N,N", {-0.5, 0, 1});
  const std::string twice = once + once.substr(once.find("\n0,") + 1);
  EXPECT_THAT(why(twice, named(plain_keys)),
              HasSubstr("does not come after 0.019 s: one file is one trial here"));
}

TEST_F(MeasurementField, ASpeedsOwnUnitIsRead) {
  std::vector<std::string_view> keys = plain_keys;
  keys.push_back("speed");
  std::string text = "t,x,y,z,fx,fy,fz,speed\ns,mm,mm,mm,N,N,N,m s^-1\n";
  for (int i = 0; i < 400; ++i) text += fmt::format("{},{},0,0,-0.5,0,1,0.1\n", 1e-3 * i, 0.1 * i);
  const RecordedMeasurement told = read(text, named(keys));
  EXPECT_THAT(told.warnings, testing::IsEmpty());
  EXPECT_THAT(told.notes, Contains(HasSubstr("its speeds are 1 times what its positions give")));
}

}  // namespace
}  // namespace fingerpad::measurement_field_test
