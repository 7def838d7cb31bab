#include "view/parts_panel_vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace fingerpad {
namespace {

constexpr const char* parts_panel = "parts";

}  // namespace

bool PartsPanel::owns(const PanelHit& hit) {
  return hit.panel == parts_panel;
}

void PartsPanel::toggle() {
  panels_.shows(parts_panel) ? panels_.hide(parts_panel) : show();
}

void PartsPanel::click(const PanelHit& hit) {
  const auto row = static_cast<std::size_t>(hit.row);
  if (hit.row < 0 || row >= world_->surfaces.size()) return;
  props_.show_surface(row, !props_.is_shown(row));
  show();
}

void PartsPanel::show() {
  if (!world_) return panels_.hide(parts_panel);
  SidePanel panel{parts_panel, "parts", {}};
  constexpr std::size_t most_rows = 24;  // that a window has room for
  const std::size_t count = world_->surfaces.size();
  for (std::size_t i = 0; i < std::min(count, most_rows); ++i) {
    panel.rows.push_back({PanelRow::Kind::check, fmt::format("{}  {}", i, shown_name(world_->surfaces[i])),
                          "", props_.is_shown(i), false});
  }
  panel.rows.push_back({PanelRow::Kind::note,
                        count > most_rows ? fmt::format("and {} more, not listed", count - most_rows)
                                          : "hidden parts are felt all the same",
                        "", false, false});
  panels_.show(std::move(panel));
}

}  // namespace fingerpad
