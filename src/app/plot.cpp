#include "view/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>

#include "app/columns_option.hpp"
#include "app/commands.hpp"
#include "app/number_option.hpp"
#include "app/output_name.hpp"
#include "app/pad_charts.hpp"
#include "app/standard_streams.hpp"
#include "app/told_trace.hpp"
#include "app/word_option.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/nearest_word.hpp"
#include "base/number_text.hpp"
#include "base/output_place.hpp"
#include "base/printable_text.hpp"
#include "trace/trace.hpp"
#include "view/clock_doubts.hpp"
#include "view/measured_run.hpp"

namespace fingerpad {
namespace {

struct PlotOptions {
  std::vector<std::string> inputs, columns;
  std::string out, show = "history", over = "t";
  bool quiet = false;
  int width = plot_page_width;
  double from_s = -std::numeric_limits<double>::infinity(), to_s = std::numeric_limits<double>::infinity();
};

Over over_of(const std::string& name) {
  return name == "s" ? Over::travel : name == "angle" ? Over::turn : Over::time;
}

/// What --over takes; of another word what may be meant by it: t, s and angle are too short to be near one.
std::string over_fault(const std::string& word) {
  struct Meant {
    std::string_view said, name;
  };
  constexpr Meant meant[] = {{"time", "t"},     {"t_s", "t"},
                             {"seconds", "t"},  {"travel", "s"},
                             {"way", "s"},      {"path", "s"},
                             {"distance", "s"}, {"position", "s"},
                             {"u", "s"},        {"x", "s"},
                             {"y", "s"},        {"z", "s"},
                             {"turn", "angle"}, {"angle_deg", "angle"},
                             {"deg", "angle"},  {"a", "angle"}};
  if (word == "t" || word == "s" || word == "angle") return {};
  std::string_view name;
  std::vector<std::string> said;
  for (const Meant& one : meant) said.emplace_back(one.said);
  const std::string near = std::ranges::find(said, word) != said.end() ? word
                           : word.size() > 2                           ? nearest_word(word, said)
                                                                       : "";
  for (const Meant& one : meant)
    if (one.said == near) name = one.name;
  if (name.empty() && word.size() > 2 && nearest_word(word, {"angle"}) == "angle") name = "angle";
  return fmt::format("'{}' is none of t (time), s (travel along the surface), angle (its turn){}",
                     printable(word, 60), name.empty() ? "" : fmt::format("; did you mean '{}'?", name));
}

/// What is earlier than --from and later than --to. Throws Error (refused) where that is all.
void leave_out(std::vector<TickRecord>& rows, const PlotOptions& options) {
  if (rows.empty()) return;
  const double begin_s = rows.front().t_s, end_s = rows.back().t_s;
  if (options.from_s > end_s || options.to_s < begin_s)
    throw Error(ErrorKind::refused, options.from_s > end_s ? "--from" : "--to",
                fmt::format("{} s leaves nothing of {}, which goes from {} to {} s",
                            options.from_s > end_s ? options.from_s : options.to_s, options.inputs[0],
                            rounded_text(begin_s, 6), rounded_text(end_s, 6)));
  std::erase_if(rows,
                [&](const TickRecord& row) { return row.t_s < options.from_s || row.t_s > options.to_s; });
}

/// One trace, by itself.
void plot_alone(const PlotOptions& options) {
  const std::string& path = options.inputs[0];
  ViewInput input = view_of_trace(read_told_trace(path, TraceContents::all), path);
  leave_out(input.rows, options);
  if (options.show == "stick-region") {
    write_chart(stick_region_chart(input), options.out);
  } else if (options.show == "force-displacement") {
    write_chart(force_displacement_chart(input), options.out);
  } else {
    const PlotSubject subject = options.show == "spectrum" ? PlotSubject::spectrum : PlotSubject::history;
    write_plot(input, options.out, options.width, subject, over_of(options.over));
  }
  tell_written(options.quiet, options.out,
               fmt::format("{} of {}", options.show, count_words(input.rows.size(), "tick")));
}

/// Runs over one another, and what each has beyond the first.
void plot_runs(const PlotOptions& options, std::vector<ComparedRun> runs) {
  for (const ComparedRun& run : runs) tell_early_end(run.path, run.ends_early);
  for (const std::string& words : clock_doubts(runs)) print_err("fingerpad: warning: {}\n", words);
  const Over over = over_of(options.over);
  const Comparison comparison = compare_runs(std::move(runs), options.columns, over);
  write_comparison(comparison, over, options.out, options.width);
  if (!options.quiet) {
    for (const std::string& words : comparison.notes) print_out("{}\n", words);
    for (const std::string& words : residual_words(comparison)) print_out("{}\n", words);
  }
  const std::string what = comparison.runs.size() > 1
                               ? fmt::format("{} overlaid", comparison.runs.size())
                               : fmt::format("{} of {}", fmt::join(comparison.columns, ", "),
                                             count_words(comparison.runs[0].x.size(), "row"));
  tell_written(options.quiet, options.out, what);
}

/// Several, or measurements.
void plot_overlaid(const PlotOptions& options) {
  if (options.show != "history" && options.inputs.size() == 1 && options.columns.empty())
    throw refused(
        options.inputs[0],
        fmt::format("holds some of a trace's columns alone, measured or written by replay --columns, and "
                    "--show {} needs a whole trace",
                    options.show));
  constexpr std::size_t most = 8;  // colours that are told apart
  if (options.inputs.size() > most)
    throw Error(ErrorKind::usage, "plot", fmt::format("overlays at most {} at once", most));
  if (options.show != "history")
    throw Error(
        ErrorKind::usage, "--show " + options.show,
        options.inputs.size() > 1 ? "shows one trace; name only one" : "has no --columns: leave them out");
  const Over over = over_of(options.over);
  plot_runs(options, read_compared_runs(options.inputs, over, options.from_s, options.to_s));
}

/// Whether a trace was written with some of its columns alone.
bool lacks_columns(const std::string& path) {
  return is_hdf5(path) && !read_trace(path, TraceContents::some_rows).missing.empty();
}

/// One trace: whole as the paper lays it out, of some columns these. Which it is, is asked where the whole
/// was refused, or all traces would be read twice.
void plot_one(const PlotOptions& options) {
  try {
    plot_alone(options);
  } catch (const Error& error) {
    const bool is_history = options.show == "history";
    if (error.kind() != ErrorKind::refused || !is_history || !lacks_columns(options.inputs[0])) throw;
    plot_overlaid(options);
  }
}

int plot(const PlotOptions& options) {
  if (options.from_s > options.to_s)
    throw Error(ErrorKind::usage, "--from",
                fmt::format("{} s is later than --to, {} s", options.from_s, options.to_s));
  refuse_columns_as_inputs(options.inputs, fmt::format("{}", fmt::join(options.columns, ",")));
  refuse_other_endings(options.out, "plot", {".png", ".svg"});
  refuse_overwriting(options.out, options.inputs);
  refuse_unwritable(options.out);
  const bool table = options.inputs.size() == 1 && is_measured_table(options.inputs[0]);
  if (options.show == "residual" && options.inputs.size() == 1) {
    plot_runs(options, read_measured_and_model(options.inputs[0], over_of(options.over), options.from_s,
                                               options.to_s));
  } else if (options.inputs.size() > 1 || !options.columns.empty() || table) {
    plot_overlaid(options);
  } else {
    plot_one(options);
  }
  return 0;
}

}  // namespace

void add_plot(CLI::App& program, Action& action) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command =
      program.add_subcommand("plot", "Plot a trace as the paper lays out its figures, or several overlaid");
  command
      ->add_option("TRACE", options->inputs,
                   "Trace (HDF5, or CSV up to 2 GiB); - is a CSV trace on standard input. Several are "
                   "overlaid and compared with the first; then a table with t_s and columns named as a "
                   "trace's (fx_n, fn_n) will do too")
      ->required();
  refuse_empty(command->add_option("--out", options->out, "Picture to write, .png or .svg"))->required();
  add_quiet_flag(*command, options->quiet);
  command
      ->add_option(
          "--show", options->show,
          "history, stick-region, force-displacement or spectrum (the paper's figs. 2, 9 and 12; 4 and "
          "7; 8; 11); residual, of a motion with a measured force")
      ->check(one_of({"history", "stick-region", "force-displacement", "spectrum", "residual"}))
      ->capture_default_str();
  command
      ->add_option("--over", options->over,
                   "What a history is drawn over: t, time; s, how far the finger has gone along the surface; "
                   "angle, by how much the surface has turned under it, summed up")
      ->check(
          CLI::Validator(over_fault, CLI::detail::generate_set(std::vector<std::string>{"t", "s", "angle"})))
      ->capture_default_str();
  command
      ->add_option(
          "--columns", options->columns,
          "What is overlaid: a trace's columns, or friction, which is along the line that all rub straight "
          "along, or else along each one's sliding and negative where it holds the finger back; parted by "
          "commas")
      ->delimiter(',')
      ->default_str("fn_n,friction,mu, or the forces and mu that all have");
  command->add_option("--from", options->from_s, "Leave out what is earlier [s]")->default_str("start");
  command->add_option("--to", options->to_s, "Leave out what is later [s]")->default_str("end");
  command
      ->add_option("--width", options->width,
                   "Width of a history, spectrum or overlay in pixels; 10000 take a gigabyte of memory")
      ->check(whole_number_in(300, 10000))
      ->capture_default_str();
  command->footer(
      "history: position, speed, forces, coefficient of friction and phase against time, and the spectra of "
      "the forces.\n"
      "Stick is dotted, the stick centre dashed; rings mark where slip ends.\n"
      "stick-region: where the pad stuck about its stick centre, by the finger's angle, with the law's "
      "region.\n"
      "force-displacement: friction against displacement in stick.  spectrum: of the forces, alone.\n"
      "residual: measured and model's force on the finger over one another, and the model's less the "
      "measured.\n"
      "Overlaid: a panel a column and one of what each has beyond the first, with its RMS, at the ticks of "
      "the "
      "one that has fewer; the finer is interpolated linearly.\n"
      "Needs no screen: a virtual one is started where there is none.");
  command->callback([options, &action] { action = [options] { return plot(*options); }; });
}

}  // namespace fingerpad
