#include "view/overlay_hud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

constexpr double reading_line_em = 1.5, bars_em = 4.4, legend_line_em = 1.4;

std::string number_with_unit(double value, int digits, const char* unit) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{}{}{}", fixed_text(value, digits), *unit != '\0' ? " " : "", unit);
}

std::vector<Reading> all_readings(const OverlayFacts& facts) {
  const TickRecord& row = *facts.row;
  const bool touching = row.phase != Phase::free;
  const auto in_contact = [&](double value, int digits, const char* unit) {
    return touching ? number_with_unit(value, digits, unit) : std::string("-");
  };
  std::vector<Reading> readings = {
      {"time", number_with_unit(row.t_s, 3, "s")},
      {"phase", std::string(phase_name(row.phase))},
      {"depth", in_contact(row.depth_m * 1e3, 3, "mm")},
      {"normal force", in_contact(row.normal_force_n, 3, "N")},
      {"friction", in_contact(row.friction_W_n.norm(), 3, "N")},
      {"mu", in_contact(row.mu, 3, "")},
      // In touch along the part, as the chart draws it; else the finger's own, which it does not.
      {touching ? "speed" : "speed in air", number_with_unit(facts.speed_m_per_s * 1e3, 1, "mm/s")},
      {"finger angle", in_contact(row.inclination_rad * 180 / std::numbers::pi, 1, "deg")},
      {"on", touching ? facts.surface_name : std::string("-")},
      {"walls", touching ? fmt::format("{}", row.walls) : std::string("-")},
  };
  if (!facts.brief) {
    readings.insert(readings.end(), facts.readings.begin(), facts.readings.end());
    return readings;
  }
  const auto is_left_out = [](const Reading& reading) {
    return reading.first != "phase" && reading.first != "normal force" && reading.first != "friction";
  };
  readings.erase(std::remove_if(readings.begin(), readings.end(), is_left_out), readings.end());
  return readings;
}

void paint_tick_bars(Drawing& drawing, const OverlayFacts& facts, const Box& box, double em) {
  const TextStyle small{.size = 0.85 * em, .colour = colours::grey, .upright = Upright::middle};
  TextStyle right = small;
  right.across = Across::right;
  drawing.text({box.left, box.top() - 0.5 * em}, "ticks by how long they took", small);
  const Box bars{box.left, box.bottom + 1.2 * em, box.width, box.height - 2.5 * em};
  const double step = bars.width / static_cast<double>(facts.tick_bars.heights.size());
  double left = bars.left;
  for (const double share : facts.tick_bars.heights) {
    if (share > 0)
      drawing.box({left, bars.bottom, 0.9 * step, std::max(1.0, share * bars.height)}, colours::grey);
    left += step;
  }
  drawing.text({box.left, box.bottom + 0.4 * em}, facts.tick_bars.shortest, small);
  drawing.text({box.right(), box.bottom + 0.4 * em}, facts.tick_bars.longest, right);
}

struct LegendKey {
  std::string label;
  Colour colour;
  bool arrow;
  bool rimmed = false;    ///< the colour within a rim: what is as dark as the paper
  std::string note = {};  ///< on a line below the label; empty: none
};

/// On which wall the stick centre stands, of which a record of several keeps the deepest's alone.
std::string centre_wall_words(const OverlayFacts& facts) {
  const TickRecord& row = *facts.row;
  if (row.walls < 2) return "";
  const std::string triangle = row.triangle < 0 ? "" : fmt::format(", triangle {}", row.triangle);
  return fmt::format("on the deepest of {} walls: {}{}", row.walls, facts.surface_name, triangle);
}

std::vector<LegendKey> legend_keys(const OverlayFacts& facts, const ViewState& state) {
  std::vector<LegendKey> keys;
  if (state.forces) {
    keys.push_back({"normal force", colours::blue, true});
    keys.push_back({"friction", colours::vermillion, true});
    keys.push_back({"whole force", colours::reddish_purple, true});
  }
  if (facts.row->stick_centre_W.allFinite()) {
    // Flat parts turn black and white in the dark, the ball on the part stays black, but between wires.
    const bool stays_black = state.dark && !state.wireframe;
    keys.push_back({"stick centre", stays_black ? colours::white : colours::black, false, stays_black,
                    centre_wall_words(facts)});
  }
  if (facts.region) {
    const bool holds = facts.row->phase == Phase::stick;
    keys.push_back({holds ? "stick region" : "stick region, if it stuck now",
                    holds ? phase_colour(Phase::stick) : colours::grey, false});
  }
  return keys;
}

void paint_colour_bar(Drawing& drawing, const OverlayFacts& facts, const Box& box, double title_y,
                      double em) {
  drawing.text({box.left, title_y}, "path: force on the finger [N]",
               {.size = em, .colour = colours::grey, .upright = Upright::middle});
  constexpr int cells = 40;
  for (int i = 0; i < cells; ++i) {
    drawing.box(
        {box.left + box.width * i / cells, box.bottom + 1.2 * em, box.width / cells + 0.5, box.height},
        ramp_colour((i + 0.5) / cells));
  }
  const double low = box.bottom + 0.95 * em;
  drawing.text({box.left, low}, "0", {.size = em, .upright = Upright::top});
  drawing.text({box.right(), low}, rounded_text(facts.max_force_n, 3),
               {.size = em, .across = Across::right, .upright = Upright::top});
}

void paint_phases(Drawing& drawing, double x, double y, double em) {
  drawing.text({x, y}, "path:", {.size = em, .colour = colours::grey, .upright = Upright::middle});
  x += text_width("path:", em) + 0.6 * em;
  for (const Phase phase : {Phase::free, Phase::stick, Phase::slip}) {
    const std::string name(phase_name(phase));
    drawing.box({x, y - 0.35 * em, 0.7 * em, 0.7 * em}, phase_colour(phase));
    drawing.text({x + em, y}, name, {.size = em, .upright = Upright::middle});
    x += text_width(name, em) + 1.9 * em;
  }
}

void paint_legend_key(Drawing& drawing, const LegendKey& key, double left, double y, double em) {
  if (key.arrow) {
    drawing.line({left, y}, {left + 1.4 * em, y}, {key.colour, 0.2 * em});
    drawing.area({{left + 1.3 * em, y - 0.35 * em}, {left + 2 * em, y}, {left + 1.3 * em, y + 0.35 * em}},
                 key.colour);
  } else {
    if (key.rimmed) drawing.disc({left + 1 * em, y}, 0.48 * em, colours::ink);
    drawing.disc({left + 1 * em, y}, 0.4 * em, key.colour);
  }
  drawing.text({left + 2.6 * em, y}, key.label, {.size = em, .upright = Upright::middle});
}

bool has_bars(const OverlayFacts& facts) {
  return !facts.brief && !facts.tick_bars.heights.empty();
}

bool explains_path(const OverlayFacts& facts, const ViewState& state) {
  return state.path && facts.path;
}

/// What stands below the keys: how long an arrow is, and whose axes the letters in the scene name.
std::vector<std::string> legend_notes(const OverlayFacts& facts, const ViewState& state) {
  std::vector<std::string> notes;
  if (state.forces) notes.push_back(fmt::format("arrows: {} mm = 1 N", plain_number(facts.mm_per_n)));
  if (state.frame && facts.row->phase != Phase::free) notes.push_back("n, Cx, Cy: normal, tangents");
  return notes;
}

}  // namespace

Vec2 readings_size(const OverlayFacts& facts, double em) {
  if (facts.row) {
    const auto lines = static_cast<double>(all_readings(facts).size());
    return {readings_width_em * em,
            reading_line_em * em * lines + 0.8 * em + (has_bars(facts) ? bars_em * em : 0)};
  }
  if (facts.about.empty()) return {0, 0};
  double width = 0;
  for (const std::string& words : facts.about) width = std::max(width, text_width(words, em));
  return {width + 1.4 * em, reading_line_em * em * static_cast<double>(facts.about.size()) + 0.8 * em};
}

void paint_readings(Drawing& drawing, const OverlayFacts& facts, const Box& box, double em) {
  draw_panel(drawing, box);
  const double line = reading_line_em * em;
  double y = box.top() - 0.4 * em - line / 2;
  if (!facts.row) {
    for (const std::string& words : facts.about) {
      drawing.text({box.left + 0.6 * em, y}, words, {.size = em, .upright = Upright::middle});
      y -= line;
    }
    return;
  }
  if (has_bars(facts)) {
    paint_tick_bars(drawing, facts,
                    {box.left + 0.6 * em, box.bottom + 0.5 * em, box.width - 1.2 * em, (bars_em - 0.6) * em},
                    em);
  }
  for (const auto& [name, value] : all_readings(facts)) {
    const bool phase = name == "phase";
    drawing.text({box.left + 0.6 * em, y}, name,
                 {.size = em, .colour = colours::grey, .upright = Upright::middle});
    if (phase) {
      const double chip = text_width(value, em, true) + 1.2 * em;
      drawing.box({box.right() - 0.6 * em - chip, y - 0.68 * em, chip, 1.36 * em},
                  phase_colour(facts.row->phase));
    }
    drawing.text({box.right() - (phase ? 1.2 : 0.6) * em, y}, value,
                 {.size = em,
                  .colour = phase ? colours::white : colours::ink,
                  .across = Across::right,
                  .upright = Upright::middle,
                  .bold = phase});
    y -= line;
  }
}

Vec2 legend_size(const OverlayFacts& facts, const ViewState& state, double em) {
  if (!facts.row || facts.brief) return {0, 0};
  const std::vector<LegendKey> keys = legend_keys(facts, state);
  const bool bar = state.colouring == PathColouring::force;
  const double path_lines = explains_path(facts, state) ? (bar ? 3.0 : 1.0) : 0.0;
  const auto notes = std::ranges::count_if(keys, [](const LegendKey& key) { return !key.note.empty(); });
  const double key_lines = static_cast<double>(keys.size()) + static_cast<double>(notes);
  const std::vector<std::string> below = legend_notes(facts, state);
  const double lines = key_lines + static_cast<double>(below.size()) + path_lines;
  if (lines == 0) return {0, 0};
  double width = 15.5 * em;
  for (const LegendKey& key : keys)
    width = std::max({width, text_width(key.label, em) + 4 * em, text_width(key.note, em) + 1.4 * em});
  for (const std::string& note : below) width = std::max(width, text_width(note, em) + 1.4 * em);
  return {width, lines * legend_line_em * em + 0.8 * em};
}

void paint_legend(Drawing& drawing, const OverlayFacts& facts, const ViewState& state, const Box& box,
                  double em) {
  draw_panel(drawing, box);
  const double line = legend_line_em * em, left = box.left + 0.6 * em;
  double y = box.top() - 0.4 * em - line / 2;
  for (const LegendKey& key : legend_keys(facts, state)) {
    paint_legend_key(drawing, key, left, y, em);
    y -= line;
    if (key.note.empty()) continue;
    drawing.text({left, y}, key.note, {.size = em, .colour = colours::grey, .upright = Upright::middle});
    y -= line;
  }
  for (const std::string& note : legend_notes(facts, state)) {
    drawing.text({left, y}, note, {.size = em, .colour = colours::grey, .upright = Upright::middle});
    y -= line;
  }
  if (!explains_path(facts, state)) return;
  if (state.colouring == PathColouring::force) {
    paint_colour_bar(drawing, facts, {left, y - 2.2 * line, box.width - 1.2 * em, 0.8 * em}, y, em);
  } else {
    paint_phases(drawing, left, y, em);
  }
}

}  // namespace fingerpad
