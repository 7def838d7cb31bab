#include "contact/normals.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The facet's own normal, over its edges too.
extern constinit const NormalsEntry normals_face{
    "face", "each facet's own normal, to its very edge", nullptr,
    [](const TriangleTree& tree, int t, const TrianglePoint&, const Vec3&) noexcept {
      return Vec3(tree.part().facet_normals.col(t));
    },
    nullptr};

}  // namespace fingerpad
