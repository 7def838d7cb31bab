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
#include "view/touch_doubts.hpp"
#include "view/window_loop_vtk.hpp"

namespace fingerpad {
namespace {

constexpr double chart_s = 4;  // what the strip charts hold
constexpr const char* material_panel = "material";
constexpr const char* stopped_words = "STOPPED: no force until g, and the device, release it";
constexpr const char* invitation = "hold the left button on the part, or space, to press";
constexpr const char* turning_words = "this turns the view: to press, begin on the part";

class TouchWindow {
 public:
  TouchWindow(const TouchWindowInput& input, const WindowOptions& options)
      : input_(input),
        history_(chart_s),
        stage_(input.view, options.width, options.height, true, false),
        pointer_(input, first_target(),
                 [this](const Vec3& from_mm, const Vec3& to_mm) {
                   return stage_.world().finger_hit(from_mm, to_mm, finger_radius_m());
                 }),
        changed_(input.view),
        levels_(touch_levels(changed_)),
        loop_(stage_, options, handlers()) {
    if (input.swap != nullptr) {
      const bool has_motors = input.set_stop != nullptr;
      material_.emplace(*input.swap, *input.view.world, has_motors);
    }
    stage_.words().help = help_lines(touch_window_kind(input_));
    invite();
    stage_.keep_clear_of_readings();
    pointer_.show(stage_.pointed(), 0);
    follow();
    if (!history_.rows().empty()) stage_.show_chart(live_chart(history_.rows(), levels_));
  }

  void run() { loop_.run(); }

 private:
  double finger_radius_m() const { return input_.view.scene ? input_.view.scene->finger.radius_m : 0; }

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
      if (!input_.pointer_leads) return false;
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
      report.hint = stage_.words().hint;
      report.invites = input_.pointer_leads && !pointer_.has_pressed();
    };
    return handlers;
  }

  void change_material(int row, int steps) {
    const std::string told = material_->step(row, steps);
    if (!told.empty()) loop_.tell(material_told_ = told);
    stage_.panels().show(material_->panel());
  }

  /// With what was told of it.
  void hide_material() {
    stage_.panels().hide(material_panel);
    if (!material_told_.empty() && stage_.words().message == material_told_) loop_.tell("");
    material_told_.clear();
  }

  /// A change holds from its tick on: in the title, and in the charts' lines of friction. A recording that is
  /// followed makes its changes by itself.
  void follow_changes() {
    if (input_.swap == nullptr || !input_.view.scene) return;
    const std::vector<SceneChange> fresh = input_.swap->taken(changed_.changes.size());
    if (fresh.empty()) return;
    changed_.changes.insert(changed_.changes.end(), fresh.begin(), fresh.end());
    levels_ = touch_levels(changed_);
    Scene scene = *input_.view.scene;
    for (const SceneChange& change : changed_.changes) apply(change, scene);
    stage_.put(scene);
  }

  /// Keys of the material, which also open its panel.
  bool material_key(KeyAction action) {
    if (!material_) return false;
    const bool shown = stage_.panels().shows(material_panel);
    switch (action) {
      case KeyAction::materials:
        shown ? hide_material() : stage_.panels().show(material_->panel());
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
    warn();
    PointedScene shown = stage_.pointed();
    if (!history_.rows().empty()) shown.finger_W = history_.rows().back().p_WQ;
    pointer_.show(std::move(shown), loop_.event_s());
    invite();
    look_at_reach(elapsed_s);
    follow();
    follow_changes();
    since_chart_s_ += elapsed_s;
    if (since_chart_s_ >= live_chart_period_s) {
      since_chart_s_ = 0;
      // What somebody zoomed to stays for as long as it is looked at.
      if (!stage_.charts().zoomed()) stage_.show_chart(live_chart(history_.rows(), levels_));
      if (input_.timing) {
        const ServoTiming timing = input_.timing();
        stage_.words().readings = timing_readings(timing);
        stage_.words().tick_bars = tick_bars(timing.tick_times);
      }
    }
    return true;
  }

  /// In red, whatever moves the finger: an emergency stop, and what has gone wrong.
  void warn() {
    const std::string trouble = input_.alarm ? input_.alarm() : "";
    const bool stopped = input_.is_stopped && input_.is_stopped();
    stage_.words().alarm =
        fmt::format("{}{}{}", stopped ? stopped_words : "", stopped && !trouble.empty() ? "; " : "", trouble);
  }

  void invite() {
    const bool is_new = input_.pointer_leads && !pointer_.has_pressed();
    stage_.words().invitation = !is_new ? "" : pointer_.turns_view() ? turning_words : invitation;
  }

  /// A finger on its way is not there yet: told is what has stayed so for a moment.
  void look_at_reach(double elapsed_s) {
    const bool is_kept_away = input_.pointer_leads && !history_.rows().empty() &&
                              pointer_.is_kept_from_spot(history_.rows().back().p_WQ);
    kept_away_s_ = is_kept_away ? kept_away_s_ + elapsed_s : 0;
  }

  /// What somebody may wonder about; empty: nothing.
  std::string doubt(const TickRecord& row) const {
    constexpr double patience_s = 0.4;
    if (kept_away_s_ > patience_s) return "the finger is too large for what is under the pointer";
    return input_.view.world ? too_deep_words(*input_.view.world, row) : "";
  }

  const char* what_it_does(const TickRecord& row) const {
    if (pointer_.pressing()) return row.walls > 0 ? "pressing" : "pressing, touches nothing";
    return pointer_.turns_view() ? "turning the view" : "hovering";
  }

  void follow() {
    history_.gather(input_);
    if (history_.rows().empty()) return;
    const TickRecord& row = history_.rows().back();
    stage_.show(row, history_.speed_m_per_s());
    const std::string note = input_.note ? input_.note() : "";
    const char* const held = stage_.charts().zoomed() ? "   charts held: r lets them run on" : "";
    // What must be read comes first: a long name may be cut.
    const std::string press =
        input_.pointer_leads ? fmt::format("press {:.2f} N ({})", pointer_.press_n(), what_it_does(row)) : "";
    const std::string doubts = doubt(row);
    const std::string line = fmt::format("{}{}{}{}   h help{}{}", press, doubts.empty() ? "" : "   ", doubts,
                                         held, note.empty() ? "" : "   ", note);
    stage_.words().hint = line.substr(line.find_first_not_of(' '));
  }

  const TouchWindowInput& input_;
  RecentTicks history_;
  Stage stage_;
  PointerTouch pointer_;
  ViewInput changed_;  ///< the view, with the changes that were made so far
  TouchLevels levels_;
  std::optional<MaterialPanel> material_;
  std::string material_told_;  ///< last, while it is shown
  double since_chart_s_ = live_chart_period_s;
  double kept_away_s_ = 0;  ///< for how long the finger has been too large for its spot
  WindowLoop loop_;
  DrawingThreads drawing_;  ///< after the loop, whose listener is none of them
};

}  // namespace

void run_touch_window(const TouchWindowInput& input, const WindowOptions& options) {
  need_display(headless_instead);
  TouchWindow(input, options).run();
}

}  // namespace fingerpad
