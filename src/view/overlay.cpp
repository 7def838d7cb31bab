#include "view/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/overlay_hud.hpp"
#include "view/overlay_notice.hpp"
#include "view/overlay_places.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

/// A pixel more all around: the row between a box and the scene is half the box's, and nobody else draws it.
Box with_rim(const Box& box) {
  return {box.left - 1, box.bottom - 1, box.width + 2, box.height + 2};
}

/// Draws the overlay; holds what its parts share.
class OverlayPainter {
 public:
  OverlayPainter(Drawing& drawing, const OverlayFacts& facts, const ViewState& state, const Layout& layout)
      : drawing_(drawing), facts_(facts), state_(state), layout_(layout), em_(layout.em) {}

  void paint() {
    paint_title();
    if (!state_.help) paint_words();
    if (layout_.timeline.height > 0) paint_timeline();
    if (!facts_.alarm.empty()) paint_alarm();
    if (state_.help) paint_help();
  }

 private:
  void paint_title() {
    drawing_.box(with_rim(layout_.title), colours::white);
    const double middle = layout_.title.centre().y(), right = layout_.title.right() - 0.7 * em_;
    const std::string hint = fitted(facts_.hint, 0.95 * em_, false, 0.5 * layout_.title.width);
    const double room = right - text_width(hint, 0.95 * em_) - 2 * em_;
    const std::string title = fitted(facts_.title, 1.15 * em_, true, room);
    drawing_.text({0.7 * em_, middle}, title, {.size = 1.15 * em_, .upright = Upright::middle, .bold = true});
    const double behind = 1.7 * em_ + text_width(title, 1.15 * em_, true);
    drawing_.text({behind, middle}, fitted(facts_.subtitle, 0.95 * em_, false, room - behind),
                  {.size = 0.95 * em_, .colour = colours::grey, .upright = Upright::middle});
    if (!hint.empty()) {
      drawing_.text(
          {right, middle}, hint,
          {.size = 0.95 * em_, .colour = colours::grey, .across = Across::right, .upright = Upright::middle});
    }
  }

  /// Cut where it does not fit: the terminal has it whole.
  void paint_alarm() {
    const Box line = alarm_line(facts_, layout_);
    constexpr Colour on_red{255, 252, 204};  // a colour, which the dark theme leaves bright
    drawing_.box(line, Colour{178, 24, 32});
    drawing_.text({line.left + 0.7 * em_, line.centre().y()},
                  fitted(facts_.alarm, 1.15 * em_, true, line.width - 1.4 * em_),
                  {.size = 1.15 * em_, .colour = on_red, .upright = Upright::middle, .bold = true});
  }

  /// What is said once: what is missing, how to press, what has just been done. Where lists leave too little
  /// room for long lines, in shorter ones.
  void paint_words() {
    paint_notice(drawing_, facts_, layout_);
    if (facts_.invitation.empty() && facts_.message.empty()) return;
    const double gap = 0.8 * em_;
    Pills pills;
    std::optional<Box> place;
    for (const double share : {1.0, 0.5, 0.35}) {
      const double most = std::max(share * layout_.scene.width - 4 * em_, 8 * em_);
      pills = {wrapped(facts_.invitation, em_, most, true), wrapped(facts_.message, em_, most, true)};
      place = words_place(layout_, room_for(pills, gap), facts_.finger_px, taken_places());
      if (place) break;
    }
    if (!place) place = Box{layout_.scene.centre().x(), layout_.scene.bottom + 6 * em_, 0, 0};
    double bottom = place->bottom;
    for (const std::vector<std::string>& lines : pills) {
      const double height = height_of(lines);
      paint_pill(drawing_, {place->centre().x(), bottom + height / 2}, lines, em_);
      bottom += height + gap;
    }
  }

  using Pills = std::array<std::vector<std::string>, 2>;

  /// A line's at the least, so that words do not leap where another line comes or goes.
  double height_of(const std::vector<std::string>& lines) const {
    return pill_size(lines.empty() ? std::vector<std::string>{""} : lines, em_).y();
  }

  Vec2 room_for(const Pills& pills, double gap) const {
    return {std::max(pill_size(pills[0], em_).x(), pill_size(pills[1], em_).x()),
            height_of(pills[0]) + gap + height_of(pills[1])};
  }

  /// What words keep clear of: readings, legend, close-up, alarm, lists, scale and axes.
  std::vector<Box> taken_places() const {
    std::vector<Box> taken = {facts_.hud, facts_.legend, alarm_line(facts_, layout_)};
    if (facts_.inset_px_per_mm > 0) taken.push_back(facts_.inset);
    taken.insert(taken.end(), facts_.panels.begin(), facts_.panels.end());
    const Box& scene = layout_.scene;
    taken.push_back(
        {scene.right() - axes_foot_em * em_, scene.bottom, axes_foot_em * em_, axes_foot_em * em_});
    taken.push_back(
        {scene.right() - scale_bar_reach_em * em_, scene.bottom, scale_bar_reach_em * em_, 3 * em_});
    return taken;
  }

  void paint_timeline() {
    drawing_.box(with_rim(layout_.timeline), colours::white);
    drawing_.line({layout_.timeline.left, layout_.timeline.top()},
                  {layout_.timeline.right(), layout_.timeline.top()}, {colours::pale_grey, 1});
    const Box slider = time_slider(layout_);
    const double y = slider.centre().y();
    const double x = layout_.timeline.left + 0.9 * em_;
    if (state_.playing) {
      drawing_.box({x, y - 0.55 * em_, 0.35 * em_, 1.1 * em_}, colours::ink);
      drawing_.box({x + 0.6 * em_, y - 0.55 * em_, 0.35 * em_, 1.1 * em_}, colours::ink);
    } else {
      drawing_.area({{x, y - 0.6 * em_}, {x + 1.0 * em_, y}, {x, y + 0.6 * em_}}, colours::ink);
    }
    const double span_s = facts_.t_last_s - facts_.t_first_s;
    const double t_s = facts_.row ? facts_.row->t_s : facts_.t_first_s;
    const double share = span_s > 0 ? std::clamp((t_s - facts_.t_first_s) / span_s, 0.0, 1.0) : 0;
    drawing_.box({slider.left, y - 0.15 * em_, slider.width, 0.3 * em_}, colours::pale_grey);
    drawing_.box({slider.left, y - 0.15 * em_, slider.width * share, 0.3 * em_}, colours::blue);
    drawing_.disc({slider.left + slider.width * share, y}, 0.55 * em_, colours::blue);
    std::string time = fmt::format("{:.3f} / {:.3f} s", t_s, facts_.t_last_s);
    if (state_.speed != 1) time += fmt::format("  {}x", plain_number(state_.speed));
    drawing_.text({slider.right() + 1.2 * em_, y}, time, {.size = em_, .upright = Upright::middle});
  }

  /// Where the help page may be: not over what has gone wrong.
  Box help_room() const {
    Box room = layout_.window;
    if (!facts_.alarm.empty()) room.height = alarm_line(facts_, layout_).bottom;
    return room;
  }

  /// The page's head, in which is told what has just been done: the page lies where that is told else.
  void paint_help_head(const Box& page) {
    const double height = 2.4 * em_, line = 1.1 * em_, middle = page.top() - height / 2;
    if (facts_.message.empty()) {
      drawing_.text({page.centre().x(), middle}, "keys and mouse",
                    {.size = 1.2 * em_, .across = Across::centre, .upright = Upright::middle, .bold = true});
      return;
    }
    drawing_.box({page.left, page.top() - height, page.width, height}, colours::ink);
    std::vector<std::string> lines = wrapped(facts_.message, em_, page.width - em_, true);
    for (; lines.size() > 2; lines.pop_back()) lines[1] += "...";
    double y = middle + line * (static_cast<double>(lines.size()) - 1) / 2;
    for (const std::string& words : lines) {
      drawing_.text({page.centre().x(), y}, fitted(words, em_, true, page.width - em_),
                    {.size = em_,
                     .colour = colours::white,
                     .across = Across::centre,
                     .upright = Upright::middle,
                     .bold = true});
      y -= line;
    }
  }

  void paint_help() {
    constexpr double column_em = 34, line_em = 1.6, least_line_em = 1.1;
    const Box around = help_room();
    const double head = 3.4 * em_, room = around.height - head - em_;
    const auto rows = static_cast<double>(facts_.help.size());
    double line = line_em * em_, columns = std::ceil(rows / std::max(1.0, std::floor(room / line)));
    // Rather close to each other than cut: two columns may be too narrow for what they say.
    const bool is_narrow = column_em * em_ * columns > layout_.window.width;
    if (is_narrow && room / rows >= least_line_em * em_) {
      line = std::min(line, room / rows);
      columns = 1;
    }
    const double per_column = std::ceil(rows / columns), height = line * per_column + head;
    const Vec2 middle = around.centre();
    const double width = std::min(column_em * em_ * columns, layout_.window.width - em_);
    const Box box{middle.x() - width / 2, middle.y() - height / 2, width, height};
    drawing_.box(box, Colour{255, 255, 255, 0.96});
    drawing_.frame(box, {colours::ink, 0.12 * em_});
    paint_help_head(box);
    const double column_width = (width - em_) / columns;
    for (std::size_t i = 0; i < facts_.help.size(); ++i) {
      const std::string& entry = facts_.help[i];
      const double column = std::floor(static_cast<double>(i) / per_column);
      const double left = box.left + em_ + column * column_width;
      const double y = box.top() - 3.2 * em_ - line * (static_cast<double>(i) - column * per_column);
      const std::size_t colon = entry.find(": ");
      const double does = 11 * em_;
      drawing_.text({left, y}, fitted(entry.substr(0, colon), em_, true, does - 0.4 * em_),
                    {.size = em_, .upright = Upright::middle, .bold = true});
      if (colon == std::string::npos) continue;
      drawing_.text({left + does, y},
                    fitted(entry.substr(colon + 2), em_, false, column_width - does - 0.4 * em_),
                    {.size = em_, .upright = Upright::middle});
    }
  }

  Drawing& drawing_;
  const OverlayFacts& facts_;
  const ViewState& state_;
  const Layout& layout_;
  double em_;
};

}  // namespace

Colour ramp_colour(double share) {
  constexpr Colour stops[] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  const double place = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * 4;
  const int low = std::min(3, static_cast<int>(place));
  const double part = place - low;
  const auto mix = [&](std::uint8_t Colour::*channel) {
    return static_cast<std::uint8_t>(
        std::lround(stops[low].*channel * (1 - part) + stops[low + 1].*channel * part));
  };
  return {mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue)};
}

Box alarm_line(const OverlayFacts& facts, const Layout& layout) {
  const double height = facts.alarm.empty() ? 0 : 2 * layout.em;
  return {layout.scene.left, layout.scene.top() - height, layout.scene.width, height};
}

Box time_slider(const Layout& layout) {
  const double em = layout.em;
  const double left = layout.timeline.left + 3.2 * em;
  return {left, layout.timeline.bottom + 0.5 * em, layout.timeline.right() - 15 * em - left,
          layout.timeline.height - em};
}

Drawing readings_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout) {
  Drawing drawing;
  if (state.hud && facts.hud.width > 0) paint_readings(drawing, facts, facts.hud, layout.em);
  return drawing;
}

Drawing overlay_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout) {
  Drawing drawing;
  OverlayPainter(drawing, facts, state, layout).paint();
  return drawing;
}

}  // namespace fingerpad
