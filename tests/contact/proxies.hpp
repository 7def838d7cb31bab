#pragma once

#include <gtest/gtest.h>

#include "contact/fast_proxy.hpp"

namespace fingerpad {

inline Proxy plain_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
  return Proxy(std::move(surfaces), radius_m, normals);
}

/// As callers have it: it remembers, and a tick's looks are limited.
inline Proxy usual_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
  return fast_proxy(std::move(surfaces), radius_m, normals);
}

/// With what a test shall hold: the proxy alone, and the one that remembers.
struct ProxyKind {
  const char* name;
  Proxy (*make)(std::vector<PlacedSurface>, double radius_m, Normals);
};

class EitherProxy : public testing::TestWithParam<ProxyKind> {
 protected:
  static Proxy make_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
    return GetParam().make(std::move(surfaces), radius_m, normals);
  }
};

inline const ProxyKind proxy_kinds[] = {{"Plain", plain_proxy}, {"Fast", usual_proxy}};

/// Where the centre of the ball without its skin is shown to a finger there.
inline Vec3 shown_place_W(const ProxyContact& contact, const Vec3& p_WQ) {
  return p_WQ + contact.depth_m * contact.direction_W;
}

inline std::string kind_name(const testing::TestParamInfo<ProxyKind>& info) {
  return info.param.name;
}

inline PlacedSurface surface_of(const TriangleSoup& soup) {
  PlacedSurface surface;
  surface.tree = std::make_shared<const TriangleTree>(std::make_shared<const Part>(make_part(soup, 0.5)));
  return surface;
}

inline PlacedSurface plane_of(const Vec3& point, const Vec3& normal) {
  PlacedSurface surface;
  surface.plane_point_W = point;
  surface.plane_normal_W = normal.normalized();
  return surface;
}

}  // namespace fingerpad
