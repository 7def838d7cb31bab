#include "replay/rank_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

// A record is a line of its own: a mark, words, and the mark of its end. One that the disk has cut short has
// no end, and the next begins a new line all the same.
constexpr char host_mark = 'h', took_mark = 't', begins_mark = 'b', ended_mark = 'e', died_mark = 'd',
               left_mark = 'l';
constexpr char record_end = ';';

std::string log_path(const std::string& folder, int rank) {
  return fmt::format("{}/rank-{:04}.log", folder, rank);
}

/// Reads a log's records into a story.
class StoryReader {
 public:
  explicit StoryReader(int rank) : rank_(rank) {}

  void take(char mark, std::string_view words) {
    switch (mark) {
      case host_mark:
        host_ = words;
        break;
      case took_mark:
        each_number(words, [this](std::size_t job) { taken_.insert(job); });
        break;
      case begins_mark:
        each_number(words, [this](std::size_t job) {
          taken_.erase(job);
          begun_.insert(job);
        });
        break;
      case ended_mark: {
        const std::size_t space = words.find(' ');
        each_number(words.substr(0, space), [this](std::size_t job) { begun_.erase(job); });
        if (space != std::string_view::npos) story_.outcomes.emplace_back(words.substr(space + 1));
        break;
      }
      case died_mark:
        each_number(words, [this](std::size_t signal) { lose(death_words(static_cast<int>(signal))); });
        break;
      case left_mark:
        lose("how it ended could not be kept");
        break;
      default:
        break;
    }
  }

  RankStory end() {
    story_.ends_at_a_job = !begun_.empty();
    lose("that rank was killed");
    story_.not_begun.assign(taken_.begin(), taken_.end());
    return std::move(story_);
  }

 private:
  template <typename Take>
  static void each_number(std::string_view words, Take take) {
    const char* at = words.data();
    const char* const end = at + words.size();
    while (at < end) {
      std::size_t number = 0;
      const auto [next, status] = std::from_chars(at, end, number);
      if (status != std::errc{}) return;
      take(number);
      at = next < end ? next + 1 : next;
    }
  }

  static std::string death_words(int signal) {
    const char* name = strsignal(signal);
    return fmt::format("its process was ended by signal {} ({})", signal, name == nullptr ? "unknown" : name);
  }

  void lose(const std::string& how) {
    for (const std::size_t job : begun_)
      story_.lost.push_back({job, fmt::format("lost with rank {} on {}: {}", rank_, host_, how)});
    begun_.clear();
  }

  int rank_;
  std::string host_ = "?";
  std::set<std::size_t> taken_, begun_;
  RankStory story_;
};

}  // namespace

RankLog::RankLog(const std::string& folder, int rank) : path_(log_path(folder, rank)) {
  file_ = OpenFile(open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (file_.number() < 0) throw Error(output_fault(errno), path_, path_words(path_, errno));
  const Locking locking = try_lock(file_.number(), LOCK_EX);
  if (locking == Locking::busy)
    throw refused(path_,
                  fmt::format("is held by another process: rank {} of this run is there already", rank));
  if (locking == Locking::impossible)
    throw Error(ErrorKind::fault, path_,
                "cannot be locked, by which ranks share a batch; without ranks, --shard K/N does a share");
  add(fmt::format("{} {}", host_mark, host_name()));
}

bool RankLog::is_in_place() const noexcept {
  return is_at(file_.number(), path_);
}

void RankLog::add(std::string_view record) {
  // A log that cannot be written says less: what it does not say is told as lost in the end.
  const std::string line = fmt::format("\n{}{}", record, record_end);
  write_all(file_.number(), line.data(), line.size());
}

void RankLog::took(const std::vector<std::size_t>& jobs) {
  if (!jobs.empty()) add(fmt::format("{} {}", took_mark, fmt::join(jobs, " ")));
}

void RankLog::begins(std::size_t job) {
  add(fmt::format("{} {}", begins_mark, job));
}

void RankLog::ended(std::size_t job, const std::string& outcome) {
  add(fmt::format("{} {} {}", ended_mark, job, outcome));
}

void RankLog::died(int signal) {
  add(fmt::format("{} {}", died_mark, signal));
}

void RankLog::leave() {
  add(std::string(1, left_mark));
  unlock(file_.number());
}

RankState rank_state(const std::string& folder, int rank) {
  const OpenFile file(open(log_path(folder, rank).c_str(), O_RDWR | O_CLOEXEC));
  if (file.number() < 0) return RankState::not_come;
  return try_lock(file.number(), LOCK_EX) == Locking::busy ? RankState::living : RankState::gone;
}

RankStory read_rank_story(const std::string& folder, int rank) {
  constexpr InputKind log_file{"a rank's log", std::uint64_t{1} << 40};
  StoryReader reader(rank);
  const std::string path = log_path(folder, rank);
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return reader.end();
  const std::string text = read_whole_file(path, log_file);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, line_end - at);
    at = line_end + 1;
    if (line.empty() || line.back() != record_end) continue;
    line.remove_suffix(1);
    reader.take(line.front(), line.size() > 2 ? line.substr(2) : std::string_view());
  }
  return reader.end();
}

}  // namespace fingerpad
