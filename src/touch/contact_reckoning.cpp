#include "touch/contact_reckoning.hpp"

#include <algorithm>

#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

ContactReckoning::ContactReckoning(std::span<const Surface> surfaces, std::span<const PartMeasures> measures)
    : surfaces_(surfaces), measures_(measures) {
  same_as_.reserve(measures.size());
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const auto same = std::find_if(surfaces.begin(), surfaces.end(),
                                   [&](const Surface& surface) { return surface.part == surfaces[i].part; });
    same_as_.push_back(static_cast<std::size_t>(same - surfaces.begin()));
  }
}

const CrowdedHollow& ContactReckoning::crowded_in(std::size_t i, double radius_m) {
  const auto [at, is_new] = crowded_.try_emplace({same_as_[i], radius_m});
  if (is_new) at->second = most_crowded_hollow(*surfaces_[i].tree, measures_[i].places, radius_m);
  return at->second;
}

ContactCase ContactReckoning::case_of(const Scene& scene, std::size_t i, int finer) {
  const double radius_m = scene.finger.radius_m;
  Nearby nearby{crowded_in(i, radius_m), has_neighbour(surfaces_, surfaces_[i], radius_m)};
  nearby.crowded.facets *= finer * finer;
  ContactCase one = contact_case(scene, surfaces_[i], measures_[same_as_[i]], nearby);
  one.finer = finer;
  return one;
}

ContactVerdict ContactReckoning::on_all(const Scene& scene, int finer) {
  std::vector<ContactCase> cases;
  cases.reserve(measures_.size());
  for (std::size_t i = 0; i < measures_.size(); ++i) cases.push_back(case_of(scene, i, finer));
  return reckon_verdict(scene, surfaces_, std::move(cases), errors_);
}

ContactVerdict ContactReckoning::on_one(const Scene& scene, std::size_t i, int finer) {
  return reckon_verdict(scene, surfaces_, {case_of(scene, i, finer)}, errors_);
}

}  // namespace fingerpad
