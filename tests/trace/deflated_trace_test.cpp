// Deflated traces, and chunks that fit a trace whose length is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "touch/world.hpp"
#include "trace/column_chunks.hpp"
#include "trace/file_seal.hpp"
#include "trace/trace_choice.hpp"
#include "trace_rows.hpp"

namespace fingerpad::deflated_trace_test {
namespace {

namespace fs = std::filesystem;
using test::same_rows;
using testing::HasSubstr;

World ball() {
  World world;
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(test::sphere_soup(0.02, 4), 0.5));
  surface.mesh = "ball.stl";
  world.surfaces = {surface, Surface{}};
  return world;
}

TraceInfo deflated_info() {
  TraceInfo info = test::told_info();
  info.deflated = true;
  return info;
}

/// Writes rows in pieces, as a run does.
FileSum write_in_pieces(const fs::path& path, const TraceInfo& info, const std::vector<TickRecord>& rows,
                        std::uint64_t promised, const World& world = {}) {
  const auto writer = TraceWriter::create(path.string(), TraceFormat::hdf5, info, world, promised);
  constexpr std::size_t piece = 700;
  for (std::size_t i = 0; i < rows.size(); i += piece)
    writer->append(std::span(rows).subspan(i, std::min(piece, rows.size() - i)));
  return writer->finish();
}

TEST(DeflatedTrace, HoldsTheSameInFewerBytes) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::told_rows(20000);
  const World world = ball();
  write_in_pieces(folder / "plain.h5", test::told_info(), rows, rows.size(), world);
  write_in_pieces(folder / "small.h5", deflated_info(), rows, rows.size(), world);
  EXPECT_LT(2 * fs::file_size(folder / "small.h5"), fs::file_size(folder / "plain.h5"));
  const Trace plain = read_trace((folder / "plain.h5").string());
  const Trace small = read_trace((folder / "small.h5").string());
  EXPECT_TRUE(small.complete);
  EXPECT_TRUE(small.info.deflated);
  EXPECT_FALSE(plain.info.deflated);
  EXPECT_TRUE(same_rows(small.rows, rows));
  ASSERT_TRUE(small.world);
  EXPECT_EQ(small.world->surfaces[0].part->vertices, plain.world->surfaces[0].part->vertices);
  EXPECT_EQ(small.world->surfaces[0].part->triangles, plain.world->surfaces[0].part->triangles);
}

TEST(DeflatedTrace, IsTheSameBytesEachTime) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::some_rows(5000);
  for (const char* name : {"a.h5", "b.h5"})
    write_in_pieces(folder / name, deflated_info(), rows, rows.size());
  EXPECT_EQ(test::bytes_of(folder / "a.h5"), test::bytes_of(folder / "b.h5"));
}

TEST(DeflatedTrace, KilledItReadsUpToItsLastFullChunk) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::some_rows(40000);
  const std::string path = (folder / "t.h5").string();
  const std::uint64_t chunk = chunk_rows_for(rows.size());
  ASSERT_LT(chunk, 20000U);
  const pid_t child = fork();
  if (child == 0) {
    const auto writer = TraceWriter::create(path, TraceFormat::hdf5, deflated_info(), ball(), rows.size());
    writer->append(std::span(rows).first(20000));
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  const Trace trace = read_trace(path);
  EXPECT_FALSE(trace.complete);
  EXPECT_EQ(trace.rows.size(), chunk);
  EXPECT_TRUE(same_rows(trace.rows, {rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(chunk)}));
}

TEST(TraceChunks, FitTheRowsThatAreToCome) {
  const fs::path folder = test::scratch_dir();
  for (const std::size_t count : {1UL, 500UL, 16384UL, 16385UL, 40000UL}) {
    const auto rows = test::some_rows(static_cast<long>(count));
    const fs::path path = folder / (std::to_string(count) + ".h5");
    write_in_pieces(path, test::some_info(), rows, count);
    EXPECT_TRUE(same_rows(read_trace(path.string()).rows, rows));
    // No chunk is more than a row short for each chunk there is.
    const std::uint64_t chunk = chunk_rows_for(count), chunks = (count + chunk - 1) / chunk;
    EXPECT_LT(chunks * chunk - count, chunks) << count;
    EXPECT_LE(chunk, most_chunk_rows);
  }
}

TEST(TraceChunks, MayHoldMoreOrFewerRowsThanWerePromised) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::some_rows(3000);
  for (const std::uint64_t promised : {1000U, 5000U}) {
    for (const TraceInfo& info : {test::told_info(), deflated_info()}) {
      write_in_pieces(folder / "t.h5", info, rows, promised);
      EXPECT_TRUE(same_rows(read_trace((folder / "t.h5").string()).rows, rows));
    }
  }
}

TEST(TraceChunks, AFlushAmidAChunkIsWrittenAgainWithItsRest) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::some_rows(300);
  for (const TraceInfo& info : {test::told_info(), deflated_info()}) {
    const std::string path = (folder / "t.h5").string();
    const auto writer = TraceWriter::create(path, TraceFormat::hdf5, info, {}, 250);
    for (std::size_t i = 0; i < rows.size(); i += 60) {
      writer->append(std::span(rows).subspan(i, 60));
      writer->flush();
      EXPECT_EQ(read_trace(path).rows.size(), i + 60);
    }
    writer->finish();
    EXPECT_TRUE(same_rows(read_trace(path).rows, rows));
  }
}

TEST(TraceWriterSum, IsThatOfTheFile) {
  const fs::path folder = test::scratch_dir();
  const auto rows = test::some_rows(1234);
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    const fs::path path = folder / (format == TraceFormat::csv ? "t.csv" : "t.h5");
    const auto writer = TraceWriter::create(path.string(), format, test::some_info(), ball());
    writer->append(rows);
    const FileSum sum = writer->finish();
    const std::string bytes = test::bytes_of(path);
    Checksum due;
    due.add(bytes.data(), bytes.size());
    EXPECT_EQ(sum.size, bytes.size());
    EXPECT_EQ(sum.checksum, due.value(bytes.size()));
  }
}

TEST(KeptRows, AreEveryNthAndTheLast) {
  for (const long ticks : {0L, 1L, 2L, 10L, 11L}) {
    for (const std::uint64_t every : {1U, 2U, 3U, 100U}) {
      std::uint64_t count = 0;
      for (long k = 0; k < ticks; ++k) count += static_cast<std::uint64_t>(is_kept(k, ticks - 1, every));
      EXPECT_EQ(kept_rows(ticks, every), count) << ticks << " by " << every;
    }
  }
}

}  // namespace
}  // namespace fingerpad::deflated_trace_test
