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
              HasSubstr("'mN' below 'fx', and --force-unit says another unit"));
  EXPECT_THAT(why(rows(head + "s,mm,mm,mm,V,V,V", force), named(plain_keys)), HasSubstr("say --force-unit"));
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

}  // namespace
}  // namespace fingerpad::measurement_field_test
