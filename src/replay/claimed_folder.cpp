#include "replay/claimed_folder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "base/error.hpp"
#include "base/path_words.hpp"
#include "replay/batch_files.hpp"

namespace fingerpad {
namespace {

/// The root comes first, so that it tells what is refused; if it does not come, another does its work.
void wait_for_root(const BatchOptions& options, const Ranks& ranks) {
  using std::chrono::steady_clock;
  constexpr std::chrono::seconds patience{30};
  constexpr std::chrono::milliseconds between_looks{20};
  for (const auto end = steady_clock::now() + patience; steady_clock::now() < end;) {
    if (RunLock::is_registered(options.out_dir, ranks.run)) return;
    std::this_thread::sleep_for(between_looks);
  }
}

void make_folder(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw Error(output_fault(failure.value()), folder,
                "cannot be made: " + path_words(folder + "/", failure.value()));
}

}  // namespace

std::unique_ptr<RunLock> claimed_folder(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                                        const Ranks& ranks, const std::function<void()>& when_first) {
  if (!ranks.is_root()) wait_for_root(options, ranks);
  const bool others_came = ranks.are_many() && RunLock::is_registered(options.out_dir, ranks.run);
  if (!others_came) {
    refuse_collisions(jobs, options);
    make_folder(options.out_dir);
  }
  return std::make_unique<RunLock>(
      options.out_dir, output_names(jobs, options), ranks.run, [&](const RunLock& lock) {
        if (others_came) refuse_collisions(jobs, options);  // who came was of an earlier run
        for (const std::string& run : lock.unfinished()) {
          if (options.on_unfinished)
            options.on_unfinished(fmt::format("{}: {} ended before it was done; this run takes its place",
                                              options.out_dir, run));
        }
        const std::string kept = keep_other_summary(jobs, options);
        if (options.on_kept && !kept.empty()) options.on_kept(kept);
        when_first();
      });
}

}  // namespace fingerpad
