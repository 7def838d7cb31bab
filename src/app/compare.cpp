#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"
#include "base/csv_cell.hpp"
#include "base/file_identity.hpp"
#include "base/number_text.hpp"
#include "replay/folder_comparison.hpp"
#include "replay/trace_comparison.hpp"
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

/// "mu by 0.1": of a column, where another one is told in full.
std::string short_words(const JobChange& change) {
  if (std::isinf(change.most)) return change.column + " from a number to none";
  return fmt::format("{} by {}{}", change.column, rounded_text(change.most, 6),
                     change.unit == "1" ? "" : fmt::format(" {}", change.unit));
}

/// The columns of a trace that differ, in a line: the force that differs most in full, a few more in short.
void tell_columns(const std::string& job, const std::vector<const JobChange*>& columns) {
  constexpr std::size_t most_in_short = 4;
  const auto force_n = [](const JobChange* change) { return change->unit == "N" ? change->most : -1; };
  const JobChange* first = columns.front();
  for (const JobChange* change : columns) {
    if (force_n(change) >= std::max(0.0, force_n(first))) first = change;
  }
  std::vector<std::string> others;  // forces before what they come from
  for (const bool of_force : {true, false}) {
    for (const JobChange* change : columns) {
      if (change != first && (change->unit == "N") == of_force && others.size() < most_in_short)
        others.push_back(short_words(*change));
    }
  }
  const std::size_t more = columns.size() - 1 - others.size();
  print_out("{}: {}{}{}{}\n", job, first->words, others.empty() ? "" : "; ", fmt::join(others, ", "),
            more == 0 ? "" : fmt::format(" and {} more column{}", more, more == 1 ? "" : "s"));
}

/// A line for what is said of the job itself, and one for all its columns or figures.
void tell_changed_job(const ChangedJob& job) {
  const auto tells_way = [](const JobChange& change) { return is_of_the_way(change.column); };
  std::vector<const JobChange*> columns;
  std::vector<std::string> figures;
  for (const JobChange& change : job.changes) {
    if (change.column.empty()) {
      print_out("{}: {}\n", job.job, change.words);
    } else if (std::isnan(change.at_s)) {
      figures.push_back(change.words);
    } else if (!tells_way(change)) {  // else it is said of the job
      columns.push_back(&change);
    }
  }
  if (!figures.empty()) print_out("{}: {}\n", job.job, fmt::join(figures, "; "));
  if (!columns.empty()) tell_columns(job.job, columns);
}

void tell_changes(const CompareOptions& options, const FolderComparison& found, const WorstJobs& worst,
                  const AloneJobs& alone) {
  for (const ChangedJob& job : worst.jobs()) tell_changed_job(job);
  const std::size_t more = found.differing + found.notes - alone.count() - worst.jobs().size();
  if (more > 0 && !options.quiet)
    print_out("and {} more job{}, whose forces differ by no more; --most N tells more, --out FILE.csv all\n",
              more, more == 1 ? "" : "s");
  alone.tell();
}

/// Which traces were not read to the end of their runs.
void tell_early_ends(const std::vector<std::string>& early_ends) {
  constexpr std::size_t most_told = 12;
  const std::size_t told = std::min(early_ends.size(), most_told);
  for (std::size_t i = 0; i < told; ++i) print_err("fingerpad: warning: {}\n", early_ends[i]);
  if (early_ends.size() > told)
    print_err("fingerpad: warning: and {} with an early end\n",
              count_words(early_ends.size() - told, "more trace"));
}

void tell_comparison(const CompareOptions& options, const FolderComparison& found) {
  const bool traces = found.traces > 0;
  const std::size_t count = traces ? found.traces : found.jobs;
  print_out("{} of {} {}{} changed from {} to {}\n", found.changed, count, traces ? "trace" : "job",
            count == 1 ? "" : "s", options.folder_a, options.folder_b);
}

/// What is wrong with a tolerance; empty where nothing is. A word that is no number is told elsewhere.
std::string why_no_tolerance(const std::string& text) {
  const auto value = parse_number(text);
  return value && !(*value >= 0) ? fmt::format("is {}; it must be 0 or more", text) : "";
}

constexpr std::string_view table_header = "job,column,most,unit,at_s,what\n";

/// Of what stands in the two folders only a table of an earlier comparison may be written over.
void refuse_overwriting_folders(const CompareOptions& options) {
  std::vector<std::string> inputs;
  for (const std::string& folder : {options.folder_a, options.folder_b}) {
    std::error_code none;  // a folder that cannot be read is told by compare_folders
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
      if (!entry.is_regular_file(none)) continue;
      std::string first(table_header.size(), '\0');
      std::ifstream(entry.path()).read(first.data(), static_cast<std::streamsize>(first.size()));
      if (first != table_header) inputs.push_back(entry.path().string());
    }
  }
  refuse_overwriting(options.out, inputs);
}

int compare(const CompareOptions& options) {
  constexpr int changed_code = 4;
  if (!options.out.empty()) refuse_other_endings(options.out, "compare", {".csv"});
  std::optional<OutputFile> file;
  if (!options.out.empty()) {
    refuse_overwriting_folders(options);
    file.emplace(options.out);
    file->write(std::string(table_header));
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
  tell_early_ends(found.early_ends);
  for (const std::string& words : found.damaged) print_err("fingerpad: error: {}\n", words);
  if (!file || !options.quiet) tell_changes(options, found, worst, alone);  // else the table has them all
  if (!options.quiet) {
    for (const std::string& words : found.passed_over) print_out("{}\n", words);
    tell_comparison(options, found);
  }
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
      ->check(CLI::Validator(why_no_tolerance, "X"))
      ->capture_default_str();
  command
      ->add_option("--most", options->most,
                   "How many jobs to tell of that both have: those that ended otherwise, then the greatest "
                   "change of force")
      ->capture_default_str();
  refuse_empty(command->add_option("--out", options->out, "CSV table of all that differs"));
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A line for each trace that differs: by how much its forces do at most, and when, then its other "
      "columns, and before it where its motion is another; --out has a row for each column. Rows are set "
      "against each other by their time, those of an HDF5 trace "
      "against those of a CSV one too. Where a folder holds no trace, a line for each job and its figures "
      "of summary.csv. Jobs of one folder alone are counted, and files that are no traces named. "
      "With --quiet --out nothing is printed. "
      "Ends 0 where all are alike, 4 where something changed.");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace fingerpad
