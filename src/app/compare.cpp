#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "base/csv_cell.hpp"
#include "base/number_text.hpp"
#include "replay/folder_comparison.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

struct CompareOptions {
  std::string folder_a, folder_b, out;
  double tolerance = 0;
  std::size_t most = 10;
  bool quiet = false;
};

/// The jobs that differ most, in the order in which they were found where they differ alike.
class WorstJobs {
 public:
  explicit WorstJobs(std::size_t most) : most_(most) {}

  void take(ChangedJob&& job) {
    const auto place = std::upper_bound(jobs_.begin(), jobs_.end(), job,
                                        [](const auto& a, const auto& b) { return a.force_n > b.force_n; });
    if (place == jobs_.end() && jobs_.size() >= most_) return;
    jobs_.insert(place, std::move(job));
    if (jobs_.size() > most_) jobs_.pop_back();
  }

  const std::vector<ChangedJob>& jobs() const noexcept { return jobs_; }

 private:
  std::size_t most_;
  std::vector<ChangedJob> jobs_;
};

/// The jobs that one folder alone has: where, how many, and the first of them.
class AloneJobs {
 public:
  void take(const ChangedJob& job) {
    const auto group = std::find_if(groups_.begin(), groups_.end(),
                                    [&](const Group& one) { return one.words == job.alone; });
    Group& of_job = group == groups_.end() ? groups_.emplace_back(Group{job.alone, {}, 0}) : *group;
    if (of_job.first.size() < most_named) of_job.first.push_back(job.job);
    ++of_job.count;
    ++count_;
  }

  std::size_t count() const noexcept { return count_; }

  void tell() const {
    for (const Group& group : groups_) {
      const std::size_t more = group.count - group.first.size();
      if (more == 0) {
        for (const std::string& job : group.first) print_out("{}: {}\n", job, group.words);
      } else {
        print_out("{} jobs {}: {} and {} more\n", group.count,
                  "are" + group.words.substr(group.words.find(' ')), fmt::join(group.first, ", "), more);
      }
    }
  }

 private:
  static constexpr std::size_t most_named = 3;
  struct Group {
    std::string words;
    std::vector<std::string> first;
    std::size_t count;
  };
  std::vector<Group> groups_;
  std::size_t count_ = 0;
};

/// A row for each job and column that differs.
void write_rows(const ChangedJob& job, OutputFile& file) {
  for (const JobChange& change : job.changes)
    file.write(fmt::format("{},{},{},{},{},{}\n", csv_cell(job.job), change.column, number_text(change.most),
                           change.unit == "1" ? "" : change.unit, number_text(change.at_s),
                           csv_cell(change.words)));
}

void tell_changes(const CompareOptions& options, const FolderComparison& found, const WorstJobs& worst,
                  const AloneJobs& alone) {
  for (const ChangedJob& job : worst.jobs()) {
    for (const JobChange& change : job.changes) print_out("{}: {}\n", job.job, change.words);
  }
  const std::size_t more = found.differing + found.notes - alone.count() - worst.jobs().size();
  if (more > 0 && !options.quiet)
    print_out("and {} more job{}, whose forces differ by no more; --most N tells more, --out FILE.csv all\n",
              more, more == 1 ? "" : "s");
  alone.tell();
}

void tell_comparison(const CompareOptions& options, const FolderComparison& found) {
  const bool traces = found.traces > 0;
  const std::size_t count = traces ? found.traces : found.jobs;
  print_out("{} of {} {}{} changed from {} to {}\n", found.changed, count, traces ? "trace" : "job",
            count == 1 ? "" : "s", options.folder_a, options.folder_b);
}

int compare(const CompareOptions& options) {
  constexpr int changed_code = 4;
  if (!options.out.empty()) refuse_other_endings(options.out, "compare", {".csv"});
  std::optional<OutputFile> file;
  if (!options.out.empty()) {
    file.emplace(options.out);
    file->write("job,column,most,unit,at_s,what\n");
  }
  WorstJobs worst(options.most);
  AloneJobs alone;
  const FolderComparison found =
      compare_folders(options.folder_a, options.folder_b, options.tolerance, [&](ChangedJob&& job) {
        if (file) write_rows(job, *file);
        if (job.alone.empty()) {
          worst.take(std::move(job));
        } else {
          alone.take(job);
        }
      });
  if (file) file->commit();
  if (!file || !options.quiet) tell_changes(options, found, worst, alone);  // else the table has them all
  if (!options.quiet) tell_comparison(options, found);
  if (file) tell_written(options.quiet, options.out, "a row for each job and column that differs");
  return found.differing == 0 ? 0 : changed_code;
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      program.add_subcommand("compare", "Tell what differs between the traces of two folders");
  command->add_option("DIR_A", options->folder_a, "Folder of traces")->required();
  command->add_option("DIR_B", options->folder_b, "Folder of traces of the same names")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "What a column may differ by, in its own unit (phases and counts too)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--most", options->most,
                   "How many jobs to tell of that both have: those that ended otherwise, then the greatest "
                   "change of force")
      ->capture_default_str();
  refuse_empty(command->add_option("--out", options->out, "CSV table of all that differs"));
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A line for each trace and column that differs, with the greatest difference and its time; rows are "
      "set against each other by their time. Where a folder holds no trace, a line for each job and "
      "figure of summary.csv. Jobs of one folder alone are counted. With --quiet --out nothing is printed. "
      "Ends 0 where all are alike, 4 where something changed.");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace fingerpad
