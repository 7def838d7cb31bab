#include "trace/hdf5_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include "base/error.hpp"
#include "support/paths.hpp"

namespace fingerpad::hdf5_columns_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr hsize_t column_rows = 200000;

void write_column(hid_t file, const std::string& name, bool is_deflated) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  constexpr hsize_t chunk = 50000;
  if (is_deflated) {
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 6);
  }
  const hid_t space = H5Screate_simple(1, &column_rows, nullptr);
  const hid_t column =
      H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  const std::vector<double> numbers(column_rows, 0.5);
  H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  H5Dclose(column);
  H5Sclose(space);
  H5Pclose(creation);
}

std::vector<std::string> column_names() {
  std::vector<std::string> names{"t_s"};
  for (int i = 0; i < 12; ++i) names.push_back("c" + std::to_string(i));
  return names;
}

std::string written(bool is_time_deflated) {
  const std::string path = test::scratch_dir() / "m.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  for (const std::string& name : column_names()) write_column(file, name, is_time_deflated || name != "t_s");
  H5Fclose(file);
  return path;
}

/// Twelve columns that unfold to more than eight times the file.
TEST(Hdf5Columns, DeflatedOnesAreReadBesideAPlainTime) {
  const Hdf5Columns read = read_hdf5_columns(written(false), column_names());
  for (const std::vector<double>& column : read.columns) {
    ASSERT_EQ(column.size(), column_rows);
    EXPECT_EQ(column.back(), 0.5);
  }
}

TEST(Hdf5Columns, ADeflatedTimeIsRefusedWithItsMend) {
  const std::string path = written(true);
  try {
    read_hdf5_columns(path, column_names());
    FAIL() << "is read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("the column 't_s' is compressed"),
                                    HasSubstr("h5repack -f t_s:NONE IN.h5 OUT.h5")));
  }
}

/// Columns t_s and x_m of four numbers in these shapes, at the root or in a group.
std::string shaped(const std::vector<hsize_t>& shape, bool is_nested) {
  const std::string path = test::scratch_dir() / "shaped.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t parent = is_nested ? H5Gcreate2(file, "run1", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : file;
  const std::vector<double> numbers{0, 1, 2, 3, 4, 5, 6, 7};
  for (const char* name : {"t_s", "x_m"}) {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t column =
        H5Dcreate2(parent, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(column);
    H5Sclose(space);
  }
  if (is_nested) H5Gclose(parent);
  H5Fclose(file);
  return path;
}

/// As MATLAB and others write a row of numbers.
TEST(Hdf5Columns, OfOneColumnOrOneRowAreReadAsARowOfNumbers) {
  for (const std::vector<hsize_t>& shape : {std::vector<hsize_t>{4}, {4, 1}, {1, 4}}) {
    const Hdf5Columns read = read_hdf5_columns(shaped(shape, false), {"t_s", "x_m"});
    EXPECT_EQ(read.columns[0], (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(read.columns[1], read.columns[0]);
  }
}

TEST(Hdf5Columns, OfAnotherShapeAreRefusedWithIt) {
  const std::string path = shaped({4, 2}, false);
  try {
    read_hdf5_columns(path, {"t_s"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the column 't_s' is 4 x 2; a column is N numbers (or N x 1)"));
  }
}

TEST(Hdf5Columns, SayWhatTheFileHolds) {
  EXPECT_EQ(read_hdf5_columns(shaped({4, 1}, false), {"t_s"}).contents, "it holds t_s (4 x 1), x_m (4 x 1)");
  const Hdf5Columns nested = read_hdf5_columns(shaped({4}, true), {"t_s"});
  EXPECT_FALSE(nested.present[0]);
  EXPECT_EQ(nested.contents, "it holds the group run1 with t_s (4), x_m (4)");
}

}  // namespace
}  // namespace fingerpad::hdf5_columns_test
