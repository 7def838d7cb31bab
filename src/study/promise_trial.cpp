#include "study/promise_trial.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/contact_method_table.hpp"
#include "contact/edge_measures.hpp"
#include "contact/reckoned_error.hpp"
#include "contact/surface_places.hpp"
#include "study/contact_runs.hpp"
#include "touch/contact_case.hpp"

namespace fingerpad {
namespace {

constexpr unsigned trial_seed = 12;
constexpr int anywhere = -1;
/// Of a part's longest side, an eighth of which is a region: strokes go about in short legs, so that they
/// cover it evenly, as reckoning does.
constexpr double leg_share = 1.0 / 64;
constexpr int legs = 8;
/// So quick that most ticks are along the surface, not where strokes come down.
constexpr double down_m_per_s = 0.25;

/// Where each way to touch is reckoned to be at its worst, and, since what cannot be reached is no trial,
/// where the next worst is.
std::set<int> worst_regions(const Surface& surface, const Press& press) {
  const std::vector<SurfacePlace> places = surface_places(*surface.tree, trusted_height_of(*surface.part));
  std::set<int> worst;
  for (const ContactVariant& variant : contact_variants()) {
    std::vector<RegionError> errors =
        region_errors(places, press, *find_contact_method(variant.method_name), variant.normals);
    std::stable_sort(errors.begin(), errors.end(), [](const RegionError& a, const RegionError& b) {
      return a.error.force_share > b.error.force_share;
    });
    for (std::size_t i = 0; i < std::min<std::size_t>(2, errors.size()); ++i) worst.insert(errors[i].region);
  }
  return worst;
}

}  // namespace

std::vector<JudgedCase> promise_trials(const JudgedCase& one) {
  std::vector<JudgedCase> trials;
  if (one.trial_strokes == 0) return trials;
  for (const Surface& surface : one.world->surfaces) {
    if (!surface.part) continue;
    const Press press{surface.properties.stiffness_n_per_m, one.scene.finger.radius_m,
                      one.scene.contact.greatest_force_n};
    std::set<int> regions = worst_regions(surface, press);
    regions.insert(anywhere);
    StrokePlan plan{one.trial_strokes, touch_scale(*surface.part), trial_seed};
    plan.longest_m = leg_share * 2 * surface.part->half_extent.maxCoeff();
    plan.legs = legs;
    plan.down_m_per_s = down_m_per_s;
    plan.starts_low = true;
    for (const int region : regions) {
      for (const StrokePress how_hard : {StrokePress::lightest, StrokePress::hard, StrokePress::greatest}) {
        plan.region = region;
        plan.press = how_hard;
        JudgedCase trial = one;
        trial.ways = strokes_over(surface, one.scene, plan);
        if (!trial.is_exact_all_over) trial.exact_force_n = {};
        if (!trial.ways.empty()) trials.push_back(std::move(trial));
      }
    }
  }
  return trials;
}

}  // namespace fingerpad
