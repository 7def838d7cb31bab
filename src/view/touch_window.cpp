#include "view/touch_window.hpp"

#include <fmt/format.h>

#include "touch/resting_finger.hpp"
#include "view/drawing_threads.hpp"
#include "view/material_panel.hpp"
#include "view/pointer_touch.hpp"
#include "view/recent_ticks.hpp"
#include "view/screen.hpp"
#include "view/tick_readings.hpp"
#include "view/touch_chart.hpp"
#include "view/window_loop_vtk.hpp"

namespace fingerpad {
namespace {

constexpr double chart_s = 4;  // what the strip charts hold
constexpr const char* material_panel = "material";
constexpr const char* invitation = "hold the left button, or space, to press";

class TouchWindow {
 public:
  TouchWindow(const TouchWindowInput& input, const WindowOptions& options)
      : input_(input),
        history_(chart_s),
        stage_(input.view, options.width, options.height, true, false),
        pointer_(input, first_target(),
                 [this](const Vec3& from_mm, const Vec3& to_mm) {
                   return stage_.world().first_hit(from_mm, to_mm);
                 }),
        levels_(touch_levels(input.view)),
        loop_(stage_, options, handlers()) {
    if (input.swap != nullptr) material_.emplace(*input.swap, *input.view.world);
    stage_.show_hint("", help_lines(touch_window_kind(input_)));
    invite();
    stage_.keep_clear_of_readings();
    pointer_.show(stage_.pointed());
    follow();
    if (!history_.rows().empty()) stage_.show_chart(live_chart(history_.rows(), levels_));
  }

  void run() { loop_.run(); }

 private:
  TouchTarget first_target() {
    constexpr double hover_share = 0.05;
    const Scene scene = input_.view.scene.value_or(Scene{});
    return {input_.view.world, scene, hover_share * stage_.extent().everything().radius_m,
            resting_finger(*input_.view.world, scene)};
  }

  WindowHandlers handlers() {
    WindowHandlers handlers;
    handlers.window = touch_window_kind(input_);
    handlers.act = [this](KeyAction action) { return material_key(action); };
    handlers.at_once = [this](const InputEvent& event) { return pointer_.take(event); };
    handlers.has_opened = [this] {
      if (!input_.keeps_pace) drawing_.stand_back();
    };
    handlers.wheel = [this](int steps) {
      pointer_.change_force(steps, loop_.event_s());
      return true;
    };
    handlers.panel = [this](const PanelHit& hit) {
      if (hit.panel != material_panel || !material_) return;
      if (hit.steps != 0) return change_material(hit.row, hit.steps);
      if (hit.row >= 0 && hit.row < MaterialPanel::row_count) material_->select(hit.row);
      stage_.panels().show(material_->panel());
    };
    handlers.frame = [this](double elapsed_s) { return frame(elapsed_s); };
    handlers.report = [this](WindowReport& report) {
      report.t_s = history_.rows().empty() ? 0 : history_.rows().back().t_s;
      report.target_W = pointer_.pressed_W();
      report.pressing = pointer_.pressing();
      report.press_n = pointer_.press_n();
      report.invites = input_.pointer_leads && !pointer_.has_pressed();
    };
    return handlers;
  }

  void change_material(int row, int steps) {
    const std::string told = material_->step(row, steps);
    if (!told.empty()) loop_.tell(told);
    stage_.panels().show(material_->panel());
    stage_.put(input_.swap->scene());
    levels_ = touch_levels(stage_.now());
  }

  /// Keys of the material, which also open its panel.
  bool material_key(KeyAction action) {
    if (!material_) return false;
    const bool shown = stage_.panels().shows(material_panel);
    switch (action) {
      case KeyAction::materials:
        shown ? stage_.panels().hide(material_panel) : stage_.panels().show(material_->panel());
        return true;
      case KeyAction::next_row:
        if (shown) material_->select((material_->selected() + 1) % MaterialPanel::row_count);
        stage_.panels().show(material_->panel());
        return true;
      case KeyAction::less:
      case KeyAction::more:
        change_material(material_->selected(), action == KeyAction::more ? 1 : -1);
        return true;
      default:
        return false;
    }
  }

  bool frame(double elapsed_s) {
    if (input_.is_over && input_.is_over()) loop_.close();
    if (input_.alarm) stage_.show_alarm(input_.alarm());
    pointer_.show(stage_.pointed());
    invite();
    follow();
    since_chart_s_ += elapsed_s;
    if (since_chart_s_ >= live_chart_period_s) {
      since_chart_s_ = 0;
      // What somebody zoomed to stays for as long as it is looked at.
      if (!stage_.charts().zoomed()) stage_.show_chart(live_chart(history_.rows(), levels_));
      if (input_.timing) {
        const ServoTiming timing = input_.timing();
        stage_.show_readings(timing_readings(timing), tick_bars(timing.tick_times));
      }
    }
    return true;
  }

  void invite() { stage_.invite(input_.pointer_leads && !pointer_.has_pressed() ? invitation : ""); }

  void follow() {
    history_.gather(input_);
    if (history_.rows().empty()) return;
    const TickRecord& row = history_.rows().back();
    stage_.show(row, history_.speed_m_per_s());
    if (input_.is_stopped && input_.is_stopped()) {
      stage_.show_title_note("STOPPED: no force on the device   g gives it back   h help");
      return;
    }
    const std::string& note = stage_.has_alarm() ? no_note_ : input_.note;
    const char* const held = stage_.charts().zoomed() ? "   charts held: r lets them run on" : "";
    // What must be read comes first: a long name may be cut.
    const std::string press = input_.pointer_leads
                                  ? fmt::format("press {:.2f} N ({})", pointer_.press_n(),
                                                pointer_.pressing() ? "pressing" : "hovering")
                                  : "";
    const std::string line = fmt::format("{}{}   h help{}{}", press, held, note.empty() ? "" : "   ", note);
    stage_.show_title_note(line.substr(line.find_first_not_of(' ')));
  }

  const TouchWindowInput& input_;
  const std::string no_note_;
  RecentTicks history_;
  Stage stage_;
  PointerTouch pointer_;
  TouchLevels levels_;
  std::optional<MaterialPanel> material_;
  double since_chart_s_ = live_chart_period_s;
  WindowLoop loop_;
  DrawingThreads drawing_;  ///< after the loop, whose listener is none of them
};

}  // namespace

void run_touch_window(const TouchWindowInput& input, const WindowOptions& options) {
  need_display();
  TouchWindow(input, options).run();
}

}  // namespace fingerpad
