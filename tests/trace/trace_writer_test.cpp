#include "trace/trace_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <numbers>
#include <thread>

#include "box_and_plane.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "touch/world.hpp"
#include "trace/export.hpp"
#include "trace/trace_column.hpp"
#include "trace_rows.hpp"

namespace fingerpad::trace_writer_test {
namespace {

using test::box_and_plane;
using test::same_rows;
using test::some_rows;
using testing::HasSubstr;
using testing::StartsWith;

TEST(TraceWriter, AnHdf5TraceReadsBackWhole) {
  const auto path = test::scratch_dir() / "t.h5";
  const auto rows = some_rows(10000);  // more than two blocks
  test::write_trace(path, TraceFormat::hdf5, rows);
  ASSERT_TRUE(is_hdf5(path.string()));
  const Trace trace = read_trace(path.string());
  EXPECT_TRUE(trace.complete);
  EXPECT_TRUE(same_rows(trace.rows, rows));
  EXPECT_FALSE(trace.world);
  const TraceInfo info = test::some_info();
  EXPECT_EQ(trace.info.scene_name, info.scene_name);
  EXPECT_EQ(trace.info.scene_text, info.scene_text);
  EXPECT_EQ(trace.info.seed, info.seed);
  EXPECT_EQ(trace.info.rate_hz, info.rate_hz);
  EXPECT_EQ(trace.info.version, info.version);
  EXPECT_EQ(trace.info.mesh_files, info.mesh_files);
  EXPECT_EQ(trace.info.mesh_hashes, info.mesh_hashes);
  EXPECT_EQ(trace.info.motion_file, info.motion_file);
  EXPECT_EQ(trace.info.motion_hash, info.motion_hash);
  EXPECT_EQ(trace.info.profile_text, info.profile_text);
  EXPECT_EQ(trace.info.contact_method, info.contact_method);
  EXPECT_EQ(trace.info.contact_normals, info.contact_normals);
  EXPECT_EQ(trace.info.contact_reasons, info.contact_reasons);
}

TEST(TraceWriter, TextsOfAnyLengthAreKept) {
  const auto path = (test::scratch_dir() / "t.h5").string();
  TraceInfo info;
  info.scene_text = "# " + std::string(300000, 'x');  // HDF5 keeps at most 64 KiB beside an object
  TraceWriter::create(path, TraceFormat::hdf5, info, {})->finish();
  const Trace trace = read_trace(path);
  EXPECT_EQ(trace.info.scene_text, info.scene_text);
  EXPECT_EQ(trace.info.motion_file, "");
  EXPECT_TRUE(trace.info.mesh_files.empty());
  EXPECT_TRUE(trace.rows.empty());
  EXPECT_TRUE(trace.complete);
}

TEST(TraceWriter, ACsvTraceReadsBackWhole) {
  const auto path = test::scratch_dir() / "t.csv";
  const auto rows = some_rows(5000);
  test::write_trace(path, TraceFormat::csv, rows);
  const Trace trace = read_trace(path.string());
  EXPECT_TRUE(trace.complete);
  EXPECT_TRUE(same_rows(trace.rows, rows));
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST(TraceWriter, CsvHasTheContractsColumnsAndWords) {
  const auto path = test::scratch_dir() / "t.csv";
  std::vector<TickRecord> rows = some_rows(3);
  rows[0].mu = -std::numeric_limits<double>::quiet_NaN();
  test::write_trace(path, TraceFormat::csv, rows);
  const std::string text = test::bytes_of(path);
  EXPECT_THAT(text,
              StartsWith("t_s,x_m,y_m,z_m,phase,depth_m,px_m,py_m,pz_m,nx,ny,nz,fn_n,fx_n,fy_n,fz_n,"
                         "ffx_n,ffy_n,ffz_n,mu,cx_m,cy_m,cz_m,angle_rad,part,triangle\n"
                         "0,0,-0,0,free,0,nan,nan,nan,nan,nan,nan,0,0,0,0,0,0,0,nan,nan,nan,nan,nan,-1,-1\n"
                         "0.001,"));
  EXPECT_THAT(text, HasSubstr(",slip,0.5,"));
  EXPECT_THAT(text, HasSubstr(",stick,0.3333333333333333,"));
  EXPECT_THAT(text, Not(HasSubstr("-nan")));
  EXPECT_THAT(text, Not(HasSubstr(",,")));
}

TEST(TraceWriter, ExportedCsvIsTheCsvThatReplayWrites) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(5000);
  test::write_trace(folder / "t.h5", TraceFormat::hdf5, rows);
  test::write_trace(folder / "t.csv", TraceFormat::csv, rows);
  export_csv(read_trace((folder / "t.h5").string()), (folder / "e.csv").string());
  EXPECT_EQ(test::bytes_of(folder / "e.csv"), test::bytes_of(folder / "t.csv"));
}

TEST(TraceWriter, TheSameRunGivesTheSameBytes) {
  const auto folder = test::scratch_dir();
  const World world = box_and_plane();
  test::write_trace(folder / "a.h5", TraceFormat::hdf5, some_rows(9000), world);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a date kept anywhere would differ
  test::write_trace(folder / "b.h5", TraceFormat::hdf5, some_rows(9000), world);
  EXPECT_EQ(test::bytes_of(folder / "a.h5"), test::bytes_of(folder / "b.h5"));
}

TEST(TraceWriter, HowRowsWereHandedOverLeavesNoMark) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(9000);
  test::write_trace(folder / "a.h5", TraceFormat::hdf5, rows);
  const auto writer =
      TraceWriter::create((folder / "b.h5").string(), TraceFormat::hdf5, test::some_info(), {});
  for (std::size_t i = 0; i < rows.size(); i += 7) {
    writer->append(std::span(rows).subspan(i, std::min<std::size_t>(7, rows.size() - i)));
  }
  writer->finish();
  EXPECT_EQ(test::bytes_of(folder / "a.h5"), test::bytes_of(folder / "b.h5"));
}

TEST(TraceWriter, WritersOnManyThreadsDoNotDisturbOneAnother) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(9000);
  test::write_trace(folder / "alone.h5", TraceFormat::hdf5, rows);
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back(
        [&, i] { test::write_trace(folder / (std::to_string(i) + ".h5"), TraceFormat::hdf5, rows); });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(test::bytes_of(folder / (std::to_string(i) + ".h5")), test::bytes_of(folder / "alone.h5"));
  }
}

TEST(TraceWriter, SurfacesAreEmbeddedAndRebuilt) {
  const auto path = test::scratch_dir() / "t.h5";
  const World world = box_and_plane();
  test::write_trace(path, TraceFormat::hdf5, some_rows(10), world);
  const Trace trace = read_trace(path.string());
  ASSERT_TRUE(trace.world);
  ASSERT_EQ(trace.world->surfaces.size(), 2u);
  const Surface& box = trace.world->surfaces[0];
  const Surface& original = world.surfaces[0];
  ASSERT_TRUE(box.part);
  EXPECT_EQ(box.mesh, "box.stl");
  EXPECT_EQ(box.mesh_hash, original.mesh_hash);
  EXPECT_EQ(box.p_WP, original.p_WP);
  EXPECT_EQ(box.R_WP, original.R_WP);
  EXPECT_EQ(box.properties.stiffness_n_per_m, 1500);
  EXPECT_EQ(box.properties.damping_n_s_per_m, 0.5);
  EXPECT_EQ(box.properties.mu_static, 0.4);
  EXPECT_EQ(box.properties.mu_dynamic, 0.25);
  EXPECT_EQ(box.part->triangles, original.part->triangles);
  EXPECT_EQ(box.part->file_triangle, original.part->file_triangle);
  EXPECT_EQ(box.part->creases, original.part->creases);  // 100 degrees: a box has none, at the default it has
  EXPECT_LT((box.part->centre_P - original.part->centre_P).norm(), 1e-14);
  // Positions are kept in the file's frame, 10 m away, and come back to its rounding.
  EXPECT_LT((box.part->vertices - original.part->vertices).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(trace.world->verdicts.size(), 1u);
  EXPECT_EQ(trace.world->surfaces[1].plane_point_W, Vec3(0, 0, 0.5));
  EXPECT_EQ(trace.world->surfaces[1].plane_normal_W, Vec3(0.6, 0, 0.8));
  EXPECT_FALSE(trace.world->surfaces[1].part);
  EXPECT_FALSE(read_trace(path.string(), TraceContents::rows).world);
}

TEST(TraceWriter, ALargePartIsNamedButNotEmbedded) {
  const auto path = test::scratch_dir() / "t.h5";
  World world;
  Surface large;
  large.part = std::make_shared<const Part>(make_part(test::square_soup(1, 230), 0.5));  // 105,800 triangles
  large.mesh = "large.stl";
  world.surfaces.push_back(large);
  test::write_trace(path, TraceFormat::hdf5, some_rows(10), world);
  EXPECT_LT(std::filesystem::file_size(path), 1u << 20);
  const Trace trace = read_trace(path.string());
  EXPECT_FALSE(trace.world);
  EXPECT_EQ(trace.rows.size(), 10u);
}

TEST(TraceWriter, KeepsWhatTheTickWasToldOfAHandAndOfATurningFingerAlone) {
  auto rows = test::told_rows(10);
  for (const auto& [name, format] : {std::pair("t.h5", TraceFormat::hdf5), {"t.csv", TraceFormat::csv}}) {
    const auto path = test::scratch_dir() / name;
    rows[1].ruptures = format == TraceFormat::hdf5 ? 3 : 0;
    test::write_trace(path, format, rows, {}, test::told_info());
    const Trace told = read_trace(path.string());
    EXPECT_TRUE(test::same_rows(told.rows, rows)) << name;
    EXPECT_TRUE(told.info.in_hand && told.info.estimated && told.info.turning && told.info.attitudes) << name;
    test::write_trace(path, format, rows);
    const Trace plain = read_trace(path.string());
    auto bare = some_rows(10);
    bare[1].ruptures = rows[1].ruptures;
    EXPECT_TRUE(test::same_rows(plain.rows, bare)) << name;
    EXPECT_FALSE(plain.info.in_hand || plain.info.turning) << name;
  }
}

TEST(TraceWriter, DatasetsStandAtTheRootWithTheirUnits) {
  const auto path = test::scratch_dir() / "t.h5";
  test::write_trace(path, TraceFormat::hdf5, test::told_rows(10), {}, test::told_info());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  EXPECT_GE(trace_columns().size(), 50u);
  for (const TraceColumn& column : trace_columns()) {
    const hid_t dataset = H5Dopen2(file, std::string(column.name).c_str(), H5P_DEFAULT);
    ASSERT_GE(dataset, 0) << column.name;
    const hid_t type = H5Dget_type(dataset);
    const std::size_t bytes = column.kind == ColumnKind::phase ? 1 : column.kind == ColumnKind::index ? 4 : 8;
    EXPECT_EQ(H5Tget_size(type), bytes) << column.name;
    EXPECT_EQ(H5Aexists(dataset, "unit"), 1) << column.name;
    EXPECT_EQ(H5Aexists(dataset, "values"), column.values.empty() ? 0 : 1) << column.name;
    H5Tclose(type);
    H5Dclose(dataset);
  }
  H5Fclose(file);
}

TEST(TraceWriter, AFileThatCannotBeCreatedIsTheCallersFault) {
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    try {
      TraceWriter::create("/no/such/folder/t", format, {}, {});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), StartsWith("/no/such/folder/t: cannot be created"));
      EXPECT_THAT(error.what(), HasSubstr("its folder /no/such/folder is not there (only / is)"));
    }
  }
}

}  // namespace
}  // namespace fingerpad::trace_writer_test
