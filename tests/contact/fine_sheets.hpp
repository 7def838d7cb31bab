#pragma once

#include <algorithm>
#include <vector>

#include "contact/proxies.hpp"
#include "support/shapes.hpp"

// Fine sheets, and how far a proxy is off closed forms along a path over them.

namespace fingerpad::test {

inline Vec3 push_of(const ProxyContact& contact) {
  return contact.touching() ? Vec3(contact.depth_m * contact.normal_W) : Vec3::Zero();
}

struct Worst {
  double push = 0;      ///< how far the push was off, as a share of the depth
  int unsettled = 0;    ///< ticks after the first ones
  long most_looks = 0;  ///< of a tick
};

/// @param path  depth_m deep all along, but for its first places, which are not judged
/// @param push  the true one at a place of it
template <class Push>
Worst worst_along(const TriangleSoup& soup, double radius_m, double dt_s, const std::vector<Vec3>& path,
                  double depth_m, Push push, std::size_t first = 5) {
  Proxy proxy = fast_proxy({surface_of(soup)}, radius_m, Normals::facet);
  Worst worst;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const ProxyContact& c = proxy.move(path[k], dt_s);
    worst.most_looks = std::max(worst.most_looks, proxy.looks().spent());
    if (k < first) continue;
    worst.unsettled += c.settled ? 0 : 1;
    worst.push = std::max(worst.push, (push_of(c) - push(path[k])).norm() / depth_m);
  }
  return worst;
}

}  // namespace fingerpad::test
