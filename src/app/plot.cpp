#include "view/plot.hpp"

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "base/error.hpp"

namespace fingerpad {
namespace {

struct PlotOptions {
  std::string trace, out;
  int width = plot_page_width;
};

int plot(const PlotOptions& options) {
  if (!options.out.ends_with(".png") && !options.out.ends_with(".svg")) {
    throw Error(ErrorKind::usage, options.out, "plot writes .png or .svg files");
  }
  write_plot(view_of_trace(read_trace(options.trace), options.trace), options.out, options.width);
  return 0;
}

}  // namespace

void add_plot(CLI::App& program, Action& action) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program.add_subcommand("plot", "Plot a trace as the paper lays out its figures");
  command->add_option("TRACE", options->trace, "Trace (HDF5 or CSV)")->required();
  command->add_option("--out", options->out, "Picture to write, .png or .svg")->required();
  command->add_option("--width", options->width, "Width of the page in pixels; it is 1.2 times as high")
      ->check(CLI::Range(300, 10000))
      ->capture_default_str();
  command->footer(
      "Position, speed, forces, coefficient of friction and phase against time, and the spectra of the "
      "forces.\n"
      "Stick is dotted, the stick centre dashed. Needs no screen: a virtual one is started where there is "
      "none.");
  command->callback([options, &action] { action = [options] { return plot(*options); }; });
}

}  // namespace fingerpad
