#include "motion/proxy_trial.hpp"

#include <memory>

#include "contact/fast_proxy.hpp"
#include "motion/finger_path.hpp"

namespace fingerpad {

bool presses_deeper(const TriangleTree& tree, const FingerPath& path, double radius_m, double limit_m) {
  const std::shared_ptr<const void> nobody;  // the caller keeps the tree
  PlacedSurface surface;
  surface.tree = std::shared_ptr<const TriangleTree>(nobody, &tree);
  surface.part = std::shared_ptr<const Part>(nobody, &tree.part());
  Proxy proxy = fast_proxy({surface}, radius_m, Normals::facet);
  for (long k = 0; k < path.tick_count(); ++k) {
    const ProxyContact& contact = proxy.move(path.at(k).p_WQ, 1 / path.rate_hz());
    if (contact.touching() && contact.depth_m > limit_m) return true;
  }
  return false;
}

}  // namespace fingerpad
