// A motion with a measured force: what the model leaves of it, in the trace and in the summary.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "replay/batch.hpp"
#include "replay/figures.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

namespace fingerpad::residual_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* scene =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[friction]\nlaw = \"finger-pad\"\n"
    "stick_stiffness_per_m = {}\n[motion]\nfile = \"rub.csv\"\nrate_hz = 1000\n{}";
constexpr const char* measured_columns = "columns = { fx = \"fx_n\", fy = \"fy_n\", fz = \"fz_n\" }\n";

std::vector<BatchJob> run(const fs::path& folder, double stiffness_per_m, const std::string& keys,
                          TraceFormat format = TraceFormat::hdf5) {
  std::ofstream(folder / "s.toml") << fmt::format(fmt::runtime(scene), stiffness_per_m, keys);
  auto jobs = batch_jobs({(folder / "s.toml").string()});
  BatchOptions options;
  options.out_dir = (folder / "out").string();
  options.version = "test";
  options.format = format;
  run_batch(jobs, options, Ranks(), [](const BatchJob&) {});
  EXPECT_EQ(jobs[0].status, "ok");
  return jobs;
}

double rms_of(const BatchJob& job) {
  return Figures::of(job.figures, "residual_rms_n");
}

/// A rub of one second, 1 mm deep, and the forces that a pad of 150 1/m has along it.
/// @param late_ms  how long a recorder keeps them
/// @param off_n    of a sensor that was not tared
/// @param scale    of another unit, or the other side's
fs::path measured_rub(int late_ms = 0, double off_n = 0, double scale = 1) {
  const fs::path folder = test::scratch_dir();
  const auto place_text = [](int i) {
    return fmt::format("{:.3f},{:.9f},0,-0.001", i / 1000.0, 0.02 * std::sin(2 * M_PI * i / 1000.0));
  };
  std::ofstream bare(folder / "rub.csv");
  bare << "t_s,x_m,y_m,z_m\n";
  for (int i = 0; i <= 1000; ++i) bare << place_text(i) << "\n";
  bare.close();
  run(folder, 150, "");
  const Trace trace = read_trace((folder / "out/s.h5").string());
  std::ofstream table(folder / "rub.csv");
  table << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
  for (int i = 0; i <= 1000; ++i) {
    const Vec3 force_n =
        scale * trace.rows[static_cast<std::size_t>(std::max(0, i - late_ms))].force_W_n + Vec3(0, 0, off_n);
    table << place_text(i) << fmt::format(",{},{},{}\n", force_n.x(), force_n.y(), force_n.z());
  }
  return folder;
}

TEST(Residual, IsNothingForTheModelThatMadeTheForceAndTellsAnother) {
  const fs::path folder = measured_rub();
  EXPECT_LT(rms_of(run(folder, 150, measured_columns)[0]), 1e-12);  // numbers are written to the last digit
  const BatchJob other = run(folder, 1000, measured_columns)[0];
  const Trace trace = read_trace((folder / "out/s.h5").string());
  ASSERT_TRUE(trace.info.compared);
  double squares = 0;
  for (const TickRecord& row : trace.rows) squares += row.residual_W_n.squaredNorm();
  EXPECT_NEAR(rms_of(other), std::sqrt(squares / static_cast<double>(trace.rows.size())), 1e-15);
  EXPECT_GT(rms_of(other), 0.02);                           // a stick region of 0.3 mm instead of 2 mm
  EXPECT_NEAR(trace.rows[500].residual_W_n.z(), 0, 1e-12);  // as deep, as hard
}

TEST(Residual, StandsInCsvTracesAndInTheSummaryAlike) {
  const fs::path folder = measured_rub();
  const BatchJob job = run(folder, 1000, measured_columns, TraceFormat::csv)[0];
  const std::string header = test::bytes_of(folder / "out/s.csv").substr(0, 600);
  EXPECT_THAT(header, HasSubstr(",rfx_n,rfy_n,rfz_n\n"));
  EXPECT_THAT(test::bytes_of(folder / "out/summary.csv"), HasSubstr(fmt::format("{}", rms_of(job))));
  const Trace trace = read_trace((folder / "out/s.csv").string());
  EXPECT_TRUE(trace.rows[10].residual_W_n.allFinite());
}

TEST(Residual, OfAMotionWithoutAMeasuredForceIsNoNumber) {
  const fs::path folder = measured_rub();
  const BatchJob job = run(folder, 150, "", TraceFormat::csv)[0];
  EXPECT_TRUE(std::isnan(rms_of(job)));
  EXPECT_THAT(test::bytes_of(folder / "out/s.csv").substr(0, 600), Not(HasSubstr("rfx_n")));
}

TEST(Residual, TellsARecorderThatIsLate) {
  const fs::path folder = measured_rub(12);
  const BatchJob job = run(folder, 150, measured_columns)[0];
  EXPECT_NEAR(Figures::of(job.figures, "residual_lag_s"), 0.012, 2e-4);
  EXPECT_THAT(job.warnings,
              Contains(AllOf(HasSubstr("s: the measured force fits the model's best"),
                             HasSubstr("12 ms earlier"), HasSubstr("or the finger's spring is softer"))));
}

TEST(Residual, TellsASensorThatWasNotTared) {
  const fs::path folder = measured_rub(0, 0.3);
  const BatchJob job = run(folder, 150, measured_columns)[0];
  EXPECT_NEAR(Figures::of(job.figures, "residual_bias_n"), 0.3, 1e-9);
  EXPECT_THAT(job.warnings, Contains(HasSubstr("0.3 N of the residual's 0.3 N are the same all along")));
  EXPECT_THAT(run(measured_rub(), 150, measured_columns)[0].warnings, IsEmpty());
}

TEST(Residual, TellsAForceOnThePlateAndOneInAnotherUnit) {
  const BatchJob plate = run(measured_rub(0, 0, -1), 150, measured_columns)[0];
  EXPECT_NEAR(Figures::of(plate.figures, "residual_scale"), -1, 1e-9);
  EXPECT_THAT(plate.warnings, Contains(AllOf(HasSubstr("presses the other way than the model's, 1 times"),
                                             HasSubstr("force_on = \"plate\""))));
  const BatchJob milli = run(measured_rub(0, 0, 1000), 150, measured_columns)[0];
  EXPECT_THAT(milli.warnings, Contains(AllOf(HasSubstr("presses 1000 times as hard as the model"),
                                             HasSubstr("radius_m"), HasSubstr("force_unit"))));
  EXPECT_THAT(run(measured_rub(0, 0, 0.5), 150, measured_columns)[0].warnings,
              Not(Contains(HasSubstr("residual_scale"))));
}

TEST(Residual, OfAHandIsNone) {
  const fs::path folder = measured_rub();
  const BatchJob job = run(folder, 150, std::string(measured_columns) + "[hand]\nmass_kg = 0.07\n")[0];
  EXPECT_TRUE(std::isnan(rms_of(job)));  // its finger goes elsewhere
  EXPECT_FALSE(read_trace((folder / "out/s.h5").string()).info.compared);
}

}  // namespace
}  // namespace fingerpad::residual_test
