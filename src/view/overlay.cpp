#include "view/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/number_text.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/overlay_help.hpp"
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

constexpr double alarm_em = 1.15, alarm_line_em = 1.5;

/// What has gone wrong, in as many lines as it takes, but few: the terminal has it whole.
std::vector<std::string> alarm_lines(const std::string& alarm, double width, double em) {
  constexpr std::size_t most = 4;
  std::vector<std::string> lines = wrapped(alarm, alarm_em * em, width - 1.4 * em, true);
  if (lines.size() <= most) return lines;
  lines.resize(most);
  lines.back() = fitted(lines.back() + " ...", alarm_em * em, true, width - 1.4 * em);
  return lines;
}

/// At the top of a box; empty where nothing has gone wrong.
Box alarm_place(const std::string& alarm, const Box& box, double em) {
  const auto lines = static_cast<double>(alarm_lines(alarm, box.width, em).size());
  const double height = lines == 0 ? 0 : (alarm_line_em * lines + 0.5) * em;
  return {box.left, box.top() - height, box.width, height};
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
    if (state_.help) paint_help(drawing_, facts_, help_room(), em_);
    if (!facts_.alarm.empty()) paint_alarm();
  }

 private:
  void paint_title() {
    drawing_.box(with_rim(layout_.title), colours::white);
    const double middle = layout_.title.centre().y(), right = layout_.title.right() - 0.7 * em_;
    // A name that is cut is known all the same; what a recording or a press comes to is not, nor what stands
    // beside it, as a doubt and that the charts are held. What describes the scene gives way to all of it.
    const double name_width =
        std::min(text_width(facts_.title, 1.15 * em_, true), 0.25 * layout_.title.width);
    const std::string hint =
        fitted(facts_.hint, 0.95 * em_, false, std::max(right - name_width - 2.7 * em_, 0.65 * right));
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

  void paint_alarm() {
    const Box box = alarm_box();
    constexpr Colour on_red{255, 252, 204};  // a colour, which the dark theme leaves bright
    drawing_.box(box, Colour{178, 24, 32});
    double y = box.top() - 1.0 * em_;
    for (const std::string& words : alarm_lines(facts_.alarm, box.width, em_)) {
      drawing_.text({box.left + 0.7 * em_, y}, words,
                    {.size = alarm_em * em_, .colour = on_red, .upright = Upright::middle, .bold = true});
      y -= alarm_line_em * em_;
    }
  }

  /// Over the help page it stands at the window's top.
  Box alarm_box() const {
    return alarm_place(facts_.alarm, state_.help ? layout_.window : layout_.scene, em_);
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
    std::vector<Box> taken = {facts_.hud, facts_.legend, alarm_line(facts_.alarm, layout_)};
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
    std::string time = fmt::format("{} / {} s", fixed_text(t_s, 3), fixed_text(facts_.t_last_s, 3));
    if (state_.speed != 1) time += fmt::format("  {}x", plain_number(state_.speed));
    drawing_.text({slider.right() + 1.2 * em_, y}, time, {.size = em_, .upright = Upright::middle});
  }

  /// Where the help page may be: not over what has gone wrong.
  Box help_room() const {
    Box room = layout_.window;
    room.height -= alarm_box().height;
    return room;
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

Box alarm_line(const std::string& alarm, const Layout& layout) {
  return alarm_place(alarm, layout.scene, layout.em);
}

Layout below_alarm(const std::string& alarm, const Layout& layout) {
  Layout below = layout;
  below.scene.height -= alarm_line(alarm, layout).height;
  return below;
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
