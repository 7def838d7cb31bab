#include "view/movie.hpp"

#include <fmt/format.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "view/movie_encoder.hpp"
#include "view/picture.hpp"
#include "view/png_vtk.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad {

void refuse_movie_choice(const MovieChoice& choice) {
  refuse_picture_size(choice.width, choice.height);
  if (choice.width % 2 != 0 || choice.height % 2 != 0)
    throw Error(ErrorKind::usage, "--size",
                "a movie's width and height are even: its colours are in squares of four");
  if (!(choice.frames_per_s >= 1 && choice.frames_per_s <= 240))
    throw Error(ErrorKind::usage, "--fps", "a movie has 1 to 240 frames a second");
  if (!(choice.speed >= 1e-6 && choice.speed <= 1e6))
    throw Error(ErrorKind::usage, "--speed",
                "is 1e-6 to 1e6; 1 is as fast as it was, 0.25 four times slower");
}

long movie_frames(const ViewInput& input, const MovieChoice& choice) {
  if (input.rows.empty()) return 0;
  constexpr double most = 432'000;  // two hours of 60 a second
  const double duration_s = input.rows.back().t_s - input.rows.front().t_s;
  // A last frame is not lost to rounding.
  const double frames = std::floor(duration_s * choice.frames_per_s / choice.speed + 1e-6) + 1;
  if (frames <= most) return static_cast<long>(frames);
  throw Error(ErrorKind::usage, "--movie",
              fmt::format("{} s would be {} frames, and at most {:.0f} are made: give a higher --speed",
                          rounded_text(duration_s, 6), rounded_text(frames, 6), most));
}

std::size_t movie_row(const ViewInput& input, const MovieChoice& choice, long k) {
  const double t_s = input.rows.front().t_s + static_cast<double>(k) * choice.speed / choice.frames_per_s;
  const auto before = static_cast<std::size_t>(row_at(input, t_s));
  const std::size_t after = std::min(before + 1, input.rows.size() - 1);
  return t_s - input.rows[before].t_s <= input.rows[after].t_s - t_s ? before : after;
}

void write_view_movie(const ViewInput& input, const std::string& path, const MovieChoice& choice,
                      const ViewState& state, const std::function<void(long done)>& progress) {
  refuse_movie_choice(choice);
  const long frames = movie_frames(input, choice);
  const auto screen = screen_to_draw_on();
  Stage stage(input, choice.width, choice.height, true, true);
  stage.window()->SetOffScreenRendering(1);
  stage.state() = state;
  stage.reset_camera();
  stage.show_chart(touch_chart(input.rows, main_direction(input.rows), touch_levels(input)));
  // The arrows' scale is that of the greatest force, which the stage knows: it does not change on the way.
  MovieEncoder encoder(path, choice.width, choice.height, choice.frames_per_s);
  for (long k = 0; k < frames; ++k) {
    const std::size_t row = movie_row(input, choice, k);
    stage.show(input.rows[row],
               row > 0 ? shown_speed(input.rows[row - 1], input.rows[row]) : TickRecord::nan);
    stage.render();
    encoder.add(pixels_of(stage.window()));
    progress(k + 1);
  }
  encoder.finish();
}

}  // namespace fingerpad
