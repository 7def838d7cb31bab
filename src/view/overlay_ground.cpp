#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/overlay.hpp"
#include "view/overlay_hud.hpp"
#include "view/overlay_places.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

/// Draws what belongs to places of the scene; holds what its parts share.
class GroundPainter {
 public:
  GroundPainter(Drawing& drawing, const OverlayFacts& facts, const ViewState& state, const Layout& layout)
      : drawing_(drawing), facts_(facts), state_(state), layout_(layout), em_(layout.em) {}

  void paint() {
    for (const auto& label : facts_.labels) paint_letters(label.at, label.words, 0.95 * em_, colours::ink);
    if (state_.hud && facts_.legend.width > 0) paint_legend(drawing_, facts_, state_, facts_.legend, em_);
    paint_scale_and_axes();
    if (facts_.inset_px_per_mm > 0) paint_inset_frame();
    paint_marks();
  }

 private:
  /// On a plate: on a part of their own colour letters would not be seen.
  void paint_letters(const Vec2& at, const std::string& words, double size, const Colour& colour) {
    const Vec2 half(text_width(words, size) / 2 + 0.2 * em_, 0.65 * em_);
    drawing_.box({at.x() - half.x(), at.y() - half.y(), 2 * half.x(), 2 * half.y()}, panel_colour);
    drawing_.text(at, words,
                  {.size = size, .colour = colour, .across = Across::centre, .upright = Upright::middle});
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
    std::vector<Box> taken = facts_.panels;
    taken.insert(taken.end(), {facts_.hud, facts_.legend});
    if (facts_.inset_px_per_mm > 0) taken.push_back(facts_.inset);
    const std::vector<std::string> words = {facts_.marks_words};
    const double width = pill_size(words, em_).x();
    paint_pill(drawing_, marks_words_place(facts_.marks, width, layout_, taken), words, em_);
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
      paint_letters(middle + place, names[axis], em_, colour);
    }
    if (!(facts_.px_per_mm > 0)) return;
    const double length_mm = round_down_125(9 * em_ / facts_.px_per_mm);
    paint_scale_bar({middle.x() - 4.2 * em_, layout_.scene.bottom + 1.2 * em_}, length_mm, facts_.px_per_mm,
                    true);
  }

  /// A bar that ends at `right_end`, with its length above.
  /// @param on_plate  where a part of its own colour may lie behind it
  void paint_scale_bar(const Vec2& right_end, double length_mm, double px_per_mm, bool on_plate) {
    const Vec2 left_end = right_end - Vec2(length_mm * px_per_mm, 0);
    const double half = 0.3 * em_;
    const std::string words = plain_number(length_mm) + " mm";
    if (on_plate) {
      const double width = std::max(right_end.x() - left_end.x(), text_width(words, em_)) + 0.4 * em_;
      drawing_.box({(left_end.x() + right_end.x() - width) / 2, right_end.y() - 0.5 * em_, width, 2 * em_},
                   panel_colour);
    }
    const Stroke stroke{colours::ink, 0.14 * em_};
    drawing_.line(left_end, right_end, stroke);
    for (const Vec2& end : {left_end, right_end}) {
      drawing_.line(end - Vec2(0, half), end + Vec2(0, half), stroke);
    }
    drawing_.text((left_end + right_end) / 2 + Vec2(0, 0.4 * em_), words,
                  {.size = em_, .across = Across::centre});
  }

  void paint_inset_frame() {
    const Box& box = facts_.inset;
    drawing_.frame(box, {colours::grey, std::max(1.0, 0.1 * em_)});
    drawing_.box({box.left, box.top() - 1.5 * em_, box.width, 1.5 * em_}, panel_colour);
    const double zoom = facts_.inset_px_per_mm / facts_.px_per_mm;
    drawing_.text({box.centre().x(), box.top() - 0.75 * em_}, close_up_words(zoom, box.width - 0.8 * em_),
                  {.size = em_, .across = Across::centre, .upright = Upright::middle});
    drawing_.box({box.left, box.bottom, box.width, 2.3 * em_}, panel_colour);
    const double length_mm = round_down_125(0.4 * box.width / facts_.inset_px_per_mm);
    const double bar = length_mm * facts_.inset_px_per_mm,
                 label = text_width(plain_number(length_mm) + " mm", em_);
    const double scale_left = box.right() - 0.8 * em_ - std::max(bar, label);
    if (box.left + em_ + text_width("up: finger", em_) < scale_left) {
      drawing_.text({box.left + 0.6 * em_, box.bottom + 1.15 * em_}, "up: finger",
                    {.size = em_, .colour = colours::grey, .upright = Upright::middle});
    }
    const double label_beside = std::max(0.0, (label - bar) / 2);  // of a short bar, at each end
    paint_scale_bar({box.right() - 0.8 * em_ - label_beside, box.bottom + 0.6 * em_}, length_mm,
                    facts_.inset_px_per_mm, false);
  }

  /// The whole, or as much of it as a small frame has room for.
  std::string close_up_words(double zoom, double room) const {
    const std::string times = fmt::format("{:.{}f}x", zoom, zoom < 10 ? 1 : 0), walls = walls_words();
    for (const std::string& words : {fmt::format("contact, {}{}", walls, times), walls + times}) {
      if (text_width(words, em_) <= room) return words;
    }
    return fitted(times, em_, false, room);
  }

  /// Of several the region is not drawn: a record has the greatest wall's centre and the mean of their
  /// normals.
  std::string walls_words() const {
    return facts_.row && facts_.row->walls > 1 ? fmt::format("{} walls, ", facts_.row->walls) : "";
  }

  Drawing& drawing_;
  const OverlayFacts& facts_;
  const ViewState& state_;
  const Layout& layout_;
  double em_;
};

}  // namespace

Drawing ground_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout) {
  Drawing drawing;
  GroundPainter(drawing, facts, state, layout).paint();
  return drawing;
}

}  // namespace fingerpad
