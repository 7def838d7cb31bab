#include <cmath>
#include <numbers>

#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "fuzz/entries.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/promise.hpp"
#include "part/import.hpp"

namespace fingerpad::test {
namespace {

/// What a touch asks of a surface point, whatever the mesh.
void ask(const TriangleTree& tree, const Vec3& p_P) {
  const double size = tree.part().size_m();
  const double whole_reach = std::numeric_limits<double>::infinity();
  const SurfacePoint near = nearest_surface_point(tree, p_P, Normals::smooth, -1, whole_reach);
  promise(near.triangle >= 0 && near.triangle < tree.part().triangle_count(), "a triangle is closest");
  promise(std::isfinite(near.signed_distance_m), "its distance is finite");
  promise(near.point_P.allFinite(), "its point is finite");
  promise(std::abs(near.normal_P.norm() - 1) < 1e-9, "its normal is a unit");
  promise(std::abs(near.pseudonormal_P.norm() - 1) < 1e-9, "its pseudonormal is a unit");
  // 1e-9: the point is rounded in frame P, whose origin may be a billion sizes away.
  const double apart = (p_P - near.point_P).norm(), far = p_P.cwiseAbs().maxCoeff();
  promise(std::abs(apart - std::abs(near.signed_distance_m)) <= 1e-9 * (size + far),
          "the distance is that to the point");
}

void touch(const std::shared_ptr<const Part>& part) {
  const TriangleTree tree(part);
  const Bounds bounds = bounds_P(*part);
  const double size = part->size_m();
  for (const double along : {-0.5, 0.1, 0.5, 1.5}) {
    ask(tree, (1 - along) * bounds.min + along * bounds.max);
  }
  const int step = std::max(1, part->triangle_count() / 8);
  for (int t = 0; t < part->triangle_count(); t += step) {
    Vec3 middle = part->centre_P;
    for (int k = 0; k < 3; ++k) middle += part->vertices.col(part->triangles(k, t)) / 3;
    ask(tree, middle);
    ask(tree, middle + 1e-3 * size * part->facet_normals.col(t));
    ask(tree, part->centre_P + part->vertices.col(part->triangles(0, t)));
  }
}

}  // namespace

void fuzz_mesh(std::string_view bytes, std::string_view ending) {
  const InputFile file(bytes, ending);
  for (const bool repair : {false, true}) {
    ImportOptions options;
    options.repair = repair;
    const ImportedPart imported = import_part(file.path(), options);
    const Verdict& verdict = imported.verdict;
    promise(verdict.touchable == (imported.part != nullptr), "a touchable mesh has a part");
    promise(verdict.touchable == verdict.error.empty(), "a refusal says why");
    promise(!verdict_text(verdict).empty(), "a verdict is told");
    if (imported.part) touch(imported.part);
  }
}

}  // namespace fingerpad::test
