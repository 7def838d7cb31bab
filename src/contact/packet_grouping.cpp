#include "contact/packet_grouping.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "contact/triangle_packet.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t width = packet_width;
/// So few triangles are split exactly, and on one thread.
constexpr std::size_t few = 8 * width, on_one_thread = 4096;
constexpr int bins = 16;

/// A triangle's box; its centre is taken twice, low + high.
struct Item {
  Eigen::Array3f low, high;
  std::int32_t triangle;

  float middle(int axis) const noexcept { return low[axis] + high[axis]; }
};

struct Box {
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array3f high = -low;

  void add(const Eigen::Array3f& other_low, const Eigen::Array3f& other_high) noexcept {
    low = low.min(other_low);
    high = high.max(other_high);
  }
  /// Half its surface; nothing for an empty box.
  float area() const noexcept {
    const Eigen::Array3f side = (high - low).max(0.0f);
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  }
};

float packets_of(std::size_t triangles) noexcept {
  const std::size_t packets = (triangles + width - 1) / width;
  return static_cast<float>(packets);
}

/// A total order along an axis, so that a split is the same whatever order the items came in.
void order_along(int axis, std::span<Item> items) {
  std::sort(items.begin(), items.end(), [axis](const Item& a, const Item& b) {
    const float at_a = a.middle(axis), at_b = b.middle(axis);
    return at_a != at_b ? at_a < at_b : a.triangle < b.triangle;
  });
}

struct Split {
  int axis = -1;
  std::size_t at = 0;  ///< so many items on the left
  float cost = std::numeric_limits<float>::infinity();
};

/// The best of all splits at multiples of eight.
Split exact_split(std::span<Item> items) {
  Split best;
  std::array<float, few> left_cost;
  int ordered = -1;
  for (int axis = 0; axis < 3; ++axis) {
    order_along(axis, items);
    ordered = axis;
    Box box;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i % width == 0) left_cost[i / width] = box.area() * packets_of(i);
      box.add(items[i].low, items[i].high);
    }
    box = {};
    for (std::size_t i = items.size(); i-- > width;) {
      box.add(items[i].low, items[i].high);
      if (i % width != 0) continue;
      const float cost = left_cost[i / width] + box.area() * packets_of(items.size() - i);
      if (cost < best.cost) best = {axis, i, cost};
    }
  }
  if (best.axis < 0) best = {0, (items.size() / 2 + width - 1) / width * width, 0};  // no finite cost
  if (best.axis != ordered) order_along(best.axis, items);
  return best;
}

/// The multiple of eight nearest to the best of the borders between bins along the axes.
Split binned_split(std::span<const Item> items) {
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity()), high = -low;
  for (const Item& item : items) {
    low = low.min(item.low + item.high);
    high = high.max(item.low + item.high);
  }
  const Eigen::Array3f per_bin = bins / (high - low);
  std::array<std::array<Box, bins>, 3> box;
  std::array<std::array<std::size_t, bins>, 3> count{};
  for (const Item& item : items) {
    const Eigen::Array3f place = (item.low + item.high - low) * per_bin;
    for (int axis = 0; axis < 3; ++axis) {
      // not a number where the box is flat: the first bin
      const int bin =
          place[axis] > 0 ? std::min(static_cast<int>(std::min(place[axis], 64.0f)), bins - 1) : 0;
      box[axis][bin].add(item.low, item.high);
      ++count[axis][bin];
    }
  }
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<float, bins> right_cost{};
    Box right;
    std::size_t n = 0;
    for (int b = bins - 1; b > 0; --b) {
      right.add(box[axis][b].low, box[axis][b].high);
      n += count[axis][b];
      right_cost[b] = right.area() * packets_of(n);
    }
    Box left;
    n = 0;
    for (int b = 1; b < bins; ++b) {
      left.add(box[axis][b - 1].low, box[axis][b - 1].high);
      n += count[axis][b - 1];
      if (n == 0 || n == items.size()) continue;
      const float cost = left.area() * packets_of(n) + right_cost[b];
      if (cost < best.cost) best = {axis, n, cost};
    }
  }
  if (best.axis < 0) best = {0, items.size() / 2, 0};  // all in one place
  best.at = std::clamp((best.at + width / 2) / width * width, width, (items.size() - 1) / width * width);
  return best;
}

void group(std::span<Item> items) {
  if (items.size() <= width) return;
  Split split;
  if (items.size() <= few) {
    split = exact_split(items);
  } else {
    split = binned_split(items);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(split.at), items.end(),
                     [axis = split.axis](const Item& a, const Item& b) {
                       const float at_a = a.middle(axis), at_b = b.middle(axis);
                       return at_a != at_b ? at_a < at_b : a.triangle < b.triangle;
                     });
  }
  const auto left = items.first(split.at), right = items.subspan(split.at);
  if (items.size() <= on_one_thread) {
    group(left);
    group(right);
  } else {
    tbb::parallel_invoke([&] { group(left); }, [&] { group(right); });
  }
}

}  // namespace

std::vector<std::int32_t> packet_order(const Part& part) {
  const auto count = static_cast<std::size_t>(part.triangle_count());
  std::vector<Item> items(count);
  // Scaled, so that areas of the largest and smallest parts are numbers a float can hold.
  const double extent = part.half_extent.maxCoeff(), scale = extent > 0 ? 1 / extent : 1;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t t) {
    Item& item = items[t];
    item.triangle = static_cast<std::int32_t>(t);
    const auto corner = [&](int k) {
      return (part.vertices.col(part.triangles(k, item.triangle)) * scale).cast<float>().array().eval();
    };
    const Eigen::Array3f a = corner(0), b = corner(1), c = corner(2);
    item.low = a.min(b).min(c);
    item.high = a.max(b).max(c);
  });
  group(items);
  std::vector<std::int32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = items[i].triangle;
  for (std::size_t i = 0; i < count; i += width) {
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(i),
              order.begin() + static_cast<std::ptrdiff_t>(std::min(i + width, count)));
  }
  return order;
}

}  // namespace fingerpad
