#include "view/plot.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/pad_charts.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

struct PlotOptions {
  std::string trace, out, show = "history";
  bool quiet = false;
  int width = plot_page_width;
  double from_s = -std::numeric_limits<double>::infinity(), to_s = std::numeric_limits<double>::infinity();
};

int plot(const PlotOptions& options) {
  refuse_other_endings(options.out, "plot", {".png", ".svg"});
  refuse_overwriting(options.out, {options.trace});
  refuse_unwritable(options.out);
  ViewInput input = view_of_trace(read_trace(options.trace), options.trace);
  std::erase_if(input.rows,
                [&](const TickRecord& row) { return row.t_s < options.from_s || row.t_s > options.to_s; });
  if (options.show == "stick-region") {
    write_chart(stick_region_chart(input), options.out);
  } else if (options.show == "force-displacement") {
    write_chart(force_displacement_chart(input), options.out);
  } else {
    const PlotSubject subject = options.show == "spectrum" ? PlotSubject::spectrum : PlotSubject::history;
    write_plot(input, options.out, options.width, subject);
  }
  tell_written(options.quiet, options.out, fmt::format("{} of {} ticks", options.show, input.rows.size()));
  return 0;
}

}  // namespace

void add_plot(CLI::App& program, Action& action) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program.add_subcommand("plot", "Plot a trace as the paper lays out its figures");
  command
      ->add_option("TRACE", options->trace,
                   "Trace (HDF5, or CSV up to 2 GiB); - is a CSV trace on standard input")
      ->required();
  refuse_empty(command->add_option("--out", options->out, "Picture to write, .png or .svg"))->required();
  add_quiet_flag(*command, options->quiet);
  command
      ->add_option(
          "--show", options->show,
          "history, stick-region, force-displacement or spectrum (the paper's figs. 2, 9 and 12; 4 and "
          "7; 8; 11)")
      ->check(CLI::IsMember({"history", "stick-region", "force-displacement", "spectrum"}))
      ->capture_default_str();
  command->add_option("--from", options->from_s, "Leave out what is earlier [s]")->default_str("start");
  command->add_option("--to", options->to_s, "Leave out what is later [s]")->default_str("end");
  command
      ->add_option("--width", options->width,
                   "Width of a history or spectrum in pixels; 10000 take a gigabyte of memory")
      ->check(CLI::Range(300, 10000))
      ->capture_default_str();
  command->footer(
      "history: position, speed, forces, coefficient of friction and phase against time, and the spectra of "
      "the forces.\n"
      "Stick is dotted, the stick centre dashed; rings mark where slip ends.\n"
      "stick-region: where the pad stuck about its stick centre, by the finger's angle, with the law's "
      "region.\n"
      "force-displacement: friction against displacement in stick.  spectrum: of the forces, alone.\n"
      "Needs no screen: a virtual one is started where there is none.");
  command->callback([options, &action] { action = [options] { return plot(*options); }; });
}

}  // namespace fingerpad
