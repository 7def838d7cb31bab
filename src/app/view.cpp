#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/progress_bar.hpp"
#include "app/shown_subject.hpp"
#include "app/size_option.hpp"
#include "app/standard_streams.hpp"
#include "app/subject.hpp"
#include "app/unit_option.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/number_text.hpp"
#include "base/output_place.hpp"
#include "view/camera_look.hpp"
#include "view/movie.hpp"
#include "view/movie_encoder.hpp"
#include "view/picture.hpp"
#include "view/screen.hpp"
#include "view/window.hpp"

namespace fingerpad {
namespace {

struct ViewOptions {
  std::string subject, png, movie;
  std::string unit = "mm";
  std::string size = "1280x800";
  std::string camera;
  std::optional<double> at_s;
  double frames_per_s = 30, speed = 1;
  bool quiet = false;

  /// Empty where a window is to be opened.
  const std::string& output() const { return png.empty() ? movie : png; }
};

/// The moment of the picture, told where it is not the one that was asked for.
double shown_moment(const ViewInput& input, std::optional<double> at_s) {
  const TickRecord& row =
      input.rows[static_cast<std::size_t>(at_s ? row_at(input, *at_s) : telling_row(input))];
  const double begin_s = input.rows.front().t_s, end_s = input.rows.back().t_s;
  if (!at_s || (*at_s >= begin_s && *at_s <= end_s)) return row.t_s;
  const std::string times = fmt::format("{} to {} s", begin_s, end_s);
  if (*at_s < 0) throw Error(ErrorKind::usage, "--at", fmt::format("{} s is no moment of {}", *at_s, times));
  print_err("fingerpad: warning: --at: {} s is outside of {}: {} s is shown\n", *at_s, times, row.t_s);
  return row.t_s;
}

ViewState asked_state(const ViewOptions& options) {
  ViewState state;
  if (!options.camera.empty()) state.look = read_look(options.camera);
  return state;
}

void write_picture(const ViewOptions& options, const ViewInput& input, const PictureSize& size) {
  std::string what = fmt::format("{} x {} pixels", size.width, size.height);
  if (!input.rows.empty()) what += fmt::format(", at {} s", shown_moment(input, options.at_s));
  write_view_png(input, options.png, size.width, size.height, options.at_s, asked_state(options));
  tell_written(options.quiet, options.png, what);
}

/// A window, and in its place another one for each file that is dropped onto it and can be shown.
void show_windows(ViewInput input, double metres_per_unit, WindowOptions window) {
  std::optional<ViewInput> dropped;
  window.on_drop = [&](const std::string& path) -> std::string {
    try {
      LoadBar bar(stderr_is_terminal());
      dropped = load_subject(path, metres_per_unit, bar);
      bar.finish();
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  for (;;) {
    run_view_window(input, window);
    if (!dropped) return;
    input = *std::exchange(dropped, std::nullopt);
  }
}

void write_movie(const ViewOptions& options, const ViewInput& input, const MovieChoice& choice) {
  if (input.rows.size() < 2)
    throw Error(ErrorKind::usage, "--movie",
                "nothing moves in " + input.title + ": --png makes a picture of it");
  const long frames = movie_frames(input, choice);
  ProgressBar bar(stderr_is_terminal(), std::chrono::milliseconds(500), ProgressBar::End::wiped);
  write_view_movie(input, options.movie, choice, asked_state(options), [&](long done) {
    bar.show(static_cast<double>(done) / static_cast<double>(frames),
             fmt::format("frame {} of {}", done, frames));
  });
  bar.finish();
  tell_written(options.quiet, options.movie,
               fmt::format("{} frames of {} x {} pixels, {} s", frames, choice.width, choice.height,
                           rounded_text(static_cast<double>(frames) / choice.frames_per_s, 4)));
}

/// Before a long import.
void refuse_output(const ViewOptions& options, const MovieChoice& choice) {
  if (!options.png.empty() && !options.movie.empty())
    throw Error(ErrorKind::usage, "--movie", "and --png are two calls: one file is written at a time");
  const bool movie = !options.movie.empty();
  if (options.output() == "-") {
    throw Error(
        ErrorKind::usage, movie ? "--movie" : "--png",
        movie ? "a movie needs a file, not standard output" : "a picture needs a file, not standard output");
  }
  refuse_unwritable(options.output());
  refuse_overwriting(options.output(), subject_files(options.subject));
  if (!movie) {
    refuse_other_endings(options.png, "view --png", {".png"});
    return;
  }
  refuse_other_endings(options.movie, "view --movie", {MovieEncoder::endings[0], MovieEncoder::endings[1]});
  refuse_movie_choice(choice);
  need_movie_encoder();
}

int view(const ViewOptions& options) {
  const PictureSize size = read_size(options.size);
  if (options.at_s && !std::isfinite(*options.at_s))
    throw Error(ErrorKind::usage, "--at", "is no moment in seconds");
  if (!options.camera.empty()) read_look(options.camera);  // before a long import
  const MovieChoice movie{size.width, size.height, options.frames_per_s, options.speed};
  if (options.output().empty()) {
    refuse_unfit_subject(options.subject);
    need_display(picture_instead);
  } else {
    refuse_output(options, movie);
  }
  LoadBar bar(stderr_is_terminal());
  ViewInput input = load_subject(options.subject, metres_of(options.unit), bar);
  bar.finish();
  if (!options.movie.empty()) {
    write_movie(options, input, movie);
    return 0;
  }
  if (!options.png.empty()) {
    write_picture(options, input, size);
    return 0;
  }
  WindowOptions window;
  window.width = size.width;
  window.height = size.height;
  if (!options.camera.empty()) window.look = read_look(options.camera);
  show_windows(std::move(input), metres_of(options.unit), window);
  return 0;
}

}  // namespace

void add_view(CLI::App& program, Action& action) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
      program.add_subcommand("view", "Show a scene, a mesh or a trace in a window or as a picture");
  command
      ->add_option("SUBJECT", options->subject,
                   "Scene (TOML; replayed first), mesh, or trace (HDF5 or CSV); - is a scene on standard "
                   "input, whose paths start in the current folder")
      ->required();
  refuse_empty(command->add_option("--png", options->png, "Write a picture instead; needs no screen"));
  add_size_option(*command, options->size, "the window or picture");
  command->add_option("--at", options->at_s,
                      "The moment of the picture [s]; default: the one with the greatest friction");
  refuse_empty(
      command->add_option("--camera", options->camera,
                          "From where: front, back, left, right, top, bottom, isometric, or "
                          "AZIMUTH,ELEVATION in degrees (0,0 is the front, 90,0 the right); all is in "
                          "sight, a third number zooms"),
      "NAME|AZ,EL[,ZOOM]");
  CLI::Option* const movie = command->add_option(
      "--movie", options->movie, "Write a movie (.mp4, .ogv) of a trace instead; needs ffmpeg, no screen");
  refuse_empty(movie);
  command->add_option("--fps", options->frames_per_s, "Frames a second of the movie")
      ->needs(movie)
      ->capture_default_str();
  command->add_option("--speed", options->speed, "Of the movie: 1 as it was, 0.25 four times slower")
      ->needs(movie)
      ->capture_default_str();
  add_unit_option(*command, options->unit);
  add_quiet_flag(*command, options->quiet);
  command->footer("In the window, h shows all keys. --unit is for a mesh; scenes and traces know theirs.");
  command->callback([options, &action] { action = [options] { return view(*options); }; });
}

}  // namespace fingerpad
