#include "view/stage_words.hpp"

#include "view/surface_words.hpp"

namespace fingerpad {

OverlayFacts facts_to_tell(const ViewInput& input, const ViewInput& now, const StageWords& words,
                           const std::optional<ContactMoment>& moment) {
  OverlayFacts facts;
  facts.title = input.title;
  facts.subtitle = subtitle_of(now, input.title);
  facts.about = about_lines(input);
  facts.notice = input.notice;
  facts.hint = words.hint;
  facts.alarm = words.alarm;
  facts.readings = words.readings;
  facts.tick_bars = words.tick_bars;
  facts.help = words.help;
  facts.invitation = words.invitation;
  facts.message = words.message;
  facts.path = input.rows.size() > 1;
  if (moment) {
    facts.row = moment->row;
    facts.region = moment->region.has_value();
    facts.surface_name = input.world ? surface_name(*input.world, moment->row.surface, 18) : "-";
  }
  if (!input.rows.empty()) {
    facts.t_first_s = input.rows.front().t_s;
    facts.t_last_s = input.rows.back().t_s;
  }
  return facts;
}

}  // namespace fingerpad
