#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "replay/folder_comparison.hpp"

namespace fingerpad {
namespace {

struct CompareOptions {
  std::string folder_a, folder_b;
  double tolerance = 0;
  bool quiet = false;
};

int compare(const CompareOptions& options) {
  constexpr int changed_code = 4;
  const FolderComparison found = compare_folders(options.folder_a, options.folder_b, options.tolerance);
  for (const std::string& change : found.changes) print_out("{}\n", change);
  if (!options.quiet) {
    const bool traces = found.traces > 0;
    const std::size_t count = traces ? found.traces : found.jobs;
    print_out("{} of {} {}{} changed from {} to {}\n", found.changed, count, traces ? "trace" : "job",
              count == 1 ? "" : "s", options.folder_a, options.folder_b);
  }
  return found.changes.empty() ? 0 : changed_code;
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
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A line for each trace and column that differs, with the greatest difference and its time. Where "
      "neither "
      "folder holds a trace, a line for each job and figure of summary.csv. Ends 0 where all are alike, 4 "
      "where "
      "something changed.");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace fingerpad
