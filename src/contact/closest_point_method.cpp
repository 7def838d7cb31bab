#include <algorithm>
#include <type_traits>

#include "contact/closest_memory.hpp"
#include "contact/closest_point_rule.hpp"
#include "contact/contact_method_table.hpp"
#include "contact/placed_surface.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

/// Each tick's deepest surface, at its nearest point to the finger: no tick knows of the last.
/// @tparam Hint  what a search starts from: a ClosestMemory or a BriefSearch
template <class Hint>
class ClosestPoint final : public ContactMethod {
 public:
  ClosestPoint(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals, const Hint& first)
      : surfaces_(std::move(surfaces)),
        radius_m_(radius_m),
        normals_(normals),
        first_(first),
        hints_(surfaces_.size(), first) {}

  const Contact& touch(const Vec3& p_WQ, double /*dt_s*/) noexcept override {
    contact_.hold_count = 0;
    contact_.depth_m = 0;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const WorldPoint at = nearest_point(surfaces_[i], p_WQ, normals_, hints_[i], radius_m_);
      const double depth_m = radius_m_ - at.signed_distance_m;
      if (!at.found || !(depth_m > contact_.depth_m)) continue;
      contact_.hold_count = 1;
      contact_.holds[0] = {static_cast<int>(i), at.triangle, at.point_W, at.normal_W, depth_m};
      contact_.depth_m = depth_m;
      contact_.point_W = at.point_W;
      contact_.normal_W = at.normal_W;
    }
    return contact_;
  }

  const ClosestMemory* memory_of(int surface) const noexcept override {
    if constexpr (std::is_same_v<Hint, ClosestMemory>) return &hints_[static_cast<std::size_t>(surface)];
    return nullptr;
  }

  void reset() noexcept override { std::fill(hints_.begin(), hints_.end(), first_); }

 private:
  std::vector<PlacedSurface> surfaces_;
  double radius_m_;
  Normals normals_;
  Hint first_;
  std::vector<Hint> hints_;  ///< per surface: what the next search starts from
  Contact contact_;
};

}  // namespace

std::unique_ptr<ContactMethod> brief_closest_point(std::vector<PlacedSurface> surfaces, double radius_m,
                                                   Normals normals, long most_looks) {
  return std::make_unique<ClosestPoint<BriefSearch>>(std::move(surfaces), radius_m, normals,
                                                     BriefSearch{most_looks});
}

ContactMethodEntry closest_point_method() noexcept {
  return {
      .name = "closest-point",
      .summary = "each tick's nearest surface point; it remembers nothing",
      .holds =
          "holds on closed thick parts; lets go beyond the middle of a wall, and feels one wall at a time",
      .touches_own_surface = true,
      .fails = closest_point_fails,
      .holds_here = closest_point_holds,
      .make = [](std::vector<PlacedSurface> surfaces, double radius_m,
                 Normals normals) -> std::unique_ptr<ContactMethod> {
        return std::make_unique<ClosestPoint<ClosestMemory>>(std::move(surfaces), radius_m, normals,
                                                             ClosestMemory{});
      }};
}

}  // namespace fingerpad
