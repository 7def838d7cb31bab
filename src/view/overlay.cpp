#include "view/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
    for (const auto& label : facts_.labels) {
      // On bright metal, in the dark, letters would be bright as well.
      const Vec2 half(text_width(label.words, 0.95 * em_) / 2 + 0.2 * em_, 0.65 * em_);
      drawing_.box({label.at.x() - half.x(), label.at.y() - half.y(), 2 * half.x(), 2 * half.y()},
                   panel_colour);
      drawing_.text(label.at, label.words,
                    {.size = 0.95 * em_, .across = Across::centre, .upright = Upright::middle});
    }
    if (state_.hud && facts_.legend.width > 0) paint_legend(drawing_, facts_, state_, facts_.legend, em_);
    paint_scale_and_axes();
    if (facts_.inset_px_per_mm > 0) paint_inset_frame();
    paint_marks();
    paint_words();
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

  void paint_marks() {
    const auto behind = [this](const Vec2& mark) {
      return facts_.inset_px_per_mm > 0 && facts_.inset.holds(mark.x(), mark.y());
    };
    if (facts_.marks.empty() || std::all_of(facts_.marks.begin(), facts_.marks.end(), behind)) return;
    if (facts_.marks.size() > 1)
      drawing_.line(facts_.marks[0], facts_.marks[1], {colours::ink, 0.14 * em_, 0.5 * em_, 0.3 * em_});
    for (const Vec2& mark : facts_.marks) {
      if (behind(mark)) continue;
      drawing_.disc(mark, 0.36 * em_, colours::white);
      drawing_.disc(mark, 0.25 * em_, colours::reddish_purple);
    }
    const double width = pill_width(facts_.marks_words, em_);
    paint_pill(drawing_, marks_words_place(facts_.marks, width, layout_), facts_.marks_words, em_);
  }

  /// Cut where it does not fit: the terminal has it whole.
  void paint_alarm() {
    const Box line = alarm_line(facts_, layout_);
    drawing_.box(line, Colour{178, 24, 32});
    drawing_.text({line.left + 0.7 * em_, line.centre().y()},
                  fitted(facts_.alarm, 1.15 * em_, true, line.width - 1.4 * em_),
                  {.size = 1.15 * em_, .colour = colours::white, .upright = Upright::middle, .bold = true});
  }

  /// What is said once: what is missing, how to press, what has just been done.
  void paint_words() {
    const double most = layout_.scene.width - 4 * em_;
    std::array<std::string, 2> lines;
    double width = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i] = fitted(i == 0 ? facts_.invitation : facts_.message, em_, true, most);
      width = std::max(width, lines[i].empty() ? 0.0 : pill_width(lines[i], em_));
    }
    const Box place = words_place(layout_, width, facts_.finger_px, {facts_.hud, facts_.legend});
    Vec2 at(place.centre().x(), place.bottom + 1.1 * em_);
    for (const std::string& words : lines) {
      if (!words.empty()) paint_pill(drawing_, at, words, em_);
      at.y() += 3 * em_;
    }
    paint_notice(drawing_, facts_, layout_);
  }

  void paint_scale_and_axes() {
    const Vec2 middle(layout_.scene.right() - 3.6 * em_, layout_.scene.bottom + 3.6 * em_);
    constexpr const char* names[] = {"x", "y", "z"};
    std::array<int, 3> order{0, 1, 2};  // the axis nearest to the eye comes last
    std::sort(order.begin(), order.end(),
              [this](int a, int b) { return facts_.axes_px(2, a) < facts_.axes_px(2, b); });
    for (const int axis : order) {
      const Vec2 along = facts_.axes_px.col(axis).head<2>();
      const Colour colour = facts_.axes_px(2, axis) < -0.2 ? colours::grey : colours::ink;
      drawing_.line(middle, middle + along * 2.0 * em_, {colour, 0.15 * em_});
      // Of an axis seen from its end the letter stands beside the corner of the others.
      const bool from_its_end = along.norm() < 0.25;
      const Vec2 place = from_its_end ? Vec2(-0.7 * em_, -0.7 * em_) : Vec2(along * 2.7 * em_);
      drawing_.text(middle + place, names[axis],
                    {.size = em_, .colour = colour, .across = Across::centre, .upright = Upright::middle});
    }
    if (!(facts_.px_per_mm > 0)) return;
    const double length_mm = round_down_125(9 * em_ / facts_.px_per_mm);
    paint_scale_bar({middle.x() - 4.2 * em_, layout_.scene.bottom + 1.2 * em_}, length_mm, facts_.px_per_mm);
  }

  /// A bar that ends at `right_end`, with its length above.
  void paint_scale_bar(const Vec2& right_end, double length_mm, double px_per_mm) {
    const Vec2 left_end = right_end - Vec2(length_mm * px_per_mm, 0);
    const double half = 0.3 * em_;
    const Stroke stroke{colours::ink, 0.14 * em_};
    drawing_.line(left_end, right_end, stroke);
    for (const Vec2& end : {left_end, right_end}) {
      drawing_.line(end - Vec2(0, half), end + Vec2(0, half), stroke);
    }
    drawing_.text((left_end + right_end) / 2 + Vec2(0, 0.4 * em_), plain_number(length_mm) + " mm",
                  {.size = em_, .across = Across::centre});
  }

  void paint_inset_frame() {
    const Box& box = facts_.inset;
    drawing_.frame(box, {colours::grey, std::max(1.0, 0.1 * em_)});
    drawing_.box({box.left, box.top() - 1.5 * em_, box.width, 1.5 * em_}, panel_colour);
    const double zoom = facts_.inset_px_per_mm / facts_.px_per_mm;
    drawing_.text({box.centre().x(), box.top() - 0.75 * em_},
                  fmt::format("contact, {}{:.{}f}x", walls_words(), zoom, zoom < 10 ? 1 : 0),
                  {.size = em_, .across = Across::centre, .upright = Upright::middle});
    drawing_.box({box.left, box.bottom, box.width, 2.3 * em_}, panel_colour);
    drawing_.text({box.left + 0.6 * em_, box.bottom + 1.15 * em_}, "up: finger",
                  {.size = em_, .colour = colours::grey, .upright = Upright::middle});
    const double length_mm = round_down_125(0.4 * box.width / facts_.inset_px_per_mm);
    paint_scale_bar({box.right() - 0.8 * em_, box.bottom + 0.6 * em_}, length_mm, facts_.inset_px_per_mm);
  }

  /// Of several the region is not drawn: a record has the greatest wall's centre and the mean of their
  /// normals.
  std::string walls_words() const {
    return facts_.row && facts_.row->walls > 1 ? fmt::format("{} walls, ", facts_.row->walls) : "";
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

  void paint_help() {
    constexpr double column_em = 34, line_em = 1.6, least_line_em = 1.1;
    const double head = 3.4 * em_, room = layout_.window.height - head - em_;
    const auto rows = static_cast<double>(facts_.help.size());
    double line = line_em * em_, columns = std::ceil(rows / std::max(1.0, std::floor(room / line)));
    // Rather close to each other than cut: two columns may be too narrow for what they say.
    const bool is_narrow = column_em * em_ * columns > layout_.window.width;
    if (is_narrow && room / rows >= least_line_em * em_) {
      line = std::min(line, room / rows);
      columns = 1;
    }
    const double per_column = std::ceil(rows / columns), height = line * per_column + head;
    const Vec2 middle = layout_.window.centre();
    const double width = std::min(column_em * em_ * columns, layout_.window.width - em_);
    const Box box{middle.x() - width / 2, middle.y() - height / 2, width, height};
    drawing_.box(box, Colour{255, 255, 255, 0.96});
    drawing_.frame(box, {colours::ink, 0.12 * em_});
    drawing_.text({middle.x(), box.top() - 1.4 * em_}, "keys and mouse",
                  {.size = 1.2 * em_, .across = Across::centre, .upright = Upright::middle, .bold = true});
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
