#include "motion/proxy_trial.hpp"

#include <algorithm>

#include "contact/proxy.hpp"

namespace fingerpad {

double deepest_press_m(const TriangleTree& tree, const std::vector<Vec3>& centres_P, double radius_m) {
  constexpr double tick_s = 1e-3;            // a finger that moves is let go by the way it goes, not by time
  const std::shared_ptr<const void> nobody;  // the caller keeps the tree
  PlacedSurface surface;
  surface.tree = std::shared_ptr<const TriangleTree>(nobody, &tree);
  surface.part = std::shared_ptr<const Part>(nobody, &tree.part());
  Proxy proxy = fast_proxy({surface}, radius_m, Normals::facet);
  double deepest_m = 0;
  for (const Vec3& centre_P : centres_P) {
    const ProxyContact& contact = proxy.move(centre_P, tick_s);
    if (contact.touching) deepest_m = std::max(deepest_m, contact.depth_m);
  }
  return deepest_m;
}

}  // namespace fingerpad
