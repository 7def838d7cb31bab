#include "contact/normals.hpp"
#include "contact/surface_places.hpp"

namespace fingerpad {
namespace {

double facet_off_rad(const SurfacePlace& place) noexcept {
  return place.facet_rad + off_with_curved_rad(place);
}

}  // namespace

/// The gradient of the distance to the facets as they are: the facet's own normal over a face; over a convex
/// edge or vertex the direction from the surface point to the finger.
constinit const NormalsEntry normals_facet{
    .name = "facet", .summary = "the mesh's own facets", .off_rad = facet_off_rad};

}  // namespace fingerpad
