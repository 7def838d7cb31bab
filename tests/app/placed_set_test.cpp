#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/effort.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

// Sets that place a motion on parts: on their surface at random points, or in their coordinates; and
// deflated.

namespace fingerpad::placed_set_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;

/// A ball of 30 mm radius and a plate, rubbed at two places each.
fs::path folder_with_set(const std::string& pressed) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "ball.ply", test::binary_ply(test::sphere_soup(30, 5)));
  test::write_file(folder, "plate.ply", test::binary_ply(test::box_soup({80, 80, 10})));
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"ball.ply\"\nposition_m = [0.1, 0.2, -0.3]\nrotation = { axis = "
         "[1, 2, 3], "
         "angle_deg = 50 }\n[finger]\nradius_m = 0.005\n[friction]\nlaw = \"coulomb\"\n[motion]\nkind = "
         "\"on_surface\"\nshape = \"circle\"\nsize_m = 0.01\nspeed_m_per_s = 0.1\n"
      << pressed << "\n[[set]]\nmesh = [\"ball.ply\", \"plate.ply\"]\nmotion.place = [1, 2]\n";
  return folder;
}

/// The normal forces of a trace once the finger is fully in, half a radius on.
std::vector<double> forces_amid(const fs::path& path) {
  const Trace trace = read_trace(path.string());
  std::vector<double> forces_n;
  for (std::size_t i = trace.rows.size() / 3; i < 2 * trace.rows.size() / 3; ++i)
    forces_n.push_back(trace.rows[i].normal_force_n);
  return forces_n;
}

TEST(PlacedSet, PressesWithTheForceThatIsAskedFor) {
  const fs::path folder = folder_with_set("normal_force_n = 0.8");
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("a circle of 10 mm radius at place 2 of plate.ply"));
  for (int job = 1; job <= 4; ++job) {
    const auto forces_n = forces_amid(folder / "o" / ("s-000" + std::to_string(job) + ".h5"));
    ASSERT_GT(forces_n.size(), 100U);
    // On facets of the ball and over the plate's edges the depth is held to rounding; between two samples
    // the finger goes straight: a tenth of a millimetre over a radius of 35 mm gives way by 4e-8 m.
    for (const double force_n : forces_n) ASSERT_NEAR(force_n, 0.8, 0.004) << job;
  }
}

TEST(PlacedSet, IsPlannedWithItsTicksWithoutItsMeshes) {
  const fs::path folder = folder_with_set("depth_m = 0.001");
  const auto planned = test::fingerpad("replay s.toml --out o --dry-run", folder);
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
  const std::size_t ticks = read_trace((folder / "o" / "s-0004.h5").string()).rows.size();
  EXPECT_THAT(planned.out, HasSubstr("s-0004.h5: plate.ply, place 2: " + std::to_string(ticks) + " ticks\n"));
}

TEST(PlacedSet, WhatNoPlaceHoldsFailsWithItsReason) {
  const fs::path folder = folder_with_set("depth_m = 0.011");  // its centre past the middle of the plate
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err,
              HasSubstr("error: 2 jobs (3, 4): s.toml: plate.ply: none of 300 random places holds"));
}

/// Each job by its own greatest force, and where the motion asks for less, how to say so.
TEST(PlacedSet, IsJudgedByAutoForEachJobsGreatestForce) {
  const fs::path folder = folder_with_set("normal_force_n = 1");
  std::ofstream(folder / "s.toml", std::ios::app)
      << "contact.greatest_force_n = [1, 10]\ncontact.method = \"auto\"\ncontact.normals = [\"auto\"]\n"
         "contact.force_tolerance = 1e-6\n";
  const auto result = test::fingerpad("replay s.toml --out o --jobs 1", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto reasons = [&](int job) {
    std::string words;
    for (const std::string& line :
         read_trace((folder / ("o/s-000" + std::to_string(job) + ".h5")).string()).info.contact_reasons)
      words += line + "\n";
    return words;
  };
  EXPECT_THAT(reasons(1), testing::AllOf(HasSubstr("cannot be kept"),
                                         testing::Not(HasSubstr("contact.greatest_force_n"))));
  EXPECT_THAT(reasons(2),
              HasSubstr("; reckoned for contact.greatest_force_n = 10, though the motion asks for 1 N: with "
                        "greatest_force_n = 1 less has to be kept (auto)\n"));
}

TEST(PlacedMotion, InAPartsFrameGoesWithThePart) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "plate.ply", test::binary_ply(test::box_soup({80, 80, 10})));
  const auto forces_n = [&](const std::string& pose, const std::string& name) {
    std::ofstream(folder / (name + ".toml"))
        << "[[part]]\nmesh = \"plate.ply\"\n"
        << pose
        << "[friction]\nlaw = \"coulomb\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.004]\nto_m = [0.02, "
           "0.01, "
           "0.0045]\nspeed_m_per_s = 0.1\nframe = \"part\"\nposition_m = [0.001, 0, 0]\n";
    EXPECT_EQ(test::fingerpad("replay " + name + ".toml --out o --quiet", folder).exit_code, 0);
    return forces_amid(folder / "o" / (name + ".h5"));
  };
  const auto at_home = forces_n("", "home");
  const auto away =
      forces_n("position_m = [1, 2, 3]\nrotation = { axis = [3, 1, 2], angle_deg = 77 }\n", "away");
  ASSERT_EQ(at_home.size(), away.size());
  for (std::size_t i = 0; i < away.size(); ++i) {
    ASSERT_GT(at_home[i], 0.4);
    // Places 4 m from the world's origin are rounded by 4e-16 m, of 1000 N/m.
    ASSERT_NEAR(away[i], at_home[i], 1e-11);
  }
}

TEST(DeflatedSet, IsTheSameToWhoeverReadsIt) {
  const fs::path folder = folder_with_set("depth_m = 0.001");
  ASSERT_EQ(test::fingerpad("replay s.toml --out plain --quiet", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("replay s.toml --out small --quiet --compress", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "plain/summary.csv"), bytes_of(folder / "small/summary.csv"));
  EXPECT_LT(2 * fs::file_size(folder / "small/s-0001.h5"), fs::file_size(folder / "plain/s-0001.h5"));
  for (const char* from : {"plain", "small"})
    ASSERT_EQ(
        test::fingerpad(std::string("export ") + from + "/s-0001.h5 --out " + from + ".csv --quiet", folder)
            .exit_code,
        0);
  EXPECT_EQ(bytes_of(folder / "plain.csv"), bytes_of(folder / "small.csv"));
  EXPECT_EQ(test::fingerpad("compare plain small", folder).exit_code, 0);
  // Merged shards are the single run's bytes; resumed it is kept, but not for a plain one.
  for (const char* shard : {"1", "2"})
    ASSERT_EQ(test::fingerpad(std::string("replay s.toml --quiet --compress --out part") + shard +
                                  " --shard " + shard + "/2",
                              folder)
                  .exit_code,
              0);
  ASSERT_EQ(test::fingerpad("merge part1 part2 --out merged", folder).exit_code, 0);
  for (const char* name : {"s-0001.h5", "s-0004.h5", "summary.csv"})
    EXPECT_TRUE(bytes_of(folder / "merged" / name) == bytes_of(folder / "small" / name)) << name;
  for (const bool proven : {true, false}) {  // without its proof a sealed trace is taken at its word
    if (!proven && !test::forks_beside_threads()) continue;  // it would be read by a child
    if (!proven) fs::remove_all(folder / "small/.fingerpad");
    EXPECT_THAT(test::fingerpad("replay s.toml --out small --resume --compress", folder).out,
                HasSubstr("(4 kept from before)"));
  }
  EXPECT_EQ(test::fingerpad("replay s.toml --out small --resume --quiet", folder).exit_code, 0);
  EXPECT_TRUE(bytes_of(folder / "small/s-0001.h5") == bytes_of(folder / "plain/s-0001.h5"));
  const auto refused = test::fingerpad("replay s.toml --out o --format csv --compress", folder);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--compress: is for the traces of --format h5"));
}

}  // namespace
}  // namespace fingerpad::placed_set_test
