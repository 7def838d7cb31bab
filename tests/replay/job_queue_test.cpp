#include "replay/job_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fingerpad::job_queue_test {
namespace {
using testing::ElementsAre;

/// Groups of so many jobs, numbered on.
JobOrder order_of(const std::vector<std::uint64_t>& sizes) {
  JobOrder order;
  for (const std::uint64_t size : sizes) {
    const std::uint64_t first = order.jobs.size();
    order.groups.push_back({first, first + size, 1});
    for (std::uint64_t k = 0; k < size; ++k) order.jobs.push_back(static_cast<std::uint32_t>(first + k));
  }
  return order;
}

/// Which jobs the threads get that ask in this order; -1: none.
std::vector<int> asked_by(JobQueue& queue, const std::vector<std::size_t>& threads) {
  std::vector<int> jobs;
  for (const std::size_t thread : threads) {
    const auto job = queue.next(thread);
    jobs.push_back(job ? static_cast<int>(*job) : -1);
  }
  return jobs;
}

bool always() {
  return true;
}
bool never() {
  return false;
}

TEST(JobQueue, GivesOneThreadAllJobsInTheirOrder) {
  JobQueue queue(order_of({2, 1, 2}), always);
  EXPECT_THAT(asked_by(queue, {0, 0, 0, 0, 0, 0}), ElementsAre(0, 1, 2, 3, 4, -1));
}

TEST(JobQueue, GivesEachThreadMeshesOfItsOwnSoThatNoneWaitsForALoad) {
  JobQueue queue(order_of({3, 2, 2}), always);
  EXPECT_THAT(asked_by(queue, {0, 1, 1, 0, 1}), ElementsAre(0, 3, 4, 1, 5));
}

TEST(JobQueue, LetsAThreadHelpWhereMostIsLeftOnceAllMeshesAreBegun) {
  JobQueue queue(order_of({4, 2, 1}), always);
  EXPECT_THAT(asked_by(queue, {0, 1, 2, 2, 2, 1, 1, 0}), ElementsAre(0, 4, 6, 1, 2, 5, 3, -1));
}

TEST(JobQueue, BeginsWithNoFurtherMeshWhereThereIsNoRoomForIt) {
  JobQueue queue(order_of({3, 2}), never);
  EXPECT_THAT(asked_by(queue, {0, 1, 2, 1, 0, 1}), ElementsAre(0, 1, 2, 3, 4, -1))
      << "the next when nothing else is left to be begun";
}

}  // namespace
}  // namespace fingerpad::job_queue_test
