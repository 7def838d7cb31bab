#include "fingerpad/part_surface.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <numbers>

#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "base/unit.hpp"
#include "contact/closest_memory.hpp"
#include "contact/surface_point.hpp"
#include "part/import.hpp"
#include "public/part_surface_impl.hpp"

namespace fingerpad {
namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

double crease_rad(const std::string& where, double crease_deg) {
  if (!(crease_deg >= 0 && crease_deg <= 180))
    throw refused(where, fmt::format("crease_deg is {}; it must be within 0 and 180", crease_deg));
  return crease_deg * std::numbers::pi / 180;
}

double metres_in(const std::string& where, const std::string& unit) {
  if (const auto metres = metres_per_unit(unit)) return *metres;
  throw refused(where,
                fmt::format("unknown unit '{}' (known: {})", unit, fmt::join(length_unit_names(), ", ")));
}

void refuse_bad_triangles(const Points& vertices_m, const IndexTriples& triangles) {
  const std::string where = "triangles";
  if (triangles.cols() == 0) throw refused(where, "there are none");
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = triangles(k, t);
      if (v < 0 || v >= vertices_m.cols())
        throw refused(where, fmt::format("triangle {} names vertex {} of {}", t, v, vertices_m.cols()));
      if (!vertices_m.col(v).allFinite())
        throw refused(where, fmt::format("vertex {} has a coordinate that is not finite", v));
    }
  }
}

/// @returns in the part's frame, with the triangle's number in the file
ClosestPoint told(const SurfacePoint& near, const Part& part) noexcept {
  ClosestPoint closest;
  closest.signed_distance_m = near.signed_distance_m;
  if (near.triangle < 0) return closest;
  closest.point_m = near.point_P;
  closest.normal = near.pseudonormal_P;
  closest.triangle = part.file_triangle[static_cast<std::size_t>(near.triangle)];
  return closest;
}

}  // namespace

PartSurface::PartSurface(const std::string& mesh_path, const MeshOptions& options) {
  ImportOptions how;
  how.metres_per_unit = metres_in(mesh_path, options.unit);
  how.crease_rad = crease_rad(mesh_path, options.crease_deg);
  how.repair = options.repair;
  ImportedPart imported = import_touchable(mesh_path, how);
  auto impl = std::make_shared<Impl>();
  impl->part = std::move(imported.part);
  impl->verdict = std::move(imported.verdict);
  impl->hash = file_hash(mesh_path);
  impl->tree = std::make_shared<TriangleTree>(impl->part);
  impl_ = std::move(impl);
}

PartSurface::PartSurface(const Points& vertices_m, const IndexTriples& triangles, double crease_deg) {
  refuse_bad_triangles(vertices_m, triangles);
  auto impl = std::make_shared<Impl>();
  auto part =
      std::make_shared<Part>(make_part({vertices_m, triangles, {}}, crease_rad("triangles", crease_deg)));
  if (part->triangle_count() == 0) throw refused("triangles", "none has an area");
  impl->part = std::move(part);
  impl->verdict.touchable = true;
  impl->verdict.bounds_m = bounds_P(*impl->part);
  impl->tree = std::make_shared<TriangleTree>(impl->part);
  impl_ = std::move(impl);
}

ClosestPoint PartSurface::closest(const Vec3& p_m) const noexcept {
  return told(nearest_surface_point(*impl_->tree, p_m, Normals::facet, -1, anywhere), *impl_->part);
}

const std::vector<std::string>& PartSurface::warnings() const noexcept {
  return impl_->verdict.warnings;
}

int PartSurface::triangle_count() const noexcept {
  return impl_->part->triangle_count();
}

Vec3 PartSurface::lower_corner_m() const noexcept {
  return bounds_P(*impl_->part).min;
}

Vec3 PartSurface::upper_corner_m() const noexcept {
  return bounds_P(*impl_->part).max;
}

struct ClosestPointPath::Impl {
  PartSurface part;
  ClosestMemory memory;
};

ClosestPointPath::ClosestPointPath(PartSurface part)
    : impl_(std::make_unique<Impl>(Impl{std::move(part), {}})) {}
ClosestPointPath::~ClosestPointPath() = default;
ClosestPointPath::ClosestPointPath(ClosestPointPath&&) noexcept = default;
ClosestPointPath& ClosestPointPath::operator=(ClosestPointPath&&) noexcept = default;

ClosestPoint ClosestPointPath::closest(const Vec3& p_m) noexcept {
  const PartSurface::Impl& part = *impl_->part.impl_;
  return told(nearest_surface_point(*part.tree, p_m, Normals::facet, impl_->memory, anywhere), *part.part);
}

}  // namespace fingerpad
