#include "view/picture.hpp"

#include <vtkRenderWindow.h>

#include <algorithm>

#include "base/error.hpp"
#include "view/png_vtk.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad {
namespace {

/// Four samples a pixel with their depths, for two layers, and their copies, were measured to take 87 bytes a
/// pixel: a gigabyte at this size, which holds a 4K screen.
constexpr long most_pixels = 10'000'000;

/// Renders the picture and hands it over while its screen still stands.
template <typename Use>
void with_rendered_view(const ViewInput& input, int width, int height, std::optional<double> at_s,
                        const ViewState& state, Use use) {
  refuse_picture_size(width, height);
  const auto screen = screen_to_draw_on();
  const bool moving = input.rows.size() > 1;
  Stage stage(input, width, height, moving, moving);
  stage.window()->SetOffScreenRendering(1);
  stage.state() = state;
  if (!input.rows.empty()) {
    const auto row = static_cast<std::size_t>(at_s ? row_at(input, *at_s) : telling_row(input));
    stage.show(input.rows[row],
               row > 0 ? shown_speed(input.rows[row - 1], input.rows[row]) : TickRecord::nan);
  }
  stage.reset_camera();
  if (moving) stage.show_chart(touch_chart(input.rows, main_direction(input.rows), touch_levels(input)));
  stage.render();
  use(stage);
}

}  // namespace

void refuse_picture_size(int width, int height) {
  if (std::min(width, height) >= 200 && std::max(width, height) <= 8192 &&
      static_cast<long>(width) * height <= most_pixels) {
    return;
  }
  throw Error(ErrorKind::usage, "--size",
              "a picture is 200 to 8192 pixels wide and high and has at most 10 million pixels (they take a "
              "gigabyte of memory)");
}

long row_at(const ViewInput& input, double t_s) {
  const auto after = std::upper_bound(input.rows.begin(), input.rows.end(), t_s,
                                      [](double t, const TickRecord& row) { return t < row.t_s; });
  if (input.rows.empty()) return -1;
  return std::max<long>(0, after - input.rows.begin() - 1);
}

long telling_row(const ViewInput& input) {
  long best = -1;
  double most_n = 0;
  const auto count = static_cast<long>(input.rows.size());
  for (long i = 0; i < count; ++i) {
    const TickRecord& row = input.rows[static_cast<std::size_t>(i)];
    if (row.phase == Phase::free) continue;
    // A stick under load shows the region, its centre and every force; of these the most strained.
    const double score = row.friction_W_n.norm() + (row.phase == Phase::stick ? 1e6 : 0);
    if (score <= most_n) continue;
    most_n = score;
    best = i;
  }
  return best >= 0 ? best : count - 1;
}

void write_view_png(const ViewInput& input, const std::string& path, int width, int height,
                    std::optional<double> at_s, const ViewState& state) {
  with_rendered_view(input, width, height, at_s, state,
                     [&](Stage& stage) { write_png(stage.window(), path); });
}

Pixels view_pixels(const ViewInput& input, int width, int height, std::optional<double> at_s,
                   const ViewState& state) {
  Pixels pixels;
  with_rendered_view(input, width, height, at_s, state,
                     [&](Stage& stage) { pixels = pixels_of(stage.window()); });
  return pixels;
}

}  // namespace fingerpad
