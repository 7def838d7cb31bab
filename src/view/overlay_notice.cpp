#include "view/overlay_notice.hpp"

#include <algorithm>

#include "view/colours.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

constexpr double notice_line_em = 1.5, least_notice_em = 14;

/// Left, bottom and width of the room there is for it.
Box notice_room(const OverlayFacts& facts, const Layout& layout) {
  const double em = layout.em, gap = 0.7 * em;
  const Box& scene = layout.scene;
  const bool beside = facts.legend.width > 0 && facts.legend.centre().x() < scene.centre().x() &&
                      facts.legend.centre().y() < scene.centre().y();
  const double left = (beside ? facts.legend.right() : scene.left) + gap;
  const double width = scene.right() - scale_bar_reach_em * em - gap - left;
  if (width >= least_notice_em * em) return {left, scene.bottom + gap, width, 0};
  const double foot = std::max(beside ? facts.legend.top() - scene.bottom : 0.0, axes_foot_em * em);
  return {scene.left + gap, scene.bottom + foot + gap, scene.width - 2 * gap, 0};
}

std::vector<std::string> notice_lines(const OverlayFacts& facts, const Layout& layout, const Box& room) {
  return wrapped(facts.notice, layout.em, std::min(room.width, 40 * layout.em) - 2 * layout.em);
}

}  // namespace

Box notice_box(const OverlayFacts& facts, const Layout& layout) {
  if (facts.notice.empty()) return {};
  const double em = layout.em;
  const Box room = notice_room(facts, layout);
  const auto lines = notice_lines(facts, layout, room);
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, em));
  width += 2 * em;
  return {room.centre().x() - width / 2, room.bottom, width,
          notice_line_em * em * static_cast<double>(lines.size()) + em};
}

void paint_notice(Drawing& drawing, const OverlayFacts& facts, const Layout& layout) {
  const Box box = notice_box(facts, layout);
  if (box.width == 0) return;
  const double em = layout.em;
  drawing.box(box, Colour{255, 244, 214, 0.96});
  drawing.frame(box, {colours::orange, 0.12 * em});
  double y = box.top() - 0.5 * em - notice_line_em * em / 2;
  for (const std::string& line : notice_lines(facts, layout, notice_room(facts, layout))) {
    drawing.text({box.centre().x(), y}, line,
                 {.size = em, .across = Across::centre, .upright = Upright::middle});
    y -= notice_line_em * em;
  }
}

}  // namespace fingerpad
