#include "view/stage_words.hpp"

#include <fmt/format.h>

#include "view/surface_words.hpp"

namespace fingerpad {
namespace {

/// Why charts of a thinned trace have no rings; empty where every tick is there.
std::string left_out_words(const ViewInput& input) {
  if (input.every <= 1) return {};
  const std::string how = input.every_is_told ? fmt::format("1 tick in {}", input.every) : "ticks left out";
  return how + ": no rings where slip ended";
}

}  // namespace

OverlayFacts facts_to_tell(const ViewInput& input, const ViewInput& now, const StageWords& words,
                           const std::optional<ContactMoment>& moment) {
  OverlayFacts facts;
  facts.title = input.title;
  const std::string with = subtitle_of(now, input.title), left_out = left_out_words(input);
  facts.subtitle = fmt::format("{}{}{}", left_out, left_out.empty() || with.empty() ? "" : "; ", with);
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
