#include <fmt/format.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "replay/batch_files.hpp"
#include "scene/scene_key.hpp"

namespace fingerpad {
namespace {

struct ReplayOptions {
  std::vector<std::string> scenes;
  BatchOptions batch;
  std::string format = "h5";
  std::string shard = "1/1";
  bool quiet = false;
};

int positive_integer(std::string_view text) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc{} && end == text.data() + text.size() ? value : 0;
}

void read_shard(const std::string& text, BatchOptions& batch) {
  const std::size_t slash = text.find('/');
  batch.shard = positive_integer(std::string_view(text).substr(0, slash));
  batch.shard_count =
      slash == std::string::npos ? 0 : positive_integer(std::string_view(text).substr(slash + 1));
  if (batch.shard < 1 || batch.shard_count < batch.shard) {
    throw Error(ErrorKind::usage, "--shard", fmt::format("'{}' is not K/N with 1 <= K <= N", text));
  }
}

/// That this process may run on: under mpirun often fewer than the machine has.
int processors() noexcept {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) return std::max(1, CPU_COUNT(&allowed));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

double figure(const BatchJob& job, std::string_view wanted) {
  const auto names = Figures::names();
  return job.figures[static_cast<std::size_t>(std::find(names.begin(), names.end(), wanted) - names.begin())];
}

/// Each job's error, and once for the batch what its figures warn of.
void tell_doubts(const std::vector<BatchJob>& jobs) {
  long coarse_jobs = 0;
  double coarse_teeth = 0, remedied_ticks = 0, inside_starts = 0;
  for (const BatchJob& job : jobs) {
    if (job.status.empty()) continue;
    if (job.status != "ok") {
      print_err("fingerpad: error: {}\n", job.status);
      if (!job.left_behind.empty())
        print_err("fingerpad: warning: {}: is an earlier run's, since this one failed\n", job.left_behind);
      continue;
    }
    const double coarse = figure(job, "coarse_teeth");
    coarse_jobs += coarse > 0 ? 1 : 0;
    coarse_teeth += coarse;
    remedied_ticks += figure(job, "remedied_ticks");
    inside_starts += figure(job, "inside_starts");
  }
  if (remedied_ticks > 0) {
    print_err(
        "fingerpad: warning: the stick spring was too stiff for the loop on {} ticks, and "
        "friction.remedy acted (remedied_ticks in summary.csv)\n",
        remedied_ticks);
  }
  if (inside_starts > 0) {
    print_err(
        "fingerpad: warning: {} of the motions start inside of a part, or where the finger does not fit; the "
        "proxy was put at the nearest place outside, where there is one (inside_starts in summary.csv)\n",
        inside_starts);
  }
  if (coarse_jobs == 0) return;
  print_err(
      "fingerpad: warning: {} stick-slip teeth in {} {} lasted under two ticks, too short for any sampling "
      "to "
      "show (coarse_teeth in summary.csv); raise motion.rate_hz or soften the pad\n",
      coarse_teeth, coarse_jobs, coarse_jobs == 1 ? "trace" : "traces");
}

/// What the program chose where scenes left it open, and how it read their motions: each part's and each
/// motion's line once, however many jobs have it.
void tell_choices(const std::vector<BatchJob>& jobs) {
  std::set<std::string_view> told;
  for (const BatchJob& job : jobs) {
    for (const auto* lines : {&job.motion_notes, &job.contact_reasons}) {
      for (const std::string& line : *lines) {
        if (told.insert(line).second) print_err("fingerpad: {}\n", line);
      }
    }
  }
}

/// What jobs warn of themselves, each line once.
void tell_warnings_of_jobs(const std::vector<BatchJob>& jobs) {
  std::set<std::string_view> told;
  for (const BatchJob& job : jobs) {
    for (const std::string& line : job.warnings) {
      if (told.insert(line).second) print_err("fingerpad: warning: {}\n", line);
    }
  }
}

int exit_code(const std::vector<BatchJob>& jobs) {
  if (jobs.size() == 1 && jobs[0].job.number == 0) return jobs[0].exit_code;
  const bool any_failed =
      std::any_of(jobs.begin(), jobs.end(), [](const BatchJob& job) { return job.exit_code != 0; });
  return any_failed ? 4 : 0;
}

/// How many of this rank's jobs are done, how far the others are, and what is being loaded for the next.
class JobBar {
 public:
  JobBar(std::size_t total, bool shown)
      : total_(total), bar_(shown, std::chrono::milliseconds(0), ProgressBar::End::kept) {}

  void advance(const BatchJob& job) {
    {
      const std::lock_guard lock(mutex_);
      ++done_;
      under_way_.erase(&job);
    }
    show(job.job.scene.name);
  }
  void load(std::string_view stage, double done) { show(fmt::format("{} {:.0f}%", stage, 100 * done)); }
  void run(const BatchJob& job, double share_done) {
    {
      const std::lock_guard lock(mutex_);
      under_way_[&job] = share_done;
    }
    show(fmt::format("{} {:.0f}%", job.job.scene.name, 100 * share_done));
  }
  void finish() { bar_.finish(); }

 private:
  void show(const std::string& what) {
    const std::lock_guard lock(mutex_);
    auto done = static_cast<double>(done_);
    for (const auto& [job, share] : under_way_) done += share;
    bar_.show(done / static_cast<double>(std::max<std::size_t>(total_, 1)),
              fmt::format("{}/{} {}", done_, total_, what));
  }

  std::mutex mutex_;
  std::size_t total_, done_ = 0;
  std::map<const BatchJob*, double> under_way_;  ///< the share that is done of each
  ProgressBar bar_;
};

/// A stream is read once, and of the ranks only the first has the standard input.
void refuse_streams(const std::vector<std::string>& scenes, const Ranks& ranks) {
  std::set<int> streams;
  for (const std::string& scene : scenes) {
    const auto stream = stream_descriptor(scene);
    if (!stream) continue;
    if (!streams.insert(*stream).second)
      throw Error(ErrorKind::usage, scene, "is named twice, and can be read only once");
    if (ranks.count() < 2) continue;
    throw Error(ErrorKind::usage, scene, "under mpirun a scene must be a file, which every rank can read");
  }
}

/// The tables that could not be written, and the code for it where the jobs themselves are good.
int tell_lost(const std::vector<Error>& lost) {
  for (const Error& error : lost) print_err("fingerpad: error: {}\n", error.what());
  return lost.empty() ? 0 : static_cast<int>(ErrorKind::fault);
}

void tell_end(const std::vector<BatchJob>& jobs, bool any_table_lost, const BatchOptions& batch) {
  const auto count = [&jobs](auto which) { return std::count_if(jobs.begin(), jobs.end(), which); };
  const auto ran = count([](const BatchJob& job) { return !job.status.empty(); });
  const auto good = count([](const BatchJob& job) { return job.status == "ok"; });
  const auto kept = count([](const BatchJob& job) { return job.kept; });
  print_out("{} of {} {} done{}, traces{} in {}\n", good, ran, ran == 1 ? "job" : "jobs",
            kept > 0 ? fmt::format(" ({} kept from before)", kept) : "",
            any_table_lost ? "" : " and " + table_names(batch.shard, batch.shard_count).summary,
            batch.out_dir);
}

int run_replay(const ReplayOptions& options, BatchOptions batch, const Ranks& ranks) {
  std::vector<BatchJob> jobs = batch_jobs(options.scenes);
  const auto share = static_cast<std::size_t>(ranks.count()) * static_cast<std::size_t>(batch.shard_count);
  JobBar bar((jobs.size() + share - 1) / share, !options.quiet && ranks.is_root() && stderr_is_terminal());
  batch.on_load = [&](std::string_view stage, double done) { bar.load(stage, done); };
  batch.on_ticks = [&](const BatchJob& job, double share_done) { bar.run(job, share_done); };
  batch.on_unfinished = [](const std::string& what) { print_err("fingerpad: warning: {}\n", what); };
  const std::vector<Error> lost =
      run_batch(jobs, batch, ranks, [&](const BatchJob& job) { bar.advance(job); });
  bar.finish();
  if (!ranks.is_root()) return 0;
  if (!options.quiet) tell_choices(jobs);
  tell_doubts(jobs);
  tell_warnings_of_jobs(jobs);
  const int lost_code = tell_lost(lost);
  if (!options.quiet) tell_end(jobs, !lost.empty(), batch);
  const int code = exit_code(jobs);
  return code != 0 ? code : lost_code;
}

int replay(ReplayOptions options) {
  read_shard(options.shard, options.batch);
  options.batch.format = options.format == "csv" ? TraceFormat::csv : TraceFormat::hdf5;
  options.batch.version = program_version;
  const Ranks ranks;
  try {
    refuse_streams(options.scenes, ranks);
    return run_replay(options, options.batch, ranks);
  } catch (const Error&) {
    if (ranks.is_root()) throw;
    return 0;  // every rank hears of it; one tells, and gives mpirun the code
  }
}

}  // namespace

namespace {

/// The table of laws for the help: name, what it is, and its own scene keys with defaults.
std::string laws_text() {
  std::string text = "\nLaws for [friction] law, with their own keys, defaults and meaning:\n";
  for (const LawEntry& law : law_table()) {
    text += fmt::format("  {:<17}{}\n", law.name, law.summary);
    for (const LawParameter& key : law.parameters) {
      text += fmt::format("      {} = {}: {}\n", key.key, key.default_value, key.meaning);
    }
  }
  return text;
}

}  // namespace

void add_replay(CLI::App& program, Action& action) {
  auto options = std::make_shared<ReplayOptions>();
  options->batch.threads = processors();
  CLI::App* command =
      program.add_subcommand("replay", "Follow each scene's motion over its parts and write the traces");
  command
      ->add_option("SCENE", options->scenes,
                   "Scene files (TOML); a scene with [[set]] is many jobs; - is a scene on standard input, "
                   "whose paths start in the current folder")
      ->required();
  refuse_empty(command->add_option("--out", options->batch.out_dir,
                                   "Folder for the traces, summary.csv and timing.csv"))
      ->required();
  command
      ->add_option("--jobs", options->batch.threads,
                   "Threads that share the jobs; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--format", options->format, "h5 or csv")
      ->check(CLI::IsMember({"h5", "csv"}))
      ->capture_default_str();
  command->add_flag("--resume", options->batch.resume,
                    "Keep complete traces of the very same runs instead of making them again");
  command->add_option("--shard", options->shard, "Run only every N-th job, from the K-th, counted from 1")
      ->type_name("K/N")
      ->capture_default_str();
  command->add_flag(
      "--quiet", options->quiet,
      "No progress, no choices of contact and no closing line; errors and warnings are still told");
  command->footer(
      "Writes OUT/<scene>.h5 (or .csv); a set's jobs are <scene>-0001.h5 and so on. summary.csv has a row "
      "for each job.\n"
      "Under mpirun the ranks share the jobs. Ends 4 if some jobs of a batch failed; the others are done all "
      "the same.\n" +
      laws_text() + contact_help_text() +
      "\nA scene file, each key with its default (mesh, file, profile and set: with an example):\n\n" +
      scene_keys_text());
  command->callback([options, &action] { action = [options] { return replay(*options); }; });
}

}  // namespace fingerpad
