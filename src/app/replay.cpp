#include <fmt/format.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <thread>

#include "app/columns_option.hpp"
#include "app/commands.hpp"
#include "app/job_bar.hpp"
#include "app/number_option.hpp"
#include "app/output_folder.hpp"
#include "app/output_name.hpp"
#include "app/plan_words.hpp"
#include "app/replay_words.hpp"
#include "app/standard_streams.hpp"
#include "app/stop_request.hpp"
#include "app/word_option.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "replay/batch.hpp"
#include "replay/batch_files.hpp"
#include "scene/scene_key.hpp"

namespace fingerpad {
namespace {

struct ReplayOptions {
  std::vector<std::string> scenes;
  BatchOptions batch;
  std::string format = "h5";
  std::string shard = "1/1";
  std::string columns;  ///< of the traces, parted by commas; empty: all
  bool quiet = false;
  bool dry_run = false;
  double progress_s = 10;  ///< between lines where there is no terminal
};

constexpr int jobs_failed_code = 4;

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

int exit_code(const std::vector<BatchJob>& jobs) {
  if (is_lone_scene(jobs)) return jobs[0].exit_code;
  const bool any_failed =
      std::any_of(jobs.begin(), jobs.end(), [](const BatchJob& job) { return job.exit_code != 0; });
  return any_failed ? jobs_failed_code : 0;
}

/// A stream is read once, and of the ranks only the first has the standard input.
void refuse_streams(const std::vector<std::string>& scenes, const Ranks& ranks) {
  std::set<int> streams;
  for (const std::string& scene : scenes) {
    const auto stream = stream_descriptor(scene);
    if (!stream) continue;
    if (!streams.insert(*stream).second)
      throw Error(ErrorKind::usage, scene, "is named twice, and can be read only once");
    if (!ranks.are_many()) continue;
    throw Error(ErrorKind::usage, scene, "under mpirun a scene must be a file, which every rank can read");
  }
}

/// run_batch(), where a rank that cannot take part says why: the others go on without it.
BatchEnd run_or_tell(std::vector<BatchJob>& jobs, const BatchOptions& batch, const Ranks& ranks,
                     const std::function<void(const BatchJob&)>& on_done) {
  try {
    return run_batch(jobs, batch, ranks, on_done);
  } catch (const Error& error) {
    if (!ranks.is_root()) print_err("fingerpad: warning: rank {} leaves: {}\n", ranks.rank, error.what());
    throw;
  }
}

int run_replay(const ReplayOptions& options, BatchOptions batch, const Ranks& ranks) {
  std::vector<BatchJob> jobs = batch_jobs(options.scenes);
  if (options.dry_run) {
    if (!ranks.is_root()) return 0;
    std::optional<OutputFolder> tried;  // gone again: what is planned could be written
    if (!batch.out_dir.empty()) tried.emplace(batch.out_dir);
    const bool would_do = tell_plan(plan_batch(jobs, batch), batch);
    return would_do ? 0 : is_lone_scene(jobs) ? static_cast<int>(ErrorKind::refused) : jobs_failed_code;
  }
  const bool silent = options.quiet || !ranks.is_root();
  JobBar bar(jobs_of_shard(jobs.size(), batch).size(), shown_progress(silent),
             std::chrono::milliseconds(std::lround(1e3 * options.progress_s)));
  const StopRequest stop;
  batch.should_stop = [&stop] { return stop.come(); };
  bar.watch_stop(batch.should_stop, [&stop] { return stop.come_by_interrupt(); });
  batch.on_load = [&](std::string_view stage, double done) { bar.load(stage, done); };
  batch.on_ticks = [&](const BatchJob& job, double share_done) { bar.run(job, share_done); };
  batch.on_unfinished = [](const std::string& what) { print_err("fingerpad: warning: {}\n", what); };
  if (!options.quiet) batch.on_kept = [](const std::string& what) { print_err("fingerpad: {}\n", what); };
  batch.on_elsewhere = [&](std::size_t count) { bar.elsewhere(count); };
  const BatchEnd end = run_or_tell(jobs, batch, ranks, [&](const BatchJob& job) { bar.advance(job); });
  bar.finish();
  if (!end.tells) return 0;
  if (!options.quiet) tell_choices(jobs);
  tell_doubts(jobs);
  tell_warnings_of_jobs(jobs);
  tell_made_again(jobs, batch, options.quiet);
  const int lost_code = tell_lost(end.lost);
  if (!options.quiet) tell_end(jobs, !end.lost.empty() || leaves_folder_alone(jobs), batch);
  const auto is_left = [](const BatchJob& job) { return job.not_begun; };
  if (std::any_of(jobs.begin(), jobs.end(), is_left)) {
    tell_stopped(jobs, batch);
    return jobs_failed_code;
  }
  const int code = exit_code(jobs);
  return code != 0 ? code : lost_code;
}

int replay(ReplayOptions options) {
  read_shard(options.shard, options.batch);
  options.batch.traces = options.format != "none";
  if (!options.batch.traces && options.batch.resume)
    throw Error(ErrorKind::usage, "--resume",
                "keeps traces, of which --format none writes none; leave one out");
  refuse_columns_as_inputs(options.scenes, options.columns);
  if (!options.columns.empty()) options.batch.choice.columns = chosen_columns(options.columns, "--columns");
  if (!options.batch.traces && !options.batch.choice.is_all())
    throw Error(ErrorKind::usage, "--format none",
                "writes no traces, of which --columns and --every say what they hold; leave one out");
  if (options.batch.choice.deflated && options.format != "h5")
    throw Error(ErrorKind::usage, "--compress", "is for the traces of --format h5; leave one out");
  options.batch.format = options.format == "csv" ? TraceFormat::csv : TraceFormat::hdf5;
  options.batch.version = program_version;
  const Ranks ranks = launched_ranks();
  try {
    refuse_streams(options.scenes, ranks);
    return run_replay(options, options.batch, ranks);
  } catch (const Error&) {
    if (ranks.is_root()) throw;
    return 0;  // every rank comes to it; one tells, and gives the launcher the code
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
                                   "Folder for the traces, summary.csv and timing.csv; required, but with "
                                   "--dry-run"),
               "FOLDER");
  command
      ->add_option("--jobs", options->batch.threads,
                   "Threads that share the jobs; results do not depend on it")
      ->check(whole_number_in(1, 1024))
      ->capture_default_str();
  command->add_option("--format", options->format, "h5, csv, or none: summary.csv alone")
      ->check(one_of({"h5", "csv", "none"}))
      ->capture_default_str();
  command->add_flag("--resume", options->batch.resume,
                    "Keep complete traces of the very same runs instead of making them again");
  command
      ->add_option(
          "--columns", options->columns,
          "Write these columns of the traces alone, parted by commas, beside t_s (names: see `export "
          "--help`)")
      ->type_name("LIST");
  command->add_option("--every", options->batch.choice.every, "Write every N-th tick alone, and the last")
      ->type_name("N")
      ->check(whole_number_in(1, 1'000'000'000))
      ->capture_default_str();
  command
      ->add_option("--memory", options->batch.memory_bytes,
                   "Keep as many meshes loaded as fit into this, such as 500M or 4G, beside those in use, "
                   "and begin with no further one beyond it while jobs of those are left; without it those "
                   "of one job more than --jobs")
      ->type_name("SIZE")
      ->transform(memory_size());
  command->add_flag(
      "--compress", options->batch.choice.deflated,
      "Deflate the traces' columns and meshes (h5): smaller files that take longer to write, and "
      "are read as any other");
  command->add_option("--shard", options->shard, "Run only every N-th job, from the K-th, counted from 1")
      ->type_name("K/N")
      ->capture_default_str();
  command->add_flag(
      "--dry-run", options->dry_run,
      "Write nothing; list the jobs with their ticks, and reckon time and disk from a short try");
  command
      ->add_option("--progress", options->progress_s,
                   "Where standard error is no terminal, tell how far the jobs are every so many seconds")
      ->check(number_in(0, 1e6, "seconds"))
      ->capture_default_str();
  command
      ->add_option_function<double>(
          "--wait-for-ranks",
          [options](double seconds) { options->batch.patience = std::chrono::duration<double>(seconds); },
          "How many seconds ranks wait for those that have not come: all for the first, the last for the "
          "others")
      ->type_name("SECONDS")
      ->check(number_in(0, 1e6, "seconds"))
      ->default_str("30");
  command->add_flag(
      "--quiet", options->quiet,
      "No progress, no choices of contact and no closing line; errors and warnings are still told");
  command->footer(
      "Writes OUT/<scene>.h5 (or .csv); a set's jobs are <scene>-0001.h5 and so on. summary.csv has a row "
      "for each job.\n"
      "jobs.csv says which file of a set is of which mesh, motion and values. SIGINT and SIGTERM finish the "
      "jobs "
      "that have begun, and --resume does the rest.\n"
      "Under mpirun or srun the ranks share the jobs; one that dies loses those that it had begun. Open MPI "
      "ends "
      "all ranks with one that is killed as a whole, unless told `mpirun --enable-recovery`. Ends 4 if some "
      "jobs of a batch failed; the others are done all the same.\n" +
      laws_text() + contact_help_text() +
      "\nA scene file, each key with its default (mesh, file, profile and set: with an example):\n\n" +
      scene_keys_text());
  command->callback([options, &action] {
    if (options->batch.out_dir.empty() && !options->dry_run) throw CLI::RequiredError("--out");
    action = [options] { return replay(*options); };
  });
}

}  // namespace fingerpad
