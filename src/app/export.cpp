#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "trace/export.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

struct ExportOptions {
  std::string trace, out;
  bool quiet = false;
};

int export_trace(const ExportOptions& options) {
  if (options.out != "-") refuse_other_endings(options.out, "export", {".csv", ".vtp"});
  const bool csv = !options.out.ends_with(".vtp");
  refuse_overwriting(options.out, {options.trace});
  refuse_unwritable(options.out);
  const Trace trace = read_trace(options.trace);
  csv ? export_csv(trace, options.out) : export_vtp(trace, options.out);
  tell_written(options.quiet, options.out,
               fmt::format("{} ticks as {}", trace.rows.size(), csv ? "CSV" : "VTP, for ParaView"));
  return 0;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write a trace as CSV, or as VTP for ParaView");
  command
      ->add_option("TRACE", options->trace,
                   "Trace (HDF5, or CSV up to 2 GiB); - is a CSV trace on standard input")
      ->required();
  refuse_empty(
      command->add_option("--out", options->out, "File to write, .csv or .vtp; - is CSV to standard output"))
      ->required();
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A CSV export is byte for byte what `replay --format csv` writes.\n\nColumns of a trace:\n" +
      trace_columns_text());
  command->callback([options, &action] { action = [options] { return export_trace(*options); }; });
}

}  // namespace fingerpad
