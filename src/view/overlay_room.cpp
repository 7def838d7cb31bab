#include "view/overlay_room.hpp"

#include "view/overlay_hud.hpp"

namespace fingerpad {

void find_room(OverlayPlaces& places, OverlayFacts& facts, const ViewState& state, const Layout& layout,
               const InSight& in_sight, bool wants_inset) {
  facts.finger_px = in_sight.finger_px;
  const Vec2 whole = readings_size(facts, layout.em);
  // Of a small scene they would hide too much.
  constexpr double most_share = 0.2;
  facts.brief = whole.x() * whole.y() > most_share * layout.scene.width * layout.scene.height ||
                layout.window.width < least_width_with_charts_px ||
                layout.window.height < least_height_with_charts_px;
  const Vec2 hud = state.hud ? readings_size(facts, layout.em) : Vec2(0, 0);
  const Vec2 legend = state.hud ? legend_size(facts, state, layout.em) : Vec2(0, 0);
  const double side = wants_inset ? layout.inset.width : 0;
  using enum Corner;
  const auto boxes = places.place(below_alarm(facts.alarm, layout),
                                  {{hud.x(), hud.y(), {top_left, top_right, bottom_right}},
                                   {side, side, {top_right, bottom_right, top_left, bottom_left}},
                                   {legend.x(), legend.y(), {bottom_left, bottom_right, top_left}}},
                                  in_sight.finger_px, facts.panels, in_sight.tips_px);
  facts.hud = boxes[0];
  facts.inset = boxes[1];
  facts.legend = boxes[2];
}

void tell_lost_finger(OverlayFacts& facts, const Layout& layout) {
  if (!facts.finger_px || !facts.invitation.empty()) return;
  if (!layout.scene.holds(facts.finger_px->x(), facts.finger_px->y()))
    facts.invitation = "the finger is out of sight: 0 shows all";
}

}  // namespace fingerpad
