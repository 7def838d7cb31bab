#include "view/window.hpp"

#include <memory>

#include "view/playback.hpp"
#include "view/screen.hpp"
#include "view/touch_chart.hpp"
#include "view/window_loop_vtk.hpp"

namespace fingerpad {
namespace {

/// A window with its player; without rows there is nothing to play.
class ViewWindow {
 public:
  ViewWindow(const ViewInput& input, const WindowOptions& options)
      : input_(input),
        stage_(input, options.width, options.height, input.rows.size() > 1, input.rows.size() > 1),
        loop_(stage_, options, handlers()) {
    if (!input.rows.empty()) playback_.emplace(input);
    stage_.state().look = options.look;
    stage_.reset_camera();
    if (input.rows.size() > 1) {
      stage_.show_chart(touch_chart(input.rows, main_direction(input.rows), touch_levels(input)));
    }
    stage_.words().hint = playback_ ? "space plays   h help" : "h help";
    stage_.words().help = help_lines(window_kind());
    show_moment();
  }

  void run() { loop_.run(); }

 private:
  WindowHandlers handlers() {
    WindowHandlers handlers;
    handlers.window = window_kind();
    handlers.act = [this](KeyAction action) { return playback_ && player_key(action); };
    handlers.press = [this](int x, int y) {
      const auto t_s = stage_.time_at(x, y);
      dragging_ = playback_ && t_s.has_value();
      if (dragging_) go_to(*t_s);
      return dragging_;
    };
    handlers.move = [this](int x, int y) {
      if (!dragging_) return false;
      if (const auto t_s = stage_.time_at(x, y)) go_to(*t_s);
      return true;
    };
    handlers.release = [this] { return std::exchange(dragging_, false); };
    handlers.frame = [this](double elapsed_s) {
      const bool moved = playback_ && playback_->advance(elapsed_s);
      if (moved) show_moment();
      return moved;
    };
    handlers.report = [this](WindowReport& report) {
      if (playback_) report.t_s = playback_->t_s();
    };
    return handlers;
  }

  unsigned window_kind() const { return input_.rows.empty() ? windows::still : windows::trace; }

  bool player_key(KeyAction action) {
    const auto twentieth = static_cast<long>(input_.rows.size() / 20 + 1);
    switch (action) {
      case KeyAction::play:
        playback_->toggle();
        break;
      case KeyAction::tick_back:
      case KeyAction::tick_on:
        playback_->step(action == KeyAction::tick_on ? 1 : -1);
        break;
      case KeyAction::leap_back:
      case KeyAction::leap_on:
        playback_->step(action == KeyAction::leap_on ? twentieth : -twentieth);
        break;
      case KeyAction::to_first:
        playback_->go_to(input_.rows.front().t_s);
        break;
      case KeyAction::to_last:
        playback_->go_to(input_.rows.back().t_s);
        break;
      case KeyAction::faster:
      case KeyAction::slower:
        playback_->change_speed(action == KeyAction::faster);
        break;
      default:
        return false;
    }
    show_moment();
    return true;
  }

  void go_to(double t_s) {
    playback_->go_to(t_s);
    show_moment();
  }

  void show_moment() {
    if (!playback_) return;
    const auto row = static_cast<std::size_t>(playback_->row());
    stage_.state().playing = playback_->playing();
    stage_.state().speed = playback_->speed();
    stage_.show(input_.rows[row],
                row > 0 ? shown_speed(input_.rows[row - 1], input_.rows[row]) : TickRecord::nan);
  }

  const ViewInput& input_;
  std::optional<Playback> playback_;
  bool dragging_ = false;
  Stage stage_;
  WindowLoop loop_;
};

}  // namespace

void run_view_window(const ViewInput& input, const WindowOptions& options) {
  need_display(picture_instead);
  ViewWindow(input, options).run();
}

}  // namespace fingerpad
