#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/commands.hpp"
#include "app/count_bar.hpp"
#include "app/number_option.hpp"
#include "app/output_name.hpp"
#include "app/report_page.hpp"
#include "app/report_run.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/near_file.hpp"
#include "base/output_place.hpp"
#include "trace/output_file.hpp"
#include "trace/trace.hpp"
#include "trace/trace_glance.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string folder, out;
  std::string libraries = debian_javascript_folder;
  std::size_t details = 500;
  double progress_s = 10;  ///< between lines where there is no terminal
  bool quiet = false;
};

/// Whose mesh is not named twice; the shapes that the page will hold, as far as the tables tell.
std::size_t shapes_of(const BatchResults& batch) {
  std::set<std::string> meshes;
  for (const JobOutcome& job : batch.jobs) meshes.insert(job.mesh);
  return meshes.size();
}

/// Why a job has neither picture nor charts; empty where it has.
/// @param drawn  how many are already
std::string missing_run(const JobOutcome& job, std::size_t drawn, std::size_t details) {
  if (job.trace.empty() && !job.done()) return "The job failed, so there is nothing to be drawn.";
  if (job.trace.empty())
    return "The folder has no trace of this job (replay --format none writes none), so there is nothing to "
           "be "
           "drawn.";
  if (drawn >= details)
    return fmt::format(
        "Only the {} worst jobs with a trace are drawn; `fingerpad report --details` draws more. Of the "
        "others' traces "
        "only the beginning and the end are looked at.",
        details);
  return "";
}

/// Puts a damaged trace among its job's troubles.
/// @param damage  which file, and what is wrong with it
void flag(nlohmann::ordered_json& row, const std::string& trouble, const std::string& damage) {
  const auto before = row["trouble"].get<std::string>();
  row["trouble"] = before.empty() ? trouble : before + ", " + trouble;
  row["damage"] = damage;
}

/// Flags the trace of a job that is not drawn, where its beginning or its end shows that it is damaged.
void look_at_undrawn(const JobOutcome& job, nlohmann::ordered_json& row) {
  if (looks_whole(job.trace)) return;
  try {
    const std::string ends_early = early_end_words(read_trace(job.trace, TraceContents::some_rows));
    if (!ends_early.empty()) flag(row, "trace cut short", job.trace + ": " + ends_early);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    flag(row, "trace cannot be read", error.what());
  }
}

/// Flags a job that is done and has no trace, where others have.
void flag_missing(const std::string& folder, const JobOutcome& job, nlohmann::ordered_json& row) {
  const std::string name = job.number > 0 ? fmt::format("{}-{:04}", job.scene, job.number) : job.scene;
  flag(row, "trace is missing",
       fmt::format("{}: has no trace, as other jobs have", (fs::path(folder) / name).string()));
}

/// The first of them each in a line; the page flags all.
void tell_damage(const nlohmann::ordered_json& rows) {
  constexpr std::size_t most_told = 10;
  std::size_t damaged = 0;
  for (const auto& row : rows) {
    if (!row.contains("damage") || ++damaged > most_told) continue;
    print_err("fingerpad: warning: {}; `fingerpad replay --resume` makes it again\n",
              row["damage"].get<std::string>());
  }
  if (damaged > most_told)
    print_err("fingerpad: warning: and {} in the page's column `trouble`\n",
              count_words(damaged - most_told, "more damaged trace"));
}

/// Adds the runs of the worst jobs. @returns how many
std::size_t add_runs(const ReportOptions& options, const BatchResults& batch,
                     const std::vector<JobTrouble>& order, nlohmann::ordered_json& results) {
  results["shapes"] = nlohmann::ordered_json::array();
  const auto traced = std::count_if(batch.jobs.begin(), batch.jobs.end(),
                                    [](const JobOutcome& job) { return !job.trace.empty(); });
  std::unique_ptr<ReportRuns> runs;
  if (traced > 0 && options.details > 0) runs = std::make_unique<ReportRuns>(report_budget(shapes_of(batch)));
  CountBar bar(static_cast<std::size_t>(traced), "traces", "read", shown_progress(options.quiet),
               std::chrono::milliseconds(std::lround(1e3 * options.progress_s)));
  std::size_t drawn = 0;
  for (const JobTrouble& trouble : order) {
    const JobOutcome& job = batch.jobs[trouble.job];
    nlohmann::ordered_json& row = results["jobs"][trouble.job];
    std::string note = missing_run(job, drawn, options.details);
    if (!note.empty() && !job.trace.empty()) look_at_undrawn(job, row);
    if (traced > 0 && job.trace.empty() && job.done()) flag_missing(options.folder, job, row);
    if (note.empty()) {
      try {
        row["run"] = runs->run(job.trace);
        ++drawn;
        if (row["run"].contains("cut"))
          flag(row, "trace cut short", job.trace + ": " + row["run"]["cut"].get<std::string>());
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::refused) throw;
        note = fmt::format("Its trace cannot be read: {}", error.what());
        flag(row, "trace cannot be read", error.what());
      }
    }
    if (!note.empty()) row["note"] = note;
    if (!job.trace.empty()) bar.advance();
  }
  bar.finish();
  tell_damage(results["jobs"]);
  if (runs) results["shapes"] = runs->shapes();
  return drawn;
}

int report(const ReportOptions& options) {
  std::error_code none;
  if (!fs::is_directory(options.folder, none)) {
    const fs::path near = near_folder(options.folder);
    throw refused(options.folder, near.empty()
                                      ? "is no folder: name the one that `fingerpad replay --out` wrote"
                                      : fmt::format("is no folder; did you mean {}?", near.string()));
  }
  const std::string out =
      options.out.empty() ? (fs::path(options.folder) / "report.html").string() : options.out;
  refuse_unwritable(out);
  refuse_other_endings(out, "report", {".html", ".htm"});
  const ReportLibraries libraries = read_report_libraries(options.libraries);
  const BatchResults batch = read_batch_results(options.folder);
  std::vector<std::string> inputs = batch.files;
  for (const JobOutcome& job : batch.jobs) {
    if (!job.trace.empty()) inputs.push_back(job.trace);
  }
  refuse_overwriting(out, inputs);

  const std::vector<JobTrouble> order = worst_first(batch.jobs);
  nlohmann::ordered_json results = report_results(batch, order);
  const std::size_t drawn = add_runs(options, batch, order, results);
  const fs::path named = fs::path(options.folder) / "";
  const std::string title = named.parent_path().filename().string();
  results["title"] = title;
  const std::string page = report_page(title, libraries, results);
  OutputFile file(out);
  file.write(page);
  file.commit();
  tell_written(options.quiet, out,
               fmt::format("{}, {} of them drawn, {:.1f} MB", count_words(batch.jobs.size(), "job"), drawn,
                           static_cast<double>(page.size()) / 1e6));
  return 0;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      program.add_subcommand("report", "Make one HTML page of what a replay has left in a folder");
  command->add_option("DIR", options->folder, "Folder that `replay --out` wrote")->required();
  refuse_empty(command->add_option("--out", options->out, "The page; default: report.html in that folder"));
  command
      ->add_option("--details", options->details,
                   "How many of the jobs that have a trace are drawn, the worst first; all are in the tables")
      ->capture_default_str();
  command->add_option("--libraries", options->libraries, "Where the JavaScript libraries are")
      ->type_name("FOLDER")
      ->capture_default_str();
  command
      ->add_option("--progress", options->progress_s,
                   "Seconds from one line on how far it is to the next, where standard error is no terminal")
      ->check(number_in(0, 86400, "seconds"))
      ->capture_default_str();
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "The page fetches nothing: it holds tables to sort and filter, charts across the jobs, and of each job "
      "a picture, a 3-D view and strip charts. Worst are failed jobs; then forces that are not finite, "
      "pop-throughs, unsettled ticks, energy made (where it is over a hundredth of greatest force times "
      "depth), and last the greatest normal force. Needs the Debian packages libjs-jquery, "
      "libjs-jquery-datatables, libjs-dygraphs and libjs-three.");
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace fingerpad
