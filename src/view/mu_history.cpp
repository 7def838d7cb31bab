#include "view/mu_history.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

bool changes_mu(const SceneChange& change) {
  return change.key.ends_with("mu_static") || change.key.ends_with("mu_dynamic");
}

}  // namespace

std::vector<MuFrom> mu_history(const ViewInput& input) {
  if (!input.world) return {};
  MuFrom mu{-HUGE_VAL, {}};
  for (const Surface& surface : input.world->surfaces)
    mu.surfaces.push_back({surface.properties.mu_static, surface.properties.mu_dynamic});
  std::vector<MuFrom> history = {mu};
  Scene scene = input.scene.value_or(Scene{});
  for (const SceneChange& change : input.changes) {
    if (!changes_mu(change)) continue;
    try {
      apply(change, scene);
    } catch (const Error&) {  // a trace of another program's: what it changed is not known
      return {};
    }
    mu.from_s = change.t_s;
    for (std::size_t k = 0; k < mu.surfaces.size(); ++k) {
      const int surface = static_cast<int>(k);
      if (change.key == surface_key(surface, "mu_static"))
        mu.surfaces[k].mu_static = surface_properties(scene, surface).mu_static;
      if (change.key == surface_key(surface, "mu_dynamic"))
        mu.surfaces[k].mu_dynamic = surface_properties(scene, surface).mu_dynamic;
    }
    history.push_back(mu);
  }
  return history;
}

std::vector<MuPair> mu_at_rows(std::span<const TickRecord> rows, std::span<const MuFrom> history) {
  if (history.empty()) return {};
  const auto touches = [](const TickRecord& row) { return row.surface >= 0; };
  const auto first = std::find_if(rows.begin(), rows.end(), touches);
  auto surface = static_cast<std::size_t>(first != rows.end() ? first->surface : 0);
  std::vector<MuPair> mu;
  std::size_t now = 0;
  for (const TickRecord& row : rows) {
    while (now + 1 < history.size() && history[now + 1].from_s <= row.t_s) ++now;
    if (touches(row)) surface = static_cast<std::size_t>(row.surface);
    const std::vector<MuPair>& surfaces = history[now].surfaces;
    mu.push_back(surface < surfaces.size() ? surfaces[surface] : MuPair{});
  }
  return mu;
}

}  // namespace fingerpad
