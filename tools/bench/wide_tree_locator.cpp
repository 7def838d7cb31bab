#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/closest_search.hpp"
#include "contact/packed_part.hpp"
#include "locator.hpp"

// A tree of eight boxes a node over the same packets as fingerpad's, searched by hand, to measure what it
// costs that Embree searches them. It keeps the last answer as its seed, and nothing else.
namespace fingerpad::bench {
namespace {

using Floats [[gnu::vector_size(32)]] = float;

struct Box {
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity()), high = -low;

  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  float area() const {
    const Eigen::Array3f side = high - low;
    return side.x() * side.y() + side.y() * side.z() + side.z() * side.x();
  }
};

/// Boxes side by side, scaled and padded.
struct alignas(32) PacketBoxes {
  std::array<TrianglePacket::Lanes, 3> centre, half;
};

struct alignas(32) Node {
  PacketBoxes boxes;
  std::array<std::int32_t, 8> child;  ///< a node; below zero: -1 - packet
};

/// Builds nodes over packets that already follow one another in space.
class Builder {
 public:
  explicit Builder(const PackedPart& packed) {
    for (const TrianglePacket& packet : packed.packets) {
      Box box;
      const Eigen::Array3f centre = packet.origin.cast<float>(), half(packet.box_half);
      box.low = centre - half - box_padding;
      box.high = centre + half + box_padding;
      boxes_.push_back(box);
    }
    if (!boxes_.empty()) build({0, boxes_.size()});
  }

  std::vector<Node> nodes;

 private:
  struct Range {
    std::size_t first, end;
  };

  Box box_of(const Range& range) const {
    return std::accumulate(boxes_.begin() + static_cast<long>(range.first),
                           boxes_.begin() + static_cast<long>(range.end), Box{}, [](Box sum, const Box& box) {
                             sum.add(box);
                             return sum;
                           });
  }

  /// Where the surface-area heuristic cuts a range.
  std::size_t best_cut(const Range& range) const {
    const std::size_t count = range.end - range.first;
    std::vector<float> after(count);
    Box box;
    for (std::size_t i = count; i-- > 1;) {
      box.add(boxes_[range.first + i]);
      after[i] = box.area() * static_cast<float>(count - i);
    }
    box = {};
    float best = std::numeric_limits<float>::infinity();
    std::size_t cut = count / 2;
    for (std::size_t i = 1; i < count; ++i) {
      box.add(boxes_[range.first + i - 1]);
      const float cost = box.area() * static_cast<float>(i) + after[i];
      if (cost < best) best = cost, cut = i;
    }
    return range.first + cut;
  }

  std::int32_t build(const Range& whole) {
    std::vector<Range> parts{whole};
    while (parts.size() < 8) {
      const auto wide = std::max_element(parts.begin(), parts.end(), [&](const Range& a, const Range& b) {
        const auto weight = [&](const Range& r) { return r.end - r.first > 1 ? box_of(r).area() : -1; };
        return weight(a) < weight(b);
      });
      if (wide->end - wide->first < 2) break;
      const std::size_t cut = best_cut(*wide);
      const Range second{cut, wide->end};
      wide->end = cut;
      parts.push_back(second);
    }
    const auto index = static_cast<std::int32_t>(nodes.size());
    nodes.emplace_back();
    for (std::size_t k = 0; k < 8; ++k) {
      Eigen::Array3f centre = Eigen::Array3f::Constant(far_off), half = Eigen::Array3f::Zero();
      std::int32_t child = -1;
      if (k < parts.size()) {
        const Box box = box_of(parts[k]);
        centre = (box.low + box.high) / 2;
        half = (box.high - box.low) / 2 + box_padding;
        const bool leaf = parts[k].end - parts[k].first == 1;
        child = leaf ? -1 - static_cast<std::int32_t>(parts[k].first) : build(parts[k]);
      }
      Node& node = nodes[static_cast<std::size_t>(index)];
      for (int i = 0; i < 3; ++i) node.boxes.centre[i][k] = centre[i], node.boxes.half[i][k] = half[i];
      node.child[k] = child;
    }
    return index;
  }

  std::vector<Box> boxes_;
};

#if defined(__x86_64__)
[[gnu::target_clones("avx2", "default")]]
#endif
unsigned
near_boxes(const PacketBoxes& boxes, const float* point, float radius2, float* squared) {
  const Floats zero = {};
  Floats sum = zero;
  for (int i = 0; i < 3; ++i) {
    const Floats centre = *reinterpret_cast<const Floats*>(boxes.centre[i].data());
    const Floats half = *reinterpret_cast<const Floats*>(boxes.half[i].data());
    const Floats from = point[i] - centre;
    Floats beyond = (from < zero ? -from : from) - half;
    beyond = beyond > zero ? beyond : zero;
    sum += beyond * beyond;
  }
  *reinterpret_cast<Floats*>(squared) = sum;
  unsigned near = 0;
  for (unsigned k = 0; k < 8; ++k) near |= static_cast<unsigned>(squared[k] <= radius2) << k;
  return near;
}

class WideTreeLocator : public Locator {
 public:
  explicit WideTreeLocator(std::shared_ptr<const Part> part)
      : packed_(pack(std::move(part))), nodes_(Builder(packed_).nodes) {}

  double distance2_m2(const Vec3& q) override {
    ClosestSearch search(packed_, filter_, q, std::numeric_limits<double>::infinity());
    if (last_ >= 0) search.look_at_seed(last_);
    struct Entry {
      float squared;
      std::int32_t node;
    };
    Entry stack[256];
    int height = 0;
    stack[height++] = {0, 0};
    float radius2 = square(search.radius(std::sqrt(search.winner.at.distance2_m2)));
    while (height > 0) {
      const Entry top = stack[--height];
      if (top.squared > radius2) continue;
      if (top.node < 0) {
        const TrianglePacket& packet = packed_.packets[static_cast<std::size_t>(-1 - top.node)];
        if (&packet != search.looked_at && search.look_at(packet))
          radius2 = square(search.radius(std::sqrt(search.winner.at.distance2_m2)));
        continue;
      }
      const Node& node = nodes_[static_cast<std::size_t>(top.node)];
      alignas(32) float squared[8];
      const int first = height;
      for (unsigned near = near_boxes(node.boxes, search.embree, radius2, squared); near != 0;
           near &= near - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(near));
        int at = height++;
        for (; at > first && stack[at - 1].squared < squared[k]; --at) stack[at] = stack[at - 1];
        stack[at] = {squared[k], node.child[k]};
      }
    }
    last_ = search.winner.triangle;
    return search.winner.at.distance2_m2;
  }

 private:
  static float square(float x) { return x * x; }

  PackedPart packed_;
  std::vector<Node> nodes_;
  PacketFilter filter_ = fastest_packet_filter();
  int last_ = -1;
};

}  // namespace

std::unique_ptr<Locator> make_wide_tree_locator(std::shared_ptr<const Part> part) {
  return std::make_unique<WideTreeLocator>(std::move(part));
}

}  // namespace fingerpad::bench
