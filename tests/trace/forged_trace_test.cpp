// Traces made to harm whoever opens them: with HDF5's own means to point elsewhere, or with damage under a
// right seal, which anyone can make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <random>
#include <thread>

#include <sys/stat.h>

#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "touch/world.hpp"
#include "trace/file_seal.hpp"
#include "trace/trace_column.hpp"
#include "trace_rows.hpp"

namespace fingerpad::forged_trace_test {
namespace {

using test::refusal;
using test::some_rows;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr hsize_t row_count = 100;

/// A part of 24 triangles and a plane.
World small_world() {
  World world;
  Surface box;
  box.part = std::make_shared<const Part>(make_part(test::box_soup(Vec3(0.04, 0.03, 0.02)), 0.5));
  box.mesh = "box.stl";
  world.surfaces = {box, Surface{}};
  return world;
}

class ForgedTrace : public testing::Test {
 protected:
  /// What is said to a whole, sealed trace after `change(file)`.
  std::string refusal_of(const std::function<void(hid_t)>& change, const World& world = {}) const {
    const std::string path = folder_ / "t.h5";
    test::write_trace(path, TraceFormat::hdf5, some_rows(row_count), world);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    seal_file(path);
    return refusal(path);
  }

  /// Another file of the user's, with numbers in it.
  std::string secret() const {
    const std::vector<double> numbers(row_count, 31415.9265);
    const std::string bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    std::ofstream(folder_ / "secret", std::ios::binary) << bytes;
    return folder_ / "secret";
  }
  /// Opening this one waits for a writer, for ever.
  std::string fifo() const {
    mkfifo((folder_ / "fifo").c_str(), 0600);
    return folder_ / "fifo";
  }
  /// Another trace, whose x_m is there for the taking.
  std::string other_trace() const {
    test::write_trace(folder_ / "other.h5", TraceFormat::hdf5, some_rows(row_count));
    return folder_ / "other.h5";
  }
  /// A small trace without its seal.
  std::string whole_trace() const {
    const std::string path = folder_ / "whole.h5";
    test::write_trace(path, TraceFormat::hdf5, some_rows(20), small_world());
    return test::bytes_of(path).substr(0, std::filesystem::file_size(path) - 32);
  }

  const std::filesystem::path folder_ = test::scratch_dir();
};

/// Puts a column of `rows` numbers, of this kind of storage, in the place of x_m.
void replace_x(hid_t file, hid_t creation, hid_t type = H5T_IEEE_F64LE, hsize_t rows = row_count) {
  H5Ldelete(file, "x_m", H5P_DEFAULT);
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t column = H5Dcreate2(file, "x_m", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  ASSERT_GE(column, 0);
  H5Dclose(column);
  H5Sclose(space);
  H5Pclose(creation);
}

TEST_F(ForgedTrace, OtherFilesAreNotReadAsAColumn) {
  for (const std::string& target : {secret(), fifo()}) {
    const std::string message = refusal_of([&](hid_t file) {
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_external(creation, target.c_str(), 0, row_count * sizeof(double));
      replace_x(file, creation);
    });
    EXPECT_THAT(message,
                HasSubstr("t.h5: is refused: column 'x_m' keeps its numbers in another file (external "
                          "storage)"));
    EXPECT_THAT(message, AllOf(Not(HasSubstr("31415")), Not(HasSubstr("secret"))));
  }
}

TEST_F(ForgedTrace, LinksIntoOtherFilesAreNotFollowed) {
  for (const std::string& target : {other_trace(), fifo()}) {
    for (const char* name : {"x_m", "surfaces"}) {
      const std::string message = refusal_of([&](hid_t file) {
        H5Ldelete(file, name, H5P_DEFAULT);
        H5Lcreate_external(target.c_str(), name, file, name, H5P_DEFAULT, H5P_DEFAULT);
      });
      EXPECT_THAT(message, AllOf(HasSubstr("is refused: "), HasSubstr(std::string("'") + name + "'"),
                                 HasSubstr("is a link into another file (external link)")));
    }
  }
}

TEST_F(ForgedTrace, SoftLinksAreNotFollowed) {
  EXPECT_THAT(refusal_of([&](hid_t file) {
                H5Ldelete(file, "x_m", H5P_DEFAULT);
                H5Lcreate_external(fifo().c_str(), "/", file, "outside", H5P_DEFAULT, H5P_DEFAULT);
                H5Lcreate_soft("/outside/x_m", file, "x_m", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("is refused: column 'x_m' is a link to another place (soft link)"));
  EXPECT_THAT(refusal_of([](hid_t file) {
                H5Ldelete(file, "x_m", H5P_DEFAULT);
                H5Lcreate_soft("x_m", file, "x_m", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("(soft link)"));
}

TEST_F(ForgedTrace, VirtualDatasetsAreRefused) {
  for (const std::string& target : {other_trace(), fifo()}) {
    EXPECT_THAT(refusal_of([&](hid_t file) {
                  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
                  const hid_t space = H5Screate_simple(1, &row_count, nullptr);
                  H5Pset_virtual(creation, space, target.c_str(), "x_m", space);
                  H5Sclose(space);
                  replace_x(file, creation);
                }),
                HasSubstr("is refused: column 'x_m' is put together from other datasets (virtual dataset)"));
  }
}

/// A filter that HDF5 does not have in itself is looked for among the user's plugins, and loaded.
TEST_F(ForgedTrace, OtherFiltersThanDeflateAreRefusedWithTheirMend) {
  constexpr unsigned value = 1;
  for (const H5Z_filter_t filter : {H5Z_FILTER_FLETCHER32, H5Z_FILTER_SCALEOFFSET, H5Z_filter_t{32015}}) {
    EXPECT_THAT(refusal_of([&](hid_t file) {
                  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
                  H5Pset_chunk(creation, 1, &row_count);
                  H5Pset_filter(creation, filter, H5Z_FLAG_OPTIONAL, 1, &value);
                  replace_x(file, creation);
                }),
                AllOf(HasSubstr("is refused: column 'x_m' passes through filters that no trace has"),
                      HasSubstr("h5repack -f NONE")));
  }
}

/// One deflate within another unfolds a thousand times a thousand times.
TEST_F(ForgedTrace, AFilterTwiceIsRefused) {
  const auto message_of = [&](const std::vector<H5Z_filter_t>& filters) {
    return refusal_of([&](hid_t file) {
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(creation, 1, &row_count);
      constexpr unsigned level = 9;
      for (const H5Z_filter_t filter : filters)
        H5Pset_filter(creation, filter, H5Z_FLAG_MANDATORY, filter == H5Z_FILTER_DEFLATE ? 1 : 0, &level);
      replace_x(file, creation);
    });
  };
  for (const H5Z_filter_t filter : {H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE})
    EXPECT_THAT(message_of({filter, filter}), HasSubstr("'x_m' passes through filters that no trace has"));
  EXPECT_THAT(message_of({H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE}), Not(HasSubstr("filters")));
}

void deflate_column(hid_t file, const char* name, hsize_t rows) {
  H5Ldelete(file, name, H5P_DEFAULT);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 1, &rows);
  H5Pset_deflate(creation, 9);
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t column = H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  const std::vector<double> zeros(rows);
  H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
  H5Dclose(column);
  H5Sclose(space);
  H5Pclose(creation);
}

/// Zeros deflate to a thousandth: time, which is never deflated, bounds what a trace unfolds to.
TEST_F(ForgedTrace, ManyDeflatedRowsNeedTimesThatAreThere) {
  EXPECT_THAT(refusal_of([](hid_t file) { deflate_column(file, "t_s", row_count); }),
              HasSubstr("column 't_s' is compressed, which no trace's is"));
  EXPECT_THAT(refusal_of([](hid_t file) { deflate_column(file, "mu", 60000); }),
              HasSubstr("is damaged: its columns have from 100 to 60000 rows"));
  EXPECT_EQ(refusal_of([](hid_t file) { deflate_column(file, "mu", row_count); }), "");
}

TEST_F(ForgedTrace, RowsWithoutBytesAreRefused) {
  // Fewer than the file has bytes, so that the file as a whole could hold them.
  const hsize_t rows = 150000;
  EXPECT_THAT(refusal_of([&](hid_t file) {
                for (const TraceColumn& column : trace_columns({})) {
                  const hid_t dataset = H5Dopen2(file, std::string(column.name).c_str(), H5P_DEFAULT);
                  H5Dset_extent(dataset, &rows);
                  H5Dclose(dataset);
                }
              }),
              HasSubstr("is damaged: column 't_s' has 150000 rows, but bytes for 1024 alone"));
  EXPECT_THAT(refusal_of([](hid_t file) { replace_x(file, H5Pcreate(H5P_DATASET_CREATE)); }),
              HasSubstr("is damaged: column 'x_m' has 100 rows, but bytes for 0 alone"));
}

TEST_F(ForgedTrace, WhatIsNoColumnOfNumbersIsRefused) {
  EXPECT_THAT(refusal_of([](hid_t file) {
                H5Ldelete(file, "x_m", H5P_DEFAULT);
                H5Gclose(H5Gcreate2(file, "x_m", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
              }),
              HasSubstr("is refused: column 'x_m' is a group"));
  EXPECT_THAT(refusal_of([](hid_t file) {
                H5Ldelete(file, "x_m", H5P_DEFAULT);
                const hid_t type = H5Tcopy(H5T_NATIVE_INT);
                H5Tcommit2(file, "x_m", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                H5Tclose(type);
              }),
              HasSubstr("is refused: column 'x_m' is a data type"));
  EXPECT_THAT(
      refusal_of([](hid_t file) {
        H5Ldelete(file, "surfaces", H5P_DEFAULT);
        const hid_t space = H5Screate(H5S_SCALAR);
        H5Dclose(H5Dcreate2(file, "surfaces", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        H5Sclose(space);
      }),
      HasSubstr("is refused: group 'surfaces' is a dataset"));
  const hid_t text = H5Tcopy(H5T_C_S1), wide = H5Tcopy(H5T_NATIVE_INT);
  H5Tset_size(wide, 1 << 20);
  for (const hid_t type : {text, wide, H5T_NATIVE_LDOUBLE}) {
    EXPECT_THAT(refusal_of([=](hid_t file) { replace_x(file, H5Pcreate(H5P_DATASET_CREATE), type); }),
                HasSubstr("column 'x_m' is no column of numbers"));
  }
}

TEST_F(ForgedTrace, ACircleOfGroupsEnds) {
  const std::string message = refusal_of(
      [](hid_t file) {
        H5Ldelete(file, "surfaces/0", H5P_DEFAULT);
        H5Lcreate_hard(file, "surfaces", file, "surfaces/0", H5P_DEFAULT, H5P_DEFAULT);
      },
      small_world());
  EXPECT_THAT(message, HasSubstr("is damaged or no trace: cannot read stiffness_n_per_m"));
}

/// One large surface under a hundred thousand names is more than its file could hold.
TEST_F(ForgedTrace, OneSurfaceUnderManyNamesIsRefused) {
  World world;
  Surface large;
  large.part = std::make_shared<const Part>(make_part(test::square_soup(1, 100), 0.5));  // 20,000 triangles
  world.surfaces.push_back(large);
  const std::string message = refusal_of(
      [](hid_t file) {
        const hid_t surfaces = H5Gopen2(file, "surfaces", H5P_DEFAULT);
        constexpr int count = 2000;
        for (int i = 1; i < count; ++i) {
          H5Lcreate_hard(surfaces, "0", surfaces, std::to_string(i).c_str(), H5P_DEFAULT, H5P_DEFAULT);
        }
        const hid_t attribute = H5Aopen(surfaces, "count", H5P_DEFAULT);
        H5Awrite(attribute, H5T_NATIVE_INT, &count);
        H5Aclose(attribute);
        H5Gclose(surfaces);
      },
      world);
  EXPECT_THAT(message, HasSubstr("is damaged: it unfolds to more than a file of its size"));
}

void write_sealed(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  seal_file(path);
}

TEST_F(ForgedTrace, DamageUnderARightSealIsReadOrRefused) {
  const std::string whole = whole_trace(), path = folder_ / "t.h5";
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> place(0, whole.size() - 1);
  const int rounds = test::samples(280) + 40;
  int kept = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string damaged = whole;
    // HDF5's own records stand everywhere between the columns' chunks, mostly at the start.
    const std::size_t end = round % 2 == 0 ? 6000 : whole.size();
    for (int i = 0; i <= round % 4; ++i) damaged[place(random) % end] = static_cast<char>(random());
    write_sealed(path, damaged);
    const std::string message = refusal(path);
    EXPECT_THAT(message, Not(HasSubstr("not refused but failed")));
    kept += static_cast<int>(message.empty());
  }
  EXPECT_GT(kept, 0);  // among numbers, and in what HDF5 leaves unused
  EXPECT_LT(kept, rounds);
}

TEST_F(ForgedTrace, ManyThreadsReadAndWriteAtOnce) {
  if (!test::forks_beside_threads())
    GTEST_SKIP()
        << "the address sanitizer's allocator may be locked by another thread when a child is forked";
  const std::string whole = whole_trace();
  write_sealed(folder_ / "whole.h5", whole);
  std::string broken = whole;
  broken.replace(96, 900, 900, '\xff');
  write_sealed(folder_ / "broken.h5", broken);
  ASSERT_NE(refusal(folder_ / "broken.h5"), "");
  std::atomic<int> read = 0, refused = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < 25; ++round) {
        read += static_cast<int>(refusal(folder_ / "whole.h5").empty());
        refused += static_cast<int>(!refusal(folder_ / "broken.h5").empty());
        if (round % 10 == 0)
          test::write_trace(folder_ / (std::to_string(t) + ".h5"), TraceFormat::hdf5, some_rows(2000));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read, 100);
  EXPECT_EQ(refused, 100);
}

}  // namespace
}  // namespace fingerpad::forged_trace_test
