#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdlib>

#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "trace/export.hpp"
#include "trace/trace_column.hpp"
#include "trace_rows.hpp"

namespace fingerpad::trace_reader_test {
namespace {

using test::refusal;
using test::some_rows;
using testing::HasSubstr;

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A file with a column changed by `change(file)`.
template <typename Change>
std::filesystem::path changed_trace(const std::string& name, Change change) {
  auto path = test::scratch_dir() / name;
  test::write_trace(path, TraceFormat::hdf5, some_rows(100));
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  change(file);
  H5Fclose(file);
  return path;
}

TEST(TraceReader, ReadsATraceOfAProgramThatDidNotCountRuptures) {
  const auto h5 = changed_trace("old.h5", [](hid_t file) { H5Ldelete(file, "ruptures", H5P_DEFAULT); });
  const Trace trace = read_trace(h5.string());
  ASSERT_GT(trace.rows.size(), 4u);
  for (const TickRecord& row : trace.rows) EXPECT_EQ(row.ruptures, 0);
}

TEST(TraceReader, CountsOneWallWhereNoMoreCanHoldTheFinger) {
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    const auto path = test::scratch_dir() / (format == TraceFormat::csv ? "t.csv" : "t.h5");
    test::write_trace(path, format, some_rows(8));
    for (const TickRecord& row : read_trace(path.string()).rows)
      EXPECT_EQ(row.walls, row.phase == Phase::free ? 0 : 1);
  }
}

TEST(TraceReader, RefusesWhatIsNoTrace) {
  const auto folder = test::scratch_dir();
  write_text(folder / "empty", "");
  EXPECT_THAT(refusal(folder / "empty"), HasSubstr("empty: is empty"));
  write_text(folder / "words", "Lorem ipsum\n");
  EXPECT_THAT(refusal(folder / "words"), HasSubstr("words:1: is no trace: it has no column 't_s'"));
  EXPECT_THAT(refusal(folder / "absent"), HasSubstr("absent: cannot be read"));
  EXPECT_THAT(refusal(folder), HasSubstr("is a folder"));
  write_text(folder / "stub.h5", "\x89HDF\r\n\x1a\n and nothing");
  EXPECT_THAT(refusal(folder / "stub.h5"), HasSubstr("is no HDF5 file that can be read"));
  const auto foreign = folder / "foreign.h5";
  H5Fclose(H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(refusal(foreign),
              HasSubstr("foreign.h5: is no trace: it has no column 't_s'; it holds nothing"));
}

TEST(TraceReader, NamesTheMissingColumn) {
  EXPECT_THAT(refusal(changed_trace("t.h5", [](hid_t file) { H5Ldelete(file, "mu", H5P_DEFAULT); })),
              HasSubstr("is no trace: it has no column 'mu'"));
  const auto path = test::scratch_dir() / "t.csv";
  write_text(path, "t_s,x_m,y_m,z_m\n0,0,0,0\n");
  EXPECT_THAT(refusal(path), HasSubstr("t.csv:1: is no trace: it has no column 'phase'"));
}

TEST(TraceReader, RefusesColumnsOfUnlikeLengthInAWholeTrace) {
  const auto path = changed_trace("t.h5", [](hid_t file) {
    const hid_t column = H5Dopen2(file, "mu", H5P_DEFAULT);
    const hsize_t rows = 99;
    H5Dset_extent(column, &rows);
    H5Dclose(column);
  });
  EXPECT_THAT(refusal(path), HasSubstr("its columns have from 99 to 100 rows"));
}

TEST(TraceReader, InATraceCutShortTheShortestColumnCounts) {
  const auto path = changed_trace("t.h5", [](hid_t file) {
    const hid_t column = H5Dopen2(file, "mu", H5P_DEFAULT);
    const hsize_t rows = 60;
    H5Dset_extent(column, &rows);
    H5Dclose(column);
    const hid_t complete = H5Aopen(file, "complete", H5P_DEFAULT);
    const unsigned char no = 0;
    H5Awrite(complete, H5T_NATIVE_UCHAR, &no);
    H5Aclose(complete);
  });
  const Trace trace = read_trace(path.string());
  EXPECT_FALSE(trace.complete);
  EXPECT_EQ(trace.rows.size(), 60u);
  EXPECT_EQ(early_end_words(trace),
            "is of a recording that was cut short or is still being written; read up to t = 0.059 s");
}

TEST(TraceReader, RefusesAbsurdLengthsBeforeTakingMemory) {
  const auto path = changed_trace("t.h5", [](hid_t file) {
    const hsize_t rows = hsize_t{1} << 50;
    for (const TraceColumn& column : trace_columns({})) {
      const hid_t dataset = H5Dopen2(file, std::string(column.name).c_str(), H5P_DEFAULT);
      H5Dset_extent(dataset, &rows);
      H5Dclose(dataset);
    }
  });
  EXPECT_THAT(refusal(path), HasSubstr("is damaged: 1125899906842624 rows in"));
}

TEST(TraceReader, RefusesRowsThatNoRunWrites) {
  const auto put = [](const char* name, double value) {
    return changed_trace("t.h5", [=](hid_t file) {
      const hid_t column = H5Dopen2(file, name, H5P_DEFAULT);
      std::vector<double> values(100, 0);
      values[7] = value;
      H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      H5Dclose(column);
    });
  };
  EXPECT_THAT(refusal(put("x_m", std::nan(""))), HasSubstr("row 8: a time or position is not finite"));
  EXPECT_THAT(refusal(put("phase", 3)), HasSubstr("row 8: the phase is none of"));
  EXPECT_THAT(refusal(put("part", -2)), HasSubstr("row 8: a part or triangle"));
}

TEST(TraceReader, BadCsvCellsNameTheirLine) {
  const auto folder = test::scratch_dir();
  test::write_trace(folder / "t.csv", TraceFormat::csv, some_rows(3));
  const std::string good = test::bytes_of(folder / "t.csv");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    write_text(folder / "bad.csv", text);
    return refusal(folder / "bad.csv");
  };
  EXPECT_THAT(with(",slip,", ",slid,"), HasSubstr("bad.csv:3: 'slid' in column 'phase' is no phase"));
  EXPECT_THAT(with(",slip,0.5", ",slip,zwei"),
              HasSubstr("bad.csv:3: 'zwei' in column 'depth_m' is no number"));
  EXPECT_THAT(with(",slip,0.5", ",slip,0.5,1"), HasSubstr("bad.csv:3: has 27 cells, but the header has 26"));
  EXPECT_THAT(with("\n0.001,", "\ninf,"), HasSubstr("bad.csv:3: a time or position is not finite"));
  EXPECT_THAT(with(",-1,-1\n", ",-1,1.5\n"), HasSubstr("bad.csv:2: a part or triangle"));
}

TEST(TraceReader, OfACsvCutShortTheLastRowIsLeftOutWhateverItsName) {
  const auto folder = test::scratch_dir();
  test::write_trace(folder / "t.csv", TraceFormat::csv, some_rows(3));
  const std::string whole = test::bytes_of(folder / "t.csv");
  // Where all cells are there the last number may still lack digits.
  for (const std::size_t end : {whole.rfind(','), whole.size() - 1}) {
    for (const char* name : {"kept.csv", "t2.csv.part"}) {
      write_text(folder / name, whole.substr(0, end));
      const Trace trace = read_trace((folder / name).string());
      EXPECT_EQ(trace.rows.size(), 2u) << name;
      EXPECT_FALSE(trace.complete) << name;
      const std::string part = std::string(name) == "kept.csv"
                                   ? ""
                                   : "is of a recording that was cut short or is still being written, and ";
      EXPECT_EQ(early_end_words(trace), part + "ends within a row (line 4); read up to t = 0.001 s");
    }
  }
  write_text(folder / "header.csv", whole.substr(0, whole.find('\n')));
  EXPECT_THAT(
      test::why_not([&] { read_trace((folder / "header.csv").string()); }),
      testing::EndsWith("header.csv: ends within its header (line 1): no row of it is left; make it again"));
  write_text(folder / "t.csv.part", whole);
  EXPECT_EQ(early_end_words(read_trace((folder / "t.csv.part").string())),
            "is of a recording that was cut short or is still being written; read up to t = 0.002 s");
  EXPECT_EQ(early_end_words(read_trace((folder / "t.csv").string())), "");
}

TEST(TraceReader, CsvColumnsMayStandInAnyOrderAmongOthers) {
  const auto path = test::scratch_dir() / "t.csv";
  std::string header = "extra", row = "7";
  for (std::size_t k = trace_columns().size(); k-- > 0;) {
    header += "," + std::string(trace_columns()[k].name);
    row += trace_columns()[k].name == "phase" ? ",stick" : trace_columns()[k].name == "x_m" ? ",0.25" : ",1";
  }
  write_text(path, "\xef\xbb\xbf" + header + "\r\n" + row + "\r\n");
  const Trace trace = read_trace(path.string());
  ASSERT_EQ(trace.rows.size(), 1u);
  EXPECT_EQ(trace.rows[0].p_WQ, Vec3(0.25, 1, 1));
  EXPECT_EQ(trace.rows[0].phase, Phase::stick);
}

TEST(TraceReader, AnyDamageToAFinishedTraceIsSeen) {
  const auto folder = test::scratch_dir();
  test::write_trace(folder / "whole.h5", TraceFormat::hdf5, some_rows(50));
  const std::string whole = test::bytes_of(folder / "whole.h5");
  std::srand(1);
  for (int round = 0; round < 200; ++round) {
    std::string damaged = whole;
    const std::size_t place =
        static_cast<std::size_t>(std::rand()) % (whole.size() - 32);  // the seal is the last 32
    damaged[place] = static_cast<char>(damaged[place] ^ (1 + std::rand() % 255));
    write_text(folder / "damaged.h5", damaged);
    const std::string message = refusal(folder / "damaged.h5");
    // The first bytes make it an HDF5 file at all.
    EXPECT_THAT(message, HasSubstr(place < 8 ? "is no trace" : "is damaged: its contents are not those"))
        << place;
  }
}

TEST(TraceReader, DamageToATraceWithoutASealNeverCrashes) {
  const auto folder = test::scratch_dir();
  test::write_trace(folder / "whole.h5", TraceFormat::hdf5, some_rows(50));
  std::string whole = test::bytes_of(folder / "whole.h5");
  whole.resize(whole.size() - 32);
  write_text(folder / "bare.h5", whole);
  EXPECT_EQ(refusal(folder / "bare.h5"), "");
  std::srand(1);
  for (int round = 0; round < 60; ++round) {
    std::string damaged = whole;
    // Among HDF5's own records, which it trusts; of this many one or two crash or hang it.
    for (int i = 0; i < 3; ++i)
      damaged[static_cast<std::size_t>(std::rand()) % 4000] = static_cast<char>(std::rand());
    write_text(folder / "damaged.h5", damaged);
    refusal(folder / "damaged.h5");
  }
}

TEST(TraceReader, NoCutOfATraceCrashes) {
  const auto folder = test::scratch_dir();
  test::write_trace(folder / "whole.h5", TraceFormat::hdf5, some_rows(50));
  const std::string whole = test::bytes_of(folder / "whole.h5");
  for (int i = 0; i < 60; ++i) {
    write_text(folder / "cut.h5", whole.substr(0, whole.size() * static_cast<std::size_t>(i) / 60));
    EXPECT_NE(refusal(folder / "cut.h5"), "") << i;
  }
}

}  // namespace
}  // namespace fingerpad::trace_reader_test
