#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "replay/job_board.hpp"
#include "replay/job_outcome_text.hpp"
#include "replay/rank_log.hpp"
#include "support/paths.hpp"

// What ranks that share a batch agree on: who does what, in which order, and what became of it.

namespace fingerpad::shared_jobs_test {
namespace {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void write_bytes(const fs::path& path, int bytes) {
  std::ofstream(path) << std::string(static_cast<std::size_t>(bytes), 'x');
}

std::vector<std::size_t> all_of(const std::vector<BatchJob>& jobs) {
  std::vector<std::size_t> all(jobs.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

/// Jobs of the given meshes and motions, which are files in a folder.
std::vector<BatchJob> jobs_over(const fs::path& folder,
                                const std::vector<std::pair<const char*, const char*>>& files) {
  std::vector<BatchJob> jobs;
  for (const auto& [mesh, motion] : files) {
    Scene& scene = jobs.emplace_back().job.scene;
    scene.parts.emplace_back().mesh_path = (folder / mesh).string();
    scene.motion.file_path = (folder / motion).string();
  }
  return jobs;
}

TEST(JobOrder, PutsTheLargestMeshAndTheLongestMotionFirstAndKeepsAMeshTogether) {
  const fs::path folder = test::scratch_dir();
  for (const auto& [name, bytes] :
       {std::pair("small", 10), std::pair("large", 90), std::pair("short", 1), std::pair("long", 7)})
    write_bytes(folder / name, bytes);
  const auto jobs = jobs_over(folder, {{"small", "short"},
                                       {"large", "short"},
                                       {"gone", "long"},
                                       {"small", "long"},
                                       {"large", "long"},
                                       {"large", "long"}});
  const JobOrder order = order_by_cost(jobs, all_of(jobs), 1);
  EXPECT_THAT(order.jobs, ElementsAre(4, 5, 1, 3, 0, 2));
  ASSERT_EQ(order.groups.size(), 3u);
  EXPECT_EQ(order.groups[0].end, 3u);
  EXPECT_EQ(order.groups[0].cost_each, 5) << "of 7, 7 and 1";
  EXPECT_EQ(order.groups[2].end, 6u);
}

TEST(JobOrder, TakesOneMeshReadInTwoWaysForTwo) {
  auto jobs = jobs_over(test::scratch_dir(), {{"a", "m"}, {"a", "m"}, {"a", "m"}});
  jobs[1].job.scene.parts[0].crease_deg = 10;
  EXPECT_THAT(order_by_cost(jobs, all_of(jobs), 1).jobs, ElementsAre(0, 2, 1));
}

/// Jobs of one file over one mesh, each with a speed of its finger and a friction.
std::vector<BatchJob> jobs_at(const std::vector<std::pair<const char*, const char*>>& values) {
  std::vector<BatchJob> jobs(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    jobs[i].job.scene.parts.emplace_back().mesh_path = "mesh";
    jobs[i].job.set_keys = {{"motion.speed_m_per_s", values[i].first}, {"friction.law", values[i].second}};
  }
  return jobs;
}

TEST(JobOrder, LetsJobsThatDifferInFrictionAloneFollowOneAnother) {
  const auto jobs = jobs_at({{"1", "a"}, {"2", "a"}, {"3", "a"}, {"1", "b"}, {"2", "b"}, {"3", "b"}});
  EXPECT_THAT(order_by_cost(jobs, all_of(jobs), 1).jobs, ElementsAre(0, 3, 1, 4, 2, 5));
  EXPECT_THAT(order_by_cost(jobs, all_of(jobs), 2).jobs, ElementsAre(0, 1, 3, 4, 2, 5))
      << "of two threads the second does not begin with what the first is about to find out";
  EXPECT_EQ(contacts_of_several(jobs).size(), 3u);
  EXPECT_THAT(contacts_of_several(jobs_at({{"1", "a"}, {"2", "a"}, {"3", "b"}})), IsEmpty());
}

TEST(JobOrder, TakesNoPartOfASurfacesNatureForAPlaceOfTheFinger) {
  std::vector<BatchJob> jobs(2);
  for (const char* key : {"seed", "friction.law", "part.mu_static", "plane.mu_dynamic",
                          "part.stiffness_n_per_m", "part.damping_n_s_per_m"}) {
    jobs[0].job.set_keys = {{key, "1"}};
    jobs[1].job.set_keys = {{key, "2"}};
    EXPECT_EQ(contact_number(jobs[0].job), contact_number(jobs[1].job)) << key;
  }
  for (const char* key : {"mesh", "motion", "finger.radius_m", "part.position_m", "contact.method"}) {
    jobs[0].job.set_keys = {{key, "1"}};
    jobs[1].job.set_keys = {{key, "2"}};
    EXPECT_NE(contact_number(jobs[0].job), contact_number(jobs[1].job)) << key;
  }
}

TEST(JobOrder, LaysRowsOfUnlikeLengthSideBySideAndLosesNone) {
  const auto jobs = jobs_at({{"1", "a"}, {"1", "b"}, {"1", "c"}, {"2", "a"}, {"3", "a"}, {"3", "b"}});
  EXPECT_THAT(order_by_cost(jobs, all_of(jobs), 2).jobs, ElementsAre(0, 3, 1, 2, 4, 5));
  EXPECT_THAT(order_by_cost(jobs, all_of(jobs), 8).jobs, ElementsAre(0, 3, 4, 1, 5, 2));
}

/// A board of groups of so many jobs, numbered on.
std::string board_of(const std::vector<std::uint64_t>& sizes) {
  JobOrder order;
  for (const std::uint64_t size : sizes) {
    const std::uint64_t first = order.jobs.size();
    order.groups.push_back({first, first + size, 1});
    for (std::uint64_t i = 0; i < size; ++i)
      order.jobs.push_back(static_cast<std::uint32_t>(order.jobs.size()));
  }
  const std::string path = (test::scratch_dir() / "board").string();
  JobBoard::create(path, order, 7);
  return path;
}

TEST(JobBoard, HandsEachJobOutOnceAMeshToOneRankUntilNoneIsLeft) {
  const std::string path = board_of({4, 2, 3});
  JobBoard a(path, 7), b(path, 7);
  EXPECT_THAT(a.claim(2, 0), ElementsAre(0));
  EXPECT_THAT(b.claim(2, 0), ElementsAre(4)) << "the first mesh is the other's";
  EXPECT_THAT(b.claim(2, 1), ElementsAre(5));
  EXPECT_THAT(b.claim(2, 1), ElementsAre(6)) << "the next that nobody has begun";
  EXPECT_THAT(a.claim(2, 1), ElementsAre(1));
  EXPECT_EQ(a.done_count(), 3u) << "of both";
  EXPECT_THAT(b.claim(2, 1), ElementsAre(7));
  EXPECT_THAT(b.claim(2, 1), ElementsAre(8));
  EXPECT_THAT(b.claim(2, 1), ElementsAre(2)) << "then it helps where most is left";
  EXPECT_THAT(a.claim(2, 1), ElementsAre(3));
  EXPECT_THAT(a.claim(2, 1), IsEmpty());
  EXPECT_THAT(b.claim(2, 1), IsEmpty());
}

TEST(JobBoard, HandsOutSeveralAtATimeWhereManyAreLeft) {
  const std::string path = board_of({160});
  JobBoard board(path, 7);
  EXPECT_EQ(board.claim(2, 0).size(), 10u) << "a sixteenth";
  EXPECT_EQ(board.claim(2, 0).size(), 9u);
  std::size_t total = 19;
  for (std::size_t count = 1; count > 0; total += count) count = board.claim(2, 0).size();
  EXPECT_EQ(total, 160u);
}

TEST(JobBoard, IsRefusedToARankThatHasReadOtherJobs) {
  const std::string path = board_of({1});
  EXPECT_THROW(JobBoard(path, 8), Error);
  write_bytes(path, 400);
  EXPECT_THROW(JobBoard(path, 7), Error);
}

TEST(RankLog, TellsWhatWasBegunByOneThatDiedAndWhatItHadOnlyTaken) {
  const std::string folder = test::scratch_dir().string();
  {
    RankLog log(folder, 3);
    log.took({5, 6, 7, 8});
    for (const std::size_t job : {5, 6, 7}) log.begins(job);
    log.ended(6, "[6]");
    EXPECT_EQ(rank_state(folder, 3), RankState::living);
    EXPECT_THROW(RankLog(folder, 3), Error) << "there is one rank of a number";
    log.died(9);
    log.begins(8);
  }
  EXPECT_EQ(rank_state(folder, 3), RankState::gone);
  EXPECT_EQ(rank_state(folder, 4), RankState::not_come);
  const RankStory story = read_rank_story(folder, 3);
  EXPECT_THAT(story.outcomes, ElementsAre("[6]"));
  EXPECT_THAT(story.not_begun, IsEmpty());
  ASSERT_EQ(story.lost.size(), 3u);
  EXPECT_EQ(story.lost[0].job, 5u);
  EXPECT_EQ(story.lost[1].job, 7u);
  EXPECT_THAT(story.lost[1].reason, HasSubstr("lost with rank 3 on "));
  EXPECT_THAT(story.lost[1].reason, HasSubstr("its process was ended by signal 9 (Killed)"));
  EXPECT_EQ(story.lost[2].job, 8u);
  EXPECT_THAT(story.lost[2].reason, HasSubstr("that rank was killed"));
}

TEST(RankLog, WhoseLastRecordTheDiskHasCutShortIsReadWithoutIt) {
  const fs::path folder = test::scratch_dir();
  {
    RankLog log(folder.string(), 0);
    log.took({1, 12});
    log.begins(1);
    log.ended(1, "[1]");
  }
  std::ofstream(folder / "rank-0000.log", std::ios::app) << "\nb 1";  // of 12
  const RankStory story = read_rank_story(folder.string(), 0);
  EXPECT_THAT(story.not_begun, ElementsAre(12));
  EXPECT_THAT(story.lost, IsEmpty());
}

TEST(RankLog, ThatIsLeftNoLongerCountsAsLiving) {
  const std::string folder = test::scratch_dir().string();
  RankLog log(folder, 0);
  EXPECT_TRUE(log.is_in_place());
  log.leave();
  EXPECT_EQ(rank_state(folder, 0), RankState::gone);
  fs::remove_all(folder);
  EXPECT_FALSE(log.is_in_place());
}

TEST(JobOutcome, ComesBackFromItsTextBitForBit) {
  std::vector<BatchJob> jobs(3), read(3);
  jobs[2].status = "caf\xC3\xA9 \"x\"\n;";
  jobs[2].figures = {0.1, -0.0, std::numeric_limits<double>::quiet_NaN()};
  jobs[2].contact_reasons = {"why"};
  jobs[2].kept_warnings = {"a.stl: is 1 mm long"};
  jobs[2].made_again = {"the scene has changed since", true};
  jobs[2].wrote_nothing = true;
  jobs[2].exit_code = 3;
  const std::string text = outcome_text(jobs[2], 2);
  EXPECT_EQ(text.find('\n'), std::string::npos) << "one record";
  take_outcome(read, text);
  EXPECT_EQ(read[2].status, jobs[2].status);
  ASSERT_EQ(read[2].figures.size(), 3u);
  EXPECT_EQ(std::signbit(read[2].figures[1]), true);
  EXPECT_TRUE(std::isnan(read[2].figures[2]));
  EXPECT_THAT(read[2].contact_reasons, ElementsAre("why"));
  EXPECT_THAT(read[2].kept_warnings, ElementsAre("a.stl: is 1 mm long"));
  EXPECT_EQ(read[2].made_again.why, "the scene has changed since");
  EXPECT_TRUE(read[2].made_again.of_other_build);
  EXPECT_TRUE(read[2].wrote_nothing);
  for (const char* nonsense :
       {"", "[9", "{}", "[2]", "[9,\"ok\",0,0,[],\"\",\"\",[],false,\"\",[],[],[],\"\",false,false]",
        "[2,7,0,0,[],\"\",\"\",[],false,\"\",[],[],[],\"\",false,false]",
        "[2,\"ok\",0,0,[],1,2,3,4,5,6,7,8,9,10,11]",
        "[\"\",\"ok\",0,0,[],\"\",\"\",[],false,\"\",[],[],[],\"\",false,false]"})
    take_outcome(read, nonsense);
  EXPECT_EQ(read[2].status, jobs[2].status) << "taken as a whole or not at all";
  EXPECT_EQ(read[2].exit_code, 3);
}

}  // namespace
}  // namespace fingerpad::shared_jobs_test
