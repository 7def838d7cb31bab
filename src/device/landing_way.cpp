#include "device/landing_way.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

constexpr double most_behind = 2, hurried_aside = 4;

}  // namespace

bool LandingWay::meets_place(const LandingRoom& room) const noexcept {
  const double height_m = there_W.dot(down_W);
  const double behind = std::max(room.behind, most_behind * hurry);
  const double aside_m = (there_W - height_m * down_W).norm();
  return there_W.norm() < room.away * soft_m && height_m >= -behind * soft_m &&
         aside_m <= height_m + (room.aside + hurried_aside * hurry) * soft_m;
}

bool LandingWay::is_in_front() const noexcept {
  return there_W.dot(down_W) >= -most_behind * soft_m;
}

Vec3 LandingWay::unit_W() const noexcept {
  const double height_m = there_W.dot(down_W);
  const Vec3 aside_W = there_W - height_m * down_W;
  const double aside_m = aside_W.norm();
  const double over = std::max(0.0, 1 - aside_m / (0.05 * soft_m));
  const double down_m = std::max(0.0, height_m) + 2 * soft_m * std::max(over, hurry);
  const double steep = std::max(1 - hurry, std::min(1.0, down_m / std::max(aside_m, down_m)));
  return (down_m * down_W + steep * aside_W).normalized();
}

}  // namespace fingerpad
