#include "replay/job_board.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <system_error>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/path_words.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

// Numbers of eight bytes: what it is, the batch, how many jobs and groups; then what changes, how many groups
// are begun and how many jobs ended, and the next job of each group; then the groups' ends and costs, and the
// jobs.
constexpr std::uint64_t board_mark = 0x3164726f61627066;  // "fpboard1"
enum BoardPlace : std::uint64_t {
  at_mark,
  at_batch,
  at_job_count,
  at_group_count,
  at_groups_begun,
  at_jobs_done,
  at_next_jobs
};

void put_number(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

}  // namespace

void JobBoard::create(const std::string& path, const JobOrder& order, std::uint64_t batch) {
  std::string bytes;
  bytes.reserve((at_next_jobs + 3 * order.groups.size() + order.jobs.size()) * sizeof(std::uint64_t));
  for (const std::uint64_t number : {board_mark, batch, std::uint64_t{order.jobs.size()},
                                     std::uint64_t{order.groups.size()}, std::uint64_t{0}, std::uint64_t{0}})
    put_number(bytes, number);
  for (const JobGroup& group : order.groups) put_number(bytes, group.first);
  for (const JobGroup& group : order.groups) put_number(bytes, group.end);
  for (const JobGroup& group : order.groups) put_number(bytes, std::bit_cast<std::uint64_t>(group.cost_each));
  for (const std::uint32_t job : order.jobs) put_number(bytes, job);
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

JobBoard::JobBoard(const std::string& path, std::uint64_t batch) : path_(path) {
  constexpr InputKind board_file{"a board of jobs", std::uint64_t{1} << 40};
  const std::string bytes = read_whole_file(path, board_file);
  const auto number = [&](std::uint64_t place) {
    std::uint64_t value = 0;
    if ((place + 1) * sizeof(value) <= bytes.size())
      std::copy_n(bytes.data() + place * sizeof(value), sizeof(value), reinterpret_cast<char*>(&value));
    return value;
  };
  const std::uint64_t jobs = number(at_job_count), groups = number(at_group_count);
  if (number(at_mark) != board_mark ||
      bytes.size() != (at_next_jobs + 3 * groups + jobs) * sizeof(std::uint64_t))
    throw refused(path, "is no board of jobs that ranks share");
  if (number(at_batch) != batch)
    throw refused(path, "is of other jobs than this rank has read: do all ranks see the same files?");
  for (std::uint64_t g = 0; g < groups; ++g)
    order_.groups.push_back(
        {0, number(at_next_jobs + groups + g), std::bit_cast<double>(number(at_next_jobs + 2 * groups + g))});
  for (std::uint64_t i = 0; i < jobs; ++i)
    order_.jobs.push_back(static_cast<std::uint32_t>(number(at_next_jobs + 3 * groups + i)));
  file_ = OpenFile(open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (file_.number() < 0) throw Error(output_fault(errno), path, path_words(path, errno));
}

std::uint64_t JobBoard::read_number(std::uint64_t place) const {
  std::uint64_t value = 0;
  if (pread(file_.number(), &value, sizeof(value), static_cast<off_t>(place * sizeof(value))) !=
      sizeof(value))
    throw Error(ErrorKind::fault, path_, "cannot be read: " + path_words(path_, errno));
  return value;
}

void JobBoard::write_number(std::uint64_t place, std::uint64_t value) const {
  if (pwrite(file_.number(), &value, sizeof(value), static_cast<off_t>(place * sizeof(value))) !=
      sizeof(value))
    throw Error(ErrorKind::fault, path_, "cannot be written: " + path_words(path_, errno));
}

std::size_t JobBoard::most_left() const {
  std::size_t best = SIZE_MAX;
  double most = 0;
  for (std::size_t g = 0; g < order_.groups.size(); ++g) {
    const JobGroup& group = order_.groups[g];
    const double left = static_cast<double>(group.end - read_number(at_next_jobs + g)) * group.cost_each;
    if (left > most) {
      most = left;
      best = g;
    }
  }
  return best;
}

std::vector<std::size_t> JobBoard::claim(int ranks, std::size_t done_since) {
  const Hold hold(*this);
  done_ = read_number(at_jobs_done) + done_since;
  if (done_since > 0) write_number(at_jobs_done, done_);
  const auto has_jobs = [this](std::size_t g) {
    return g < order_.groups.size() && read_number(at_next_jobs + g) < order_.groups[g].end;
  };
  if (!has_jobs(group_)) {
    const std::uint64_t begun = read_number(at_groups_begun);
    if (begun < order_.groups.size()) write_number(at_groups_begun, begun + 1);
    group_ = begun < order_.groups.size() ? begun : most_left();
    if (!has_jobs(group_)) return {};
  }
  // A share of what is left, so that a group that others help with ends for all at about the same time.
  constexpr std::uint64_t most_at_once = 32, shares_a_rank = 8;
  const std::uint64_t next = read_number(at_next_jobs + group_), left = order_.groups[group_].end - next;
  const std::uint64_t count =
      std::clamp<std::uint64_t>(left / (shares_a_rank * static_cast<std::uint64_t>(ranks)), 1, most_at_once);
  write_number(at_next_jobs + group_, next + count);
  std::vector<std::size_t> claimed;
  for (std::uint64_t k = next; k < next + count; ++k) claimed.push_back(order_.jobs[k]);
  return claimed;
}

JobBoard::Hold::Hold(const JobBoard& board) : file_(board.file_.number()) {
  if (wait_for_lock(file_, LOCK_EX)) return;
  const int problem = errno;
  throw Error(
      ErrorKind::fault, board.path_,
      fmt::format("cannot be locked ({}), by which ranks share a batch; start it again, with --resume "
                  "where it writes traces, or without ranks, where --shard K/N does a share",
                  std::generic_category().message(problem)));
}

std::unique_ptr<JobBoard::Hold> JobBoard::Hold::at_once(const JobBoard& board) {
  const int file = board.file_.number();
  return std::unique_ptr<Hold>(try_lock(file, LOCK_EX) == Locking::got ? new Hold(file) : nullptr);
}

JobBoard::Hold::~Hold() {
  unlock(file_);
}

}  // namespace fingerpad
