// Recordings of somebody's own as HDF5, as a scene asks for them.
#include "trace/hdf5_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene_file.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad::hdf5_motion_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

struct Column {
  std::string name, unit;
  std::vector<double> values;
};

/// Two trials of three rows; times in ms, positions in mm.
std::vector<Column> two_trials() {
  return {{"t_ms", "ms", {0, 1, 2, 0, 1, 2}}, {"X", "mm", {1, 2, 3, 4, 5, 6}},
          {"Y", "mm", {0, 0, 0, 0, 0, 0}},    {"Z", "mm", {-1, -1, -1, -1, -1, -1}},
          {"Fx", "mN", {1, 2, 3, 4, 5, 6}},   {"Fy", "mN", {0, 0, 0, 0, 0, 0}},
          {"Fz", "mN", {9, 9, 9, 9, 9, 9}},   {"trial", "", {1, 1, 1, 2, 2, 2}}};
}

class Hdf5Motion : public testing::Test {
 protected:
  std::string written(const std::vector<Column>& columns) const {
    hdf5::Handle file = hdf5::create_file(path);
    for (const Column& column : columns)
      hdf5::append(hdf5::create_column(file, column.name, hdf5::NumberType::float64, column.unit), 0,
                   column.values);
    hdf5::close_file(std::move(file));
    return path;
  }
  RecordingFormat named() const {
    RecordingFormat format;
    const char* const names[] = {"t_ms", "X", "Y", "Z"};
    std::copy(std::begin(names), std::end(names), format.headers.begin());
    return format;
  }
  const std::string path = test::scratch_dir() / "own.h5";
};

TEST_F(Hdf5Motion, IsReadWithItsColumnsItsTrialAndTheUnitsThatItsDatasetsName) {
  written(two_trials());
  RecordingFormat format = named();
  for (std::size_t axis = 0; axis < 3; ++axis)
    format.headers[place_of_fx + axis] = std::string("F") + "xyz"[axis];
  format.trial = 2;
  const Motion motion = read_motion_hdf5(path, format);
  EXPECT_THAT(motion.t_s, ElementsAre(0, 1e-3, 2e-3));
  EXPECT_EQ(motion.p_WQ.col(1), Vec3(5e-3, 0, -1e-3));
  EXPECT_LT((motion.force_W_n.col(2) - Vec3(6e-3, 0, 9e-3)).norm(), 1e-15);  // rounding
  EXPECT_TRUE(format.says_time_unit);
}

TEST_F(Hdf5Motion, AUnitThatIsNotKnownOrContradictedIsRefusedByName) {
  std::vector<Column> columns = two_trials();
  columns[1].unit = "furlong";
  written(columns);
  RecordingFormat format = named();
  format.trial = 1;
  EXPECT_THAT(
      test::why_not([&] { read_motion_hdf5(path, format); }),
      AllOf(HasSubstr("has the unit 'furlong' at 'X', which is no unit of length that is known (m, mm, "
                      "cm, in, um): delete the attribute, and say unit in [motion]"),
            Not(HasSubstr("line"))));
  written(two_trials());
  format.says_unit = true;
  EXPECT_THAT(
      test::why_not([&] { read_motion_hdf5(path, format); }),
      HasSubstr("has the unit 'mm' at 'X', and unit in [motion] says another unit: leave that out, or "
                "delete the attribute if it is wrong"));
}

TEST_F(Hdf5Motion, AUnitThatADatasetsNameAloneSaysIsAskedFor) {
  std::vector<Column> columns = two_trials();
  columns[1].name = "X [cm]";
  for (std::size_t k = 1; k < 4; ++k) columns[k].unit = "";
  written(columns);
  RecordingFormat format = named();
  format.headers[1] = "X [cm]";
  format.trial = 1;
  EXPECT_THAT(
      test::why_not([&] { read_motion_hdf5(path, format); }),
      HasSubstr("has the column 'X [cm]', whose name says a unit that is not said: say unit in [motion], "
                "\"cm\" if it is right"));
  columns[1].unit = "cm";
  written(columns);
  EXPECT_EQ(read_motion_hdf5(path, format).p_WQ(0, 0), 1e-2) << "an attribute says it for all";
}

TEST_F(Hdf5Motion, AsksForWhatItLacksAndRefusesWhatIsOfTextsAlone) {
  written(two_trials());
  RecordingFormat format;
  EXPECT_THAT(test::why_not([&] { read_motion_hdf5(path, format); }),
              AllOf(HasSubstr("has no dataset 't_s'"), HasSubstr("it holds Fx (6), Fy (6)"),
                    HasSubstr("say [motion] columns = { t = \"time\" }")));
  format = named();
  EXPECT_THAT(test::why_not([&] { read_motion_hdf5(path, format); }),
              HasSubstr("own.h5:4: time 0 s does not come after 0.002 s; sort the rows by time; of a table "
                        "of several trials say"));
  format.dialect.separator = ';';
  EXPECT_THAT(test::why_not([&] { read_motion_hdf5(path, format); }),
              HasSubstr("'separator' in [motion] says how a table of text is read, and this is HDF5"));
  std::vector<Column> columns = two_trials();
  columns[3].values[2] = std::numeric_limits<double>::quiet_NaN();
  written(columns);
  format = named();
  EXPECT_THAT(test::why_not([&] { read_motion_hdf5(path, format); }),
              HasSubstr("own.h5:3: holds no finite number in column 'Z'"));
}

TEST_F(Hdf5Motion, IsAScenesMotionAsATableOfTextIs) {
  const auto loaded = [this](const std::string& keys) {
    const std::string text =
        "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\nfile = \"own.h5\"\n" + keys;
    const Scene scene = read_scene_text(text, (test::scratch_dir() / "s.toml").string()).scene;
    written(two_trials());
    return load_motion(scene);
  };
  const LoadedMotion motion =
      loaded("trial = 1\ncolumns = { t = \"t_ms\", x = \"X\", y = \"Y\", z = \"Z\" }\n");
  EXPECT_EQ(motion.path.tick_count(), 3);
  EXPECT_EQ(motion.path.rate_hz(), 1000);
  EXPECT_THAT(motion.notes, testing::Contains(HasSubstr(
                                "own.h5: t is 't_ms', x is 'X', y is 'Y', z is 'Z'; positions in mm; "
                                "times in ms")));
  EXPECT_THAT(test::why_not([&] { loaded(""); }), HasSubstr("has no dataset 't_s'"));
}

}  // namespace
}  // namespace fingerpad::hdf5_motion_test
