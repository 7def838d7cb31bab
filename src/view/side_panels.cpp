#include "view/side_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

constexpr double panel_width_em = 21, row_em = 1.75, head_em = 2.1, button_em = 1.6;

constexpr double panel_foot_em = 0.5, panel_gap_em = 0.7;

double height_of(std::size_t rows, double em) {
  return em * (head_em + row_em * static_cast<double>(rows) + panel_foot_em);
}

/// How many lines a panel of this height has.
std::size_t panel_lines_in(double height, double em) {
  constexpr double rounding = 1e-6;  // of a line
  return static_cast<std::size_t>(std::max(0.0, (height / em - head_em - panel_foot_em) / row_em + rounding));
}

/// How many of a panel's rows from this one on are no notes, which nobody counts.
std::size_t counted_from(const SidePanel& panel, std::size_t first) {
  const auto is_counted = [](const PanelRow& row) { return row.kind != PanelRow::Kind::note; };
  const auto begin = panel.rows.begin() + static_cast<std::ptrdiff_t>(std::min(first, panel.rows.size()));
  return static_cast<std::size_t>(std::count_if(begin, panel.rows.end(), is_counted));
}

/// How many of a panel's rows it shows in its box: all, or all but some notes, or as many as leave a line
/// for how many more there are.
std::size_t panel_rows_shown(const SidePanel& panel, const Box& box, double em) {
  const std::size_t lines = panel_lines_in(box.height, em);
  if (counted_from(panel, lines) == 0) return std::min(panel.rows.size(), lines);
  return lines - std::min<std::size_t>(lines, 1);
}

Box row_box(const Box& panel, std::size_t row, double em) {
  const double top = panel.top() - em * (head_em + row_em * static_cast<double>(row));
  return {panel.left, top - row_em * em, panel.width, row_em * em};
}

/// The button for less, or the one for more.
Box button(const Box& row, bool more, double em) {
  const double right = row.right() - 0.5 * em - (more ? 0 : 1.9 * em);
  return {right - button_em * em, row.centre().y() - 0.68 * em, button_em * em, 1.36 * em};
}

void paint_check(Drawing& drawing, const PanelRow& row, const Box& box, double em) {
  const Box square{box.left + 0.7 * em, box.centre().y() - 0.5 * em, em, em};
  drawing.frame(square, {colours::ink, 0.12 * em});
  if (row.on) {
    drawing.line({{square.left + 0.2 * em, square.bottom + 0.5 * em},
                  {square.left + 0.42 * em, square.bottom + 0.22 * em},
                  {square.right() - 0.15 * em, square.top() - 0.2 * em}},
                 {colours::ink, 0.17 * em});
  }
  drawing.text({square.right() + 0.6 * em, box.centre().y()},
               fitted(row.label, em, false, box.right() - square.right() - em),
               {.size = em, .upright = Upright::middle});
}

void paint_value(Drawing& drawing, const PanelRow& row, const Box& box, double em) {
  if (row.selected) drawing.box(box, colours::sky_blue.with_opacity(0.3));
  const double middle = box.centre().y();
  drawing.text({box.left + 0.7 * em, middle}, row.label,
               {.size = em, .colour = colours::grey, .upright = Upright::middle});
  for (const bool more : {false, true}) {
    const Box at = button(box, more, em);
    drawing.box(at, colours::pale_grey);
    drawing.text(at.centre(), more ? "+" : "-",
                 {.size = em, .across = Across::centre, .upright = Upright::middle, .bold = true});
  }
  const double right = button(box, false, em).left - 0.5 * em;
  const double room = right - box.left - 1.4 * em - text_width(row.label, em);
  drawing.text({right, middle}, fitted(row.value, em, false, room),
               {.size = em, .across = Across::right, .upright = Upright::middle});
}

PanelRow more_rows(std::size_t count) {
  return {PanelRow::Kind::note, fmt::format("and {} more: make the window larger", count), "", false, false};
}

}  // namespace

void SidePanels::show(SidePanel panel) {
  const auto same = [&](const SidePanel& other) { return other.name == panel.name; };
  const auto before = std::find_if(panels_.begin(), panels_.end(), same);
  if (before != panels_.end()) {
    *before = std::move(panel);
  } else {
    panels_.push_back(std::move(panel));
  }
}

void SidePanels::hide(const std::string& name) {
  std::erase_if(panels_, [&](const SidePanel& panel) { return panel.name == name; });
}

bool SidePanels::shows(const std::string& name) const {
  return std::any_of(panels_.begin(), panels_.end(),
                     [&](const SidePanel& panel) { return panel.name == name; });
}

std::vector<Box> SidePanels::boxes(const Layout& layout) const {
  const double em = layout.em, width = std::min(panel_width_em * em, layout.scene.width - 1.4 * em);
  std::vector<Box> boxes;
  constexpr std::size_t fewest_lines = 2;  // of a panel that is cut: a row, and how many more there are
  const double foot = layout.scene.bottom + axes_foot_em * em;  // below stand the axes and the scale
  double top = layout.scene.top() - panel_gap_em * em;
  for (const SidePanel& panel : panels_) {
    const std::size_t lines = std::min(panel.rows.size(), panel_lines_in(top - foot, em));
    if (lines < std::min(panel.rows.size(), fewest_lines)) {
      boxes.push_back({});
      continue;
    }
    const double height = height_of(lines, em);
    boxes.push_back({layout.scene.right() - panel_gap_em * em - width, top - height, width, height});
    top -= height + panel_gap_em * em;
  }
  return boxes;
}

void SidePanels::paint(Drawing& drawing, const Layout& layout) const {
  const double em = layout.em;
  const std::vector<Box> places = boxes(layout);
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const Box& box = places[i];
    if (box.width == 0) continue;
    drawing.box(box, Colour{255, 255, 255, 0.94});
    drawing.frame(box, {colours::grey, 1});
    drawing.text({box.left + 0.7 * em, box.top() - head_em * em / 2},
                 fitted(panels_[i].title, em, true, box.width - 1.4 * em),
                 {.size = em, .upright = Upright::middle, .bold = true});
    const std::size_t shown = panel_rows_shown(panels_[i], box, em), more = counted_from(panels_[i], shown);
    for (std::size_t k = 0; k < shown + (more > 0 ? 1 : 0); ++k) {
      const PanelRow row = k < shown ? panels_[i].rows[k] : more_rows(more);
      const Box at = row_box(box, k, em);
      if (row.kind == PanelRow::Kind::check) {
        paint_check(drawing, row, at, em);
      } else if (row.kind == PanelRow::Kind::value) {
        paint_value(drawing, row, at, em);
      } else {
        drawing.text({at.left + 0.7 * em, at.centre().y()},
                     fitted(row.label, 0.85 * em, false, at.width - 1.4 * em),
                     {.size = 0.85 * em, .colour = colours::grey, .upright = Upright::middle});
      }
    }
  }
}

std::optional<PanelHit> SidePanels::hit(const Layout& layout, double x, double y) const {
  const std::vector<Box> places = boxes(layout);
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    if (!places[i].holds(x, y)) continue;
    PanelHit hit{panels_[i].name};
    for (std::size_t k = 0; k < panel_rows_shown(panels_[i], places[i], layout.em); ++k) {
      const Box row = row_box(places[i], k, layout.em);
      if (!row.holds(x, y)) continue;
      hit.row = static_cast<int>(k);
      if (button(row, false, layout.em).holds(x, y)) hit.steps = -1;
      if (button(row, true, layout.em).holds(x, y)) hit.steps = 1;
    }
    return hit;
  }
  return std::nullopt;
}

}  // namespace fingerpad
