#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

// A trace, HDF5 or CSV, as the motion of another run: the same forces, to the last bit, whatever friction was
// told beside the finger's place.

namespace fingerpad::repeat_test {
namespace {
namespace fs = std::filesystem;

constexpr const char* surface =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\ndamping_n_s_per_m = 1\n[finger]\nradius_m = 0.004\n";

/// What a run of `scene` and a run along its trace, of the same surface and friction, differ in: the number
/// of ticks with another force. The first run must touch, stick and slip.
long ticks_that_differ(const fs::path& folder, const std::string& friction, const std::string& how_it_moves) {
  std::ofstream(folder / "first.toml") << surface << friction << how_it_moves;
  std::ofstream(folder / "again.toml") << surface << friction << "[motion]\nfile = \"out/first.h5\"\n";
  std::ofstream(folder / "third.toml") << surface << friction << "[motion]\nfile = \"again.csv\"\n";
  for (const char* scene : {"first.toml", "again.toml", "third.toml"}) {
    if (fs::exists(folder / "out/again.h5")) {
      EXPECT_EQ(test::fingerpad("export out/again.h5 --out again.csv", folder).exit_code, 0);
    }
    const auto result = test::fingerpad("replay " + std::string(scene) + " --out out --quiet", folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  const auto first = read_trace((folder / "out/first.h5").string()).rows;
  long differ = 0, stuck = 0, slipped = 0;
  for (const char* name : {"out/again.h5", "out/third.h5"}) {
    const auto rows = read_trace((folder / name).string()).rows;
    if (rows.size() != first.size()) return -1;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      stuck += first[k].phase == Phase::stick;
      slipped += first[k].phase == Phase::slip;
      differ += rows[k].force_W_n != first[k].force_W_n || rows[k].phase != first[k].phase;
    }
  }
  EXPECT_GT(stuck, 10);
  EXPECT_GT(slipped, 10);
  return differ;
}

constexpr const char* rub =
    "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, 0.003]\namplitude_m = 0.01\nfrequency_hz = 3\n"
    "duration_s = 1\n";
constexpr const char* hand =
    "[hand]\nmass_kg = 0.05\nstiffness_n_per_m = 300\nencoder_m = 3e-5\ndelay_ticks = 1\naxes = \"xz\"\n";

TEST(Repeat, AHandsTraceGivesTheForcesThatTheHandFelt) {
  EXPECT_EQ(ticks_that_differ(test::scratch_dir(),
                              "[friction]\nlaw = \"finger-pad\"\nremedy = \"damping\"\nvibration = {}\n",
                              std::string(rub) + hand),
            0);
}

TEST(Repeat, AHandsTraceKeepsThePushThatKarnoppsLawAsksFor) {
  EXPECT_EQ(
      ticks_that_differ(test::scratch_dir(), "[friction]\nlaw = \"karnopp\"\n", std::string(rub) + hand), 0);
}

TEST(Repeat, AnEstimatedVelocityIsKept) {
  const fs::path folder = test::scratch_dir();
  std::ofstream motion(folder / "coarse.csv");
  motion << "t_s,x_m,y_m,z_m\n";
  for (int k = 0; k < 1000; ++k)
    motion << k / 1000.0 << ',' << 1e-4 * std::round(200 * std::sin(0.009 * k)) << ",0,0.003\n";
  motion.close();
  EXPECT_EQ(ticks_that_differ(folder, "[friction]\nlaw = \"finger-pad\"\n",
                              "[motion]\nfile = \"coarse.csv\"\nencoder_m = 1e-4\n"),
            0);
}

/// A motion at 90 Hz, between whose samples ticks lie, of a finger that rolls and yaws as it rubs.
void write_turning_motion(const fs::path& file, bool attitude) {
  std::ofstream out(file);
  out << (attitude ? "t_s,x_m,y_m,z_m,qw,qx,qy,qz\n" : "t_s,x_m,y_m,z_m,dx,dy,dz\n");
  for (int k = 0; k < 90; ++k) {
    const double t = k / 90.0, roll = 0.3 * std::sin(5 * t), yaw = 0.8 * std::sin(3 * t);
    out << t << ',' << 0.02 * std::sin(9 * t) << ",0," << 0.003 << ',';
    if (attitude) {
      out << std::cos(roll / 2) << ",0," << std::sin(roll / 2) << ",0\n";
    } else {
      out << 0.7 * std::sin(yaw) << ',' << 0.7 * std::cos(yaw) << ",-0.714\n";
    }
  }
}

TEST(Repeat, ATurningFingersTraceTurnsAgain) {
  for (const bool attitude : {false, true}) {
    SCOPED_TRACE(attitude);
    const fs::path folder = test::scratch_dir();
    write_turning_motion(folder / "turning.csv", attitude);
    EXPECT_EQ(ticks_that_differ(folder, "[friction]\nlaw = \"finger-pad\"\nvibration = {}\n",
                                "[motion]\nfile = \"turning.csv\"\n"),
              0);
  }
}

}  // namespace
}  // namespace fingerpad::repeat_test
