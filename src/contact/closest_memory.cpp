#include "contact/closest_memory.hpp"

#include <algorithm>
#include <cmath>

#include "contact/closest_search.hpp"
#include "contact/tree_parts.hpp"

namespace fingerpad {
namespace {

/// A list is made for so many steps of the path, and not where it would serve fewer than `least_steps`.
constexpr double steps_ahead = 200, least_steps = 12;
/// In radii of the packet that holds the closest triangle: how far a list reaches at least and at most.
constexpr double least_reach = 1, greatest_reach = 6;
/// Queries without a list after one that did not pay.
constexpr int pause_queries = 64;
/// Rounding of a distance between two points, in sizes of the part.
constexpr double distance_rounding = 1e-12;

}  // namespace

/// Lists the packets within a radius, or the nearest of them.
struct PacketGathering {
  const PackedPart& packed;
  ClosestMemory& memory;
  float point[3];  ///< scaled
  float radius;    ///< scaled: what is farther need not be listed
  std::array<float, ClosestMemory::most> squared{};
  int farthest = 0;

  PacketGathering(const PackedPart& part, ClosestMemory& into, const float* at, float within) noexcept
      : packed(part), memory(into), point{at[0], at[1], at[2]}, radius(within) {
    memory.count_ = 0;
    for (PacketBoxes& boxes : memory.boxes_) {
      for (auto& lanes : boxes.centre) lanes.fill(far_off);
      for (auto& lanes : boxes.half) lanes.fill(0);
    }
  }

  void list(std::uint32_t index) noexcept {
    const TrianglePacket& packet = packed.packets[index];
    float centre[3], half[3], distance2 = 0;
    for (int i = 0; i < 3; ++i) {
      centre[i] = static_cast<float>(packet.origin[i]);
      half[i] = packet.box_half[i] + box_padding;
      const float beyond = std::max(0.0f, std::abs(point[i] - centre[i]) - half[i]);
      distance2 += beyond * beyond;
    }
    int place = memory.count_;
    if (place == ClosestMemory::most) {
      radius = std::min(radius, std::sqrt(std::max(distance2, squared[static_cast<std::size_t>(farthest)])));
      if (distance2 >= squared[static_cast<std::size_t>(farthest)]) return;
      place = farthest;
    } else {
      ++memory.count_;
    }
    const auto at = static_cast<std::size_t>(place);
    squared[at] = distance2;
    memory.packet_[at] = index;
    PacketBoxes& boxes = memory.boxes_[at / packet_width];
    for (int i = 0; i < 3; ++i) {
      boxes.centre[i][at % packet_width] = centre[i];
      boxes.half[i][at % packet_width] = half[i];
    }
    if (memory.count_ == ClosestMemory::most)
      farthest = static_cast<int>(std::max_element(squared.begin(), squared.end()) - squared.begin());
  }
};

namespace {

float visit_to_list(void* any_gathering, unsigned index, float) noexcept {
  PacketGathering& gathering = *static_cast<PacketGathering*>(any_gathering);
  gathering.list(index);
  return gathering.radius;
}

}  // namespace

/// Lists what stands around a point whose closest triangle is known, if that pays.
/// @param step_m    how far the path went since the last query
void TriangleTree::Impl::remember_packets(const ClosestSearch& search, double step_m,
                                          ClosestMemory& memory) const noexcept {
  const double within_m = std::sqrt(search.winner.at.distance2_m2);  // the reach where there is none
  const bool poor = memory.clear_m_ >= 0 && memory.served_ < least_steps;
  memory.forget_packets();
  if (poor) memory.pause_ = pause_queries;
  if (memory.pause_ > 0) {
    --memory.pause_;
    return;
  }
  double ahead_m = std::max(steps_ahead * step_m, within_m / 8);
  if (search.won_in != nullptr) {
    const double radius_m = static_cast<double>(search.won_in->radius) / packed.scale;
    ahead_m = std::clamp(steps_ahead * step_m, least_reach * radius_m, greatest_reach * radius_m);
  }
  if (!(ahead_m >= least_steps * step_m)) return;
  PacketGathering gathering(packed, memory, search.embree, search.radius(within_m + ahead_m));
  scene.each_near(search.embree, gathering.radius, visit_to_list, &gathering);
  const double clear =
      (static_cast<double>(gathering.radius) - absolute_slack) * (1 - 2 * relative_slack) - search.rounding;
  memory.clear_m_ = std::min(within_m + ahead_m, clear / packed.scale);
  memory.from_ = search.q;
  memory.served_ = 0;
}

/// Whether no packet that is not listed can hold a triangle as near as `distance_m`.
bool ClosestMemory::covers(const Vec3& q, double distance_m, double rounding_m) const noexcept {
  return clear_m_ - (q - from_).norm() > distance_m + rounding_m;
}

ClosestTriangle TriangleTree::closest(const Vec3& q, ClosestMemory& memory, double reach_m) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(farthest <= tree_range * packed.extent_m))
    return closest(q, -1, reach_m);
  if (impl.out_of_reach(farthest, reach_m)) return {};
  if (memory.tree_ != impl.number) {
    memory.forget();
    memory.tree_ = impl.number;
  }

  ClosestSearch search(packed, impl.filter, q, reach_m);
  if (memory.triangle_ >= 0) search.look_at_seed(memory.triangle_);
  const double step_m = (q - memory.last_).norm();
  memory.last_ = q;
  const double rounding_m = distance_rounding * (packed.extent_m + farthest);
  const double near_m = std::sqrt(search.winner.at.distance2_m2);
  if (memory.covers(q, near_m, rounding_m)) {
    ++memory.served_;
    const float radius = search.radius(near_m);
    const int groups = (memory.count_ + packet_width - 1) / packet_width;
    std::uint64_t near = impl.box_filter(memory.boxes_.data(), groups, search.embree, radius * radius);
    for (; near != 0; near &= near - 1) {
      const TrianglePacket& packet =
          packed.packets[memory.packet_[static_cast<std::size_t>(std::countr_zero(near))]];
      if (&packet != search.looked_at) search.look_at(packet);
    }
  } else {
    impl.search_tree(search, near_m);
    impl.remember_packets(search, step_m, memory);
  }
  ClosestTriangle found = search.answer();
  memory.triangle_ = found.triangle;
  return found;
}

}  // namespace fingerpad
