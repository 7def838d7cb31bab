#include "trace/hdf5_columns.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/random_stream.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::hdf5_columns_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr hsize_t column_rows = 200000;

/// A file that this test fills.
struct MadeFile {
  std::string path = test::scratch_dir() / "made.h5";
  hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);

  void add(const char* name, hid_t type, hid_t space, hid_t creation) const {
    H5Dclose(H5Dcreate2(id, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  }
};

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
    EXPECT_THAT(error.what(), AllOf(HasSubstr("its columns are compressed to less than one part in 32"),
                                    HasSubstr("h5repack -f t_s:NONE IN.h5 OUT.h5")));
  }
}

/// All of them compressed, as many programs write them, but full of noise: they are read.
TEST(Hdf5Columns, CompressedOnesOfNoiseAreReadWithoutAPlainOne) {
  const MadeFile file;
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, &column_rows, nullptr);
  constexpr hsize_t chunk = 50000;
  H5Pset_chunk(creation, 1, &chunk);
  H5Pset_shuffle(creation);
  H5Pset_deflate(creation, 9);
  RandomStream random(1);
  for (const std::string name : {"t_s", "x_m", "nz"}) {
    std::vector<float> numbers(column_rows, 1);
    for (std::size_t i = 0; i < column_rows && name != "nz"; ++i)
      numbers[i] = static_cast<float>(name == "t_s" ? 1e-3 * static_cast<double>(i) : random.normal());
    const hid_t column =
        H5Dcreate2(file.id, name.c_str(), H5T_IEEE_F32LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    H5Dwrite(column, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(column);
  }
  H5Sclose(space);
  H5Pclose(creation);
  H5Fclose(file.id);
  const Hdf5Columns read = read_hdf5_columns(file.path, {"t_s", "x_m", "nz"});
  EXPECT_EQ(read.columns[0].at(1000), static_cast<double>(1e-3f * 1000));
  EXPECT_EQ(read.columns[2].back(), 1);
  EXPECT_FALSE(read.is_trace);
}

/// A unit as NumPy's bytes and MATLAB write one: of a length, padded; or of h5py, of any length.
TEST(Hdf5Columns, TellTheirUnitHoweverItIsWritten) {
  const MadeFile file;
  constexpr hsize_t few = 2;
  const hid_t space = H5Screate_simple(1, &few, nullptr), scalar = H5Screate(H5S_SCALAR);
  const hid_t padded = H5Tcopy(H5T_C_S1), blanks = H5Tcopy(H5T_C_S1);
  for (const hid_t type : {padded, blanks}) H5Tset_size(type, 4);
  H5Tset_strpad(padded, H5T_STR_NULLPAD);
  H5Tset_strpad(blanks, H5T_STR_SPACEPAD);
  const auto add = [&](const char* name, const char* attribute, hid_t type, const char* text, hid_t shape) {
    const hid_t column =
        H5Dcreate2(file.id, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const double numbers[few] = {1, 2};
    H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers);
    const hid_t unit = H5Acreate2(column, attribute, type, shape, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(unit, type, text);
    H5Aclose(unit);
    H5Dclose(column);
  };
  add("a", "unit", padded, "mm\0\0", scalar);
  add("b", "units", blanks, "ms  ", scalar);
  add("c", "note", padded, "mm\0\0", scalar);
  add("e", "unit", padded, "mm\0\0m\0\0\0", space);
  const double number = 1e-3;
  add("d", "unit", H5T_NATIVE_DOUBLE, reinterpret_cast<const char*>(&number), scalar);
  for (const hid_t type : {padded, blanks}) H5Tclose(type);
  for (const hid_t shape : {space, scalar}) H5Sclose(shape);
  H5Fclose(file.id);
  const auto units = [&](const std::vector<std::string>& names) {
    return read_hdf5_columns(file.path, names).units;
  };
  EXPECT_THAT(units({"a", "b", "c"}), testing::ElementsAre("mm", "ms", ""));
  for (const std::string name : {"d", "e"}) {
    EXPECT_THAT(test::why_not([&] { units({name}); }),
                testing::HasSubstr("the column '" + name +
                                   "' has an attribute 'unit' that is no single text, as m or mm are"));
  }
}

/// Columns t_s and x_m of four numbers in these shapes, at the root or in a group.
std::string shaped(const std::vector<hsize_t>& shape, bool is_nested) {
  const std::string path = test::scratch_dir() / "shaped.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t parent = is_nested ? H5Gcreate2(file, "run1", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : file;
  const std::vector<double> numbers{0, 1, 2, 3, 4, 5, 6, 7};
  for (const char* name : {"t_s", "x_m"}) {
    const hid_t space = shape.empty()
                            ? H5Screate(H5S_SCALAR)
                            : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
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

TEST(Hdf5Contents, AreDatasetsWithTheirShapesAndGroups) {
  EXPECT_EQ(read_hdf5_contents(shaped({4, 1}, false)), "it holds t_s (4 x 1), x_m (4 x 1)");
  const std::string nested = shaped({4}, true);
  EXPECT_FALSE(read_hdf5_columns(nested, {"t_s"}).present[0]);
  EXPECT_EQ(read_hdf5_contents(nested), "it holds the group run1 with t_s (4), x_m (4)");
  EXPECT_EQ(read_hdf5_contents(shaped({2, 2, 2}, false)), "it holds t_s (2 x 2 x 2), x_m (2 x 2 x 2)");
  EXPECT_EQ(read_hdf5_contents(shaped({}, false)), "it holds t_s (a scalar), x_m (a scalar)");
}

/// HDF5 may open the source of a virtual dataset to tell its size. Of a pipe it would wait for ever.
TEST(Hdf5Contents, OpenNoOtherFile) {
  const std::string pipe = test::scratch_dir() / "pipe.h5";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const MadeFile file;
  constexpr hsize_t few = 4, none = 0, one = 1, unlimited = H5S_UNLIMITED;
  const hid_t space = H5Screate_simple(1, &few, nullptr), growing = H5Screate_simple(1, &few, &unlimited);
  H5Sselect_hyperslab(growing, H5S_SELECT_SET, &none, nullptr, &unlimited, &one);
  const hid_t put_together = H5Pcreate(H5P_DATASET_CREATE), elsewhere = H5Pcreate(H5P_DATASET_CREATE);
  ASSERT_GE(H5Pset_virtual(put_together, growing, pipe.c_str(), "x", growing), 0);
  ASSERT_GE(H5Pset_external(elsewhere, pipe.c_str(), 0, few * sizeof(double)), 0);
  file.add("a", H5T_IEEE_F64LE, growing, put_together);
  file.add("b", H5T_IEEE_F64LE, space, elsewhere);
  file.add("c", H5T_C_S1, space, H5P_DEFAULT);
  for (const hid_t list : {put_together, elsewhere}) H5Pclose(list);
  for (const hid_t shape : {space, growing}) H5Sclose(shape);
  H5Fclose(file.id);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(read_hdf5_contents(file.path),
            "it holds a (a virtual dataset, put together from others), b (in another file, as external "
            "storage), c (4, no numbers)");
  // A child that waits for the pipe is ended after more than a minute.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(Hdf5Contents, SayHowManyMoreThereAre) {
  const MadeFile file;
  for (const auto& [group_name, count] : {std::pair("few", 15), std::pair("many", 2000)}) {
    const hid_t group = H5Gcreate2(file.id, group_name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    for (int i = 0; i < count; ++i)
      H5Lcreate_soft("/nowhere", group, fmt::format("link{:05}", i).c_str(), H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(group);
  }
  H5Fclose(file.id);
  const std::string words = read_hdf5_contents(file.path);
  EXPECT_THAT(words, HasSubstr("the group few with link00000, link00001"));
  EXPECT_THAT(words, HasSubstr("link00011, and 3 more, the group many with link00000"));
  EXPECT_THAT(words, testing::EndsWith("link00011, and more than 988 more"));
}

}  // namespace
}  // namespace fingerpad::hdf5_columns_test
