#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "replay/batch.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"

// What the program chose for a scene that leaves it open is told by the job, its trace and the summary.

namespace fingerpad::contact_choice_test {
namespace {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* rub =
    "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.0004]\nto_m = [0.01, 0, 0.0004]\nspeed_m_per_s = 0.1\n";

/// A folder with a plate of 1 mm and a thick block, their tops at 0.5 mm and 50 mm.
fs::path folder_with_parts() {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "plate.ply", test::binary_ply(test::box_soup({100, 100, 1})));
  test::write_file(folder, "block.ply", test::binary_ply(test::box_soup({100, 100, 100})));
  return folder;
}

std::string scene_in(const fs::path& folder, const std::string& name, const std::string& rest) {
  const fs::path path = folder / (name + ".toml");
  std::ofstream(path) << "name = \"" << name << "\"\n" << rest << rub;
  return path.string();
}

std::vector<BatchJob> run(const std::vector<std::string>& scenes, const fs::path& out, int threads,
                          bool resume = false) {
  auto jobs = batch_jobs(scenes);
  BatchOptions options;
  options.out_dir = out.string();
  options.threads = threads;
  options.resume = resume;
  options.version = "test";
  run_batch(jobs, options, Ranks(), [](const BatchJob&) {});
  return jobs;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(ContactChoice, IsKeptInTheJobTheTraceAndTheSummary) {
  const fs::path folder = folder_with_parts();
  const std::string plate = "[[part]]\nmesh = \"plate.ply\"\n";
  const auto jobs =
      run({scene_in(folder, "open", plate),
           scene_in(folder, "given", plate + "[contact]\nmethod = \"closest-point\"\n"),
           scene_in(
               folder, "thick",
               "[[part]]\nmesh = \"block.ply\"\n[contact]\nnormals = \"auto\"\n[finger]\nradius_m = 0.012\n"),
           scene_in(folder, "flat", "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n")},
          folder / "out", 2);
  for (const BatchJob& job : jobs) ASSERT_EQ(job.status, "ok");
  const std::string why =
      "plate.ply: proxy, because walls are 1 mm thick and 10 N at 1000 N/m presses 10 mm deep (auto)";
  EXPECT_EQ(jobs[0].contact_method, "proxy");
  EXPECT_THAT(jobs[0].contact_reasons, ElementsAre(why));
  EXPECT_EQ(jobs[1].contact_method, "closest-point");
  EXPECT_THAT(jobs[1].contact_reasons, IsEmpty());
  EXPECT_EQ(jobs[2].contact_method, "proxy") << "which is the cheaper one on so few triangles";
  EXPECT_EQ(jobs[2].contact_normals, "facet");
  EXPECT_EQ(jobs[3].contact_method, "plane");

  const TraceInfo info = read_trace((folder / "out" / "open.h5").string()).info;
  EXPECT_EQ(info.contact_method, "proxy");
  EXPECT_EQ(info.contact_normals, "smooth");
  EXPECT_THAT(info.contact_reasons, ElementsAre(why));
  EXPECT_THAT(read_trace((folder / "out" / "given.h5").string()).info.contact_reasons, IsEmpty());

  std::istringstream summary(text_of(folder / "out" / "summary.csv"));
  std::vector<std::string> ends;
  for (std::string line; std::getline(summary, line);) {
    line.erase(std::min(line.find(",\""), line.rfind(',')));  // its warnings
    const std::size_t second = line.rfind(',', line.rfind(',') - 1);
    ends.push_back(line.substr(second + 1));
  }
  EXPECT_THAT(ends, ElementsAre("contact_method,contact_normals", "proxy,smooth", "closest-point,smooth",
                                "proxy,facet", "plane,smooth"));
}

TEST(ContactChoice, OfASetIsTheSameOnAnyNumberOfThreadsAndWhenResumed) {
  const fs::path folder = folder_with_parts();
  const auto scene =
      scene_in(folder, "set",
               "[[part]]\nmesh = \"plate.ply\"\n[[set]]\nmesh = [\"plate.ply\", \"block.ply\"]\n"
               "contact.greatest_force_n = [0.001, 1, 10]\nfriction.law = [\"coulomb\", \"none\"]\n");
  run({scene}, folder / "one", 1);
  const std::string summary = text_of(folder / "one" / "summary.csv");
  const auto jobs = run({scene}, folder / "four", 4);
  EXPECT_EQ(text_of(folder / "four" / "summary.csv"), summary);
  for (const BatchJob& job : jobs) ASSERT_EQ(job.status, "ok");
  run({scene}, folder / "four", 3, true);
  EXPECT_EQ(text_of(folder / "four" / "summary.csv"), summary);
  for (const auto& entry : fs::directory_iterator(folder / "one")) {
    if (entry.path().extension() != ".h5") continue;
    EXPECT_EQ(text_of(folder / "four" / entry.path().filename()), text_of(entry.path())) << entry.path();
  }
}

}  // namespace
}  // namespace fingerpad::contact_choice_test
