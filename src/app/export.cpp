#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "app/told_trace.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "trace/export.hpp"
#include "trace/trace_column.hpp"
#ifdef FINGERPAD_VIEW
#include "view/export_blocks.hpp"
#endif

namespace fingerpad {
namespace {

struct ExportOptions {
  std::string trace, out;
  bool with_parts = false;
  bool quiet = false;
};

/// The path as a block of a file that holds the parts too.
int export_with_parts(const ExportOptions& options) {
  if (!options.out.ends_with(".vtm"))
    throw Error(ErrorKind::usage, options.out, "with its parts a trace is written as .vtm: name it so");
#ifdef FINGERPAD_VIEW
  refuse_overwriting(options.out, {options.trace});
  refuse_unwritable(options.out);
  const Trace trace = read_told_trace(options.trace, TraceContents::all);
  for (const std::string& words : export_blocks(trace, options.trace, options.out)) {
    print_err("fingerpad: warning: {}\n", words);
  }
  tell_written(options.quiet, options.out,
               count_words(trace.rows.size(), "tick") + " with their parts, for ParaView");
  return 0;
#else
  throw Error(ErrorKind::usage, options.out, "this program was built without VTK, which writes .vtm files");
#endif
}

int export_trace(const ExportOptions& options) {
  if (options.with_parts || options.out.ends_with(".vtm")) return export_with_parts(options);
  if (options.out != "-") refuse_other_endings(options.out, "export", {".csv", ".vtp", ".vtm"});
  const bool csv = !options.out.ends_with(".vtp");
  refuse_overwriting(options.out, {options.trace});
  refuse_unwritable(options.out);
  const Trace trace = read_told_trace(options.trace, csv ? TraceContents::some_rows : TraceContents::all);
  csv ? export_csv(trace, options.out) : export_vtp(trace, options.out);
  tell_written(options.quiet, options.out,
               count_words(trace.rows.size(), "tick") + (csv ? " as CSV" : " as VTP, for ParaView"));
  return 0;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      program.add_subcommand("export", "Write a trace as CSV, or for ParaView, with the parts if wished");
  command
      ->add_option("TRACE", options->trace,
                   "Trace (HDF5, or CSV up to 2 GiB); - is a CSV trace on standard input")
      ->required();
  refuse_empty(command->add_option("--out", options->out,
                                   "File to write, .csv, .vtp or .vtm; - is CSV to standard output"))
      ->required();
  command->add_flag("--with-parts", options->with_parts,
                    "The parts beside the path and the contact points, as a .vtm of named blocks");
  add_quiet_flag(*command, options->quiet);
  command->footer(
      "A CSV export is byte for byte what `replay --format csv` writes.\n\nColumns of a trace:\n" +
      trace_columns_text());
  command->callback([options, &action] { action = [options] { return export_trace(*options); }; });
}

}  // namespace fingerpad
