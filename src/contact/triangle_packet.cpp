#include "contact/triangle_packet.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fingerpad {
namespace {

/// A triangle lower than this fraction of its longest side has no rough frame: its plane, known in double to
/// some 1e-16 of that side, would turn by more than a float can tell.
constexpr double least_height = 1e-6;

float up(double x) noexcept {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

void set(std::array<TrianglePacket::Lanes, 3>& lanes, std::size_t lane, const Vec3& v) noexcept {
  for (int i = 0; i < 3; ++i) lanes[i][lane] = static_cast<float>(v[i]);
}

void set_half(TrianglePacket::Half& half, std::size_t lane, double width, double height) noexcept {
  const double hypotenuse = std::hypot(width, height);
  half.width[lane] = static_cast<float>(width);
  half.normal_x[lane] = static_cast<float>(height / hypotenuse);
  half.normal_y[lane] = static_cast<float>(width / hypotenuse);
  half.hypotenuse[lane] = static_cast<float>(hypotenuse);
}

/// Leaves the lane far off: x along nothing, so that its distance is that of its origin.
void set_far_off(TrianglePacket& packet, std::size_t lane) noexcept {
  set(packet.foot, lane, Vec3(far_off, 0, 0));
  set(packet.x_axis, lane, Vec3::Zero());
  set(packet.y_axis, lane, Vec3::Zero());
  set(packet.z_axis, lane, Vec3::UnitX());
  for (TrianglePacket::Half& half : packet.half) set_half(half, lane, 0, 1);
}

/// Prepares a lane's rough frame from corners relative to the packet's origin. False if it can have none.
bool set_rough_frame(TrianglePacket& packet, std::size_t lane, const std::array<Vec3, 3>& corner) noexcept {
  int longest = 0;
  double length = 0;
  for (int k = 0; k < 3; ++k) {
    const double side = (corner[(k + 1) % 3] - corner[k]).stableNorm();
    if (side > length) {
      length = side;
      longest = k;
    }
  }
  if (!(length > 0)) return false;
  const Vec3& base = corner[longest];
  const Vec3 x_axis = (corner[(longest + 1) % 3] - base) / length;
  const Vec3 apex = corner[(longest + 2) % 3] - base;
  const double along = std::clamp(apex.dot(x_axis), 0.0, length);
  Vec3 across = apex - along * x_axis;
  across -= across.dot(x_axis) * x_axis;
  const double height = across.stableNorm();
  if (!(height >= least_height * length)) return false;
  const Vec3 y_axis = across / height;
  set(packet.foot, lane, base + along * x_axis);
  set(packet.x_axis, lane, x_axis);
  set(packet.y_axis, lane, y_axis);
  set(packet.z_axis, lane, x_axis.cross(y_axis));
  set_half(packet.half[0], lane, length - along, height);
  set_half(packet.half[1], lane, along, height);
  return true;
}

/// Says how flat it is.
void set_thickness(TrianglePacket& packet, const Part& part, double scale) noexcept {
  Vec3 sum = Vec3::Zero();
  const auto each = [&packet](auto visit) {
    for (std::size_t lane = 0; lane < packet_width; ++lane) {
      if ((packet.used >> lane & 1) != 0) visit(packet.exact[lane]);
    }
  };
  // A frame's normal points to either side.
  each([&sum](const TrianglePacket::Exact& exact) {
    sum += sum.dot(exact.normal) < 0 ? Vec3(-exact.normal) : exact.normal;
  });
  const double length = sum.norm();
  const Vec3 unit = length > 1e-3 ? Vec3(sum / length) : Vec3::UnitZ();
  for (int i = 0; i < 3; ++i) packet.across[i] = static_cast<float>(unit[i]);
  const Vec3 across(packet.across[0], packet.across[1], packet.across[2]);
  double farthest = 0;
  each([&](const TrianglePacket::Exact& exact) {
    for (const std::int32_t vertex : exact.vertex)
      farthest = std::max(farthest, std::abs(across.dot(part.vertices.col(vertex) * scale - packet.origin)));
  });
  const double share = farthest / std::max(static_cast<double>(packet.radius), 1e-300);
  packet.thickness = static_cast<std::uint16_t>(std::min(65535.0, std::ceil(65535 * share * (1 + 1e-9)) + 1));
}

}  // namespace

PacketDisc disc_around(const Part& part, const TrianglePacket& packet, double scale) noexcept {
  PacketDisc disc{};
  const Vec3 across(packet.across[0], packet.across[1], packet.across[2]);
  const auto each_corner = [&](auto visit) {
    for (std::size_t lane = 0; lane < packet_width; ++lane) {
      if ((packet.used >> lane & 1) == 0) continue;
      for (const std::int32_t vertex : packet.exact[lane].vertex)
        visit(Vec3(part.vertices.col(vertex) * scale));
    }
  };
  double low = std::numeric_limits<double>::infinity(), high = -low;
  each_corner([&](const Vec3& corner) {
    const double height = across.dot(corner - packet.origin);
    low = std::min(low, height);
    high = std::max(high, height);
  });
  const Vec3 middle = packet.origin + (low + high) / 2 * across;
  double radius2 = 0, thick = 0;
  each_corner([&](const Vec3& corner) {
    const Vec3 off = corner - middle;
    const double height = across.dot(off);
    thick = std::max(thick, std::abs(height));
    radius2 = std::max(radius2, off.squaredNorm() - height * height * (1 - 1e-6));
  });
  // The centre is rounded by no more. (What it is rounded to is not asked: g++ 12 leaves out the way to float
  // and back where it takes two coordinates at once.)
  const double rounding = 0x1p-24 * middle.norm();
  for (int i = 0; i < 3; ++i) {
    disc.across[i] = packet.across[i];
    disc.centre[i] = static_cast<float>(middle[i]);
  }
  disc.radius = up((std::sqrt(radius2) + rounding) * (1 + 1e-6));
  disc.thick = up((thick + rounding) * (1 + 1e-6) + 1e-15);
  return disc;
}

TrianglePacket make_packet(const Part& part, std::span<const std::int32_t> triangles, double scale) noexcept {
  TrianglePacket packet{};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinite), high = -low;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    TrianglePacket::Exact& exact = packet.exact[lane];
    exact.triangle = triangles[lane];
    const auto order = corner_order(part, exact.triangle);
    packet.order[lane] = static_cast<std::uint8_t>(order[0] | order[1] << 2 | order[2] << 4);
    for (int k = 0; k < 3; ++k) {
      exact.vertex[k] = part.triangles(order[k], exact.triangle);
      const Vec3 corner = part.vertices.col(exact.vertex[k]) * scale;
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    packet.used = static_cast<std::uint8_t>(packet.used | 1 << lane);
  }
  packet.origin = (low + high) / 2;
  double radius = 0;
  for (std::size_t lane = 0; lane < packet_width; ++lane) {
    set_far_off(packet, lane);
    if (lane >= triangles.size()) continue;
    const TriangleFrame frame = exact_frame(part, packet, static_cast<int>(lane));
    packet.exact[lane].normal = frame_normal(frame.corner);
    std::array<Vec3, 3> corner;
    for (int k = 0; k < 3; ++k) {
      corner[k] = frame.corner[k] * scale - packet.origin;
      radius = std::max(radius, corner[k].norm());
    }
    if (!set_rough_frame(packet, lane, corner)) {
      packet.always_exact = static_cast<std::uint8_t>(packet.always_exact | 1 << lane);
    }
  }
  packet.radius = up(radius);
  for (int i = 0; i < 3; ++i)
    packet.box_half[i] = up(std::max(high[i] - packet.origin[i], packet.origin[i] - low[i]));
  set_thickness(packet, part, scale);
  return packet;
}

}  // namespace fingerpad
