#include "trace/job_index.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"

namespace fingerpad::job_index_test {
namespace {

TEST(JobIndex, SaysWhatVariesInATracesJob) {
  const std::vector<JobIndexRow> rows{
      {1, "t-0001.h5", "t", "a.stl", "m/rub.csv", {{"mesh", "a.stl"}, {"part.mu_static", "0.3"}}},
      {2, "t-0002.h5", "t", "b.stl", "m/tap.csv", {{"motion", "m/tap.csv"}, {"law", "a, b"}}}};
  const std::string text = job_index_text({"mesh", "part.mu_static", "motion", "law"}, rows);
  EXPECT_EQ(text,
            "number,file,scene,mesh,motion,part.mu_static,law\n"
            "1,t-0001.h5,t,a.stl,m/rub.csv,0.3,\n"
            "2,t-0002.h5,t,b.stl,m/tap.csv,,\"a, b\"\n");
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "jobs-2of3.csv") << text;
  EXPECT_EQ(varied_in_job((folder / "t-0001.h5").string()), "rub.csv, mu_static 0.3");
  EXPECT_EQ(varied_in_job((folder / "t-0002.h5").string()), "tap.csv, law a, b");
  EXPECT_EQ(varied_in_job((folder / "t-0003.h5").string()), "");
  const std::map<std::string, std::string> all{{"t-0001.h5", "a.stl, rub.csv, mu_static 0.3"},
                                               {"t-0002.h5", "b.stl, tap.csv, law a, b"}};
  EXPECT_EQ(jobs_in_folder(folder.string()), all);
}

TEST(JobIndex, DoesNotNameAMotionThatAllJobsHave) {
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "jobs.csv") << job_index_text(
      {"motion", "law"}, {{1, "t-0001.h5", "t", "", "rub.csv", {{"motion", "rub.csv"}, {"law", "dahl"}}},
                          {2, "t-0002.h5", "t", "", "rub.csv", {{"motion", "rub.csv"}, {"law", "lugre"}}}});
  EXPECT_EQ(varied_in_job((folder / "t-0001.h5").string()), "law dahl");
  EXPECT_EQ(jobs_in_folder(folder.string()).at("t-0002.h5"), "law lugre");
}

TEST(JobIndex, ThatIsNoneIsPassedOver) {
  const auto folder = test::scratch_dir();
  EXPECT_EQ(varied_in_job((folder / "none" / "t-0001.h5").string()), "");
  std::ofstream(folder / "jobs.csv") << "what,file,scene,mesh,motion,salary\n1,t-0001.h5,t,,,3\n";
  EXPECT_EQ(varied_in_job((folder / "t-0001.h5").string()), "");
  EXPECT_TRUE(jobs_in_folder(folder.string()).empty());
}

}  // namespace
}  // namespace fingerpad::job_index_test
