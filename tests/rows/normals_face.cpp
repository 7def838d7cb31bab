#include "contact/normals.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The facet's own normal, over its edges too.
extern constinit const NormalsEntry normals_face{
    .name = "face",
    .summary = "each facet's own normal, to its very edge",
    .shade = [](const TriangleTree& tree, int t, const TrianglePoint&, const Vec3&) noexcept {
      return Vec3(tree.part().facet_normals.col(t));
    }};

}  // namespace fingerpad
