#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "trace/export.hpp"

namespace fingerpad {
namespace {

struct ExportOptions {
  std::string trace, out;
};

int export_trace(const ExportOptions& options) {
  const bool csv = options.out.ends_with(".csv") || options.out == "-";
  if (!csv && !options.out.ends_with(".vtp")) {
    throw Error(ErrorKind::usage, options.out,
                "export writes .csv or .vtp files, or CSV to - (standard output)");
  }
  refuse_overwriting(options.out, {options.trace});
  refuse_unwritable(options.out);
  const Trace trace = read_trace(options.trace);
  csv ? export_csv(trace, options.out) : export_vtp(trace, options.out);
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
  command->add_option("--out", options->out, "File to write, .csv or .vtp; - is CSV to standard output")
      ->required();
  command->footer(
      "A CSV export is byte for byte what `replay --format csv` writes.\n\nColumns of a trace:\n" +
      trace_columns_text());
  command->callback([options, &action] { action = [options] { return export_trace(*options); }; });
}

}  // namespace fingerpad
