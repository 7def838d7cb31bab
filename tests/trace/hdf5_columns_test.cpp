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

}  // namespace
}  // namespace fingerpad::hdf5_columns_test
