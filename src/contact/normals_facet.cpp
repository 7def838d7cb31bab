#include "contact/normals.hpp"
#include "contact/normals_words.hpp"
#include "contact/part_measures.hpp"

namespace fingerpad {
namespace {

/// Good enough for every part that no other kind is needed for.
std::string why_facet(const NormalsDemand& demand) {
  return demand.part.largest_smooth_turn_rad == 0 ? "its faces are flat"
                                                  : turn_text(demand.part) + " and no more";
}

}  // namespace

/// The gradient of the distance to the facets as they are: the facet's own normal over a face; over a convex
/// edge or vertex the direction from the surface point to the finger.
constinit const NormalsEntry normals_facet{"facet", "the mesh's own facets", why_facet, nullptr, nullptr};

}  // namespace fingerpad
