#include "contact/packet_grouping.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>
#include <span>

#include "contact/triangle_packet.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t width = packet_width;
/// So few triangles are split exactly, and on one thread.
constexpr std::size_t few = 8 * width, on_one_thread = 4096;
constexpr int bins = 16;

/// A triangle's box, a register of floats each; its centre is taken twice, low + high. The fourth of `low`
/// carries the triangle's number, in bits that are an ordinary float: subnormal ones would slow sums down.
struct Item {
  Eigen::Array4f low, high;

  static constexpr std::int32_t first_normal = 0x20000000;
  void name(std::int32_t triangle) noexcept {
    low[3] = std::bit_cast<float>(triangle + first_normal);
    high[3] = 0;
  }
  std::int32_t triangle() const noexcept { return std::bit_cast<std::int32_t>(low[3]) - first_normal; }
  float middle(int axis) const noexcept { return low[axis] + high[axis]; }
  Eigen::Array4f middle() const noexcept { return low + high; }
};

struct Box {
  Eigen::Array4f low = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array4f high = -low;

  void add(const Eigen::Array4f& other_low, const Eigen::Array4f& other_high) noexcept {
    low = low.min(other_low);
    high = high.max(other_high);
  }
  /// Half its surface; nothing for an empty box.
  float area() const noexcept {
    const Eigen::Array4f side = (high - low).max(0.0f);
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  }
};

float packets_of(std::size_t triangles) noexcept {
  const std::size_t packets = (triangles + width - 1) / width;
  return static_cast<float>(packets);
}

/// A total order along an axis, so that a split is the same whatever order the items came in.
struct Along {
  int axis;
  bool operator()(const Item& a, const Item& b) const noexcept {
    const float at_a = a.middle(axis), at_b = b.middle(axis);
    return at_a != at_b ? at_a < at_b : a.triangle() < b.triangle();
  }
};

/// A few items in that order: their places and numbers are sorted, not the items themselves.
class FewInOrder {
 public:
  FewInOrder(int axis, std::span<const Item> items) noexcept : count_(items.size()) {
    std::array<Key, few> keys;
    for (std::size_t i = 0; i < count_; ++i) {
      keys[i] = {items[i].middle(axis), items[i].triangle(), static_cast<std::int32_t>(i)};
    }
    std::sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(count_));
    for (std::size_t i = 0; i < count_; ++i) place_[i] = static_cast<std::uint8_t>(keys[i].place);
  }
  std::size_t operator[](std::size_t i) const noexcept { return place_[i]; }

  void arrange(std::span<Item> items) const noexcept {
    std::array<Item, few> arranged;
    for (std::size_t i = 0; i < count_; ++i) arranged[i] = items[place_[i]];
    std::copy_n(arranged.begin(), count_, items.begin());
  }

 private:
  struct Key {
    float middle;
    std::int32_t triangle, place;
    bool operator<(const Key& other) const noexcept {
      return middle != other.middle ? middle < other.middle : triangle < other.triangle;
    }
  };
  std::size_t count_;
  std::array<std::uint8_t, few> place_;
};

struct Split {
  int axis = -1;
  std::size_t at = 0;  ///< so many items on the left
  float cost = std::numeric_limits<float>::infinity();
};

/// The best of all splits at multiples of eight; leaves the items in the order of its axis.
Split exact_split(std::span<Item> items) {
  Split best;
  std::array<float, few> left_cost;
  std::array<FewInOrder, 3> order{FewInOrder(0, items), FewInOrder(1, items), FewInOrder(2, items)};
  for (int axis = 0; axis < 3; ++axis) {
    const FewInOrder& along = order[static_cast<std::size_t>(axis)];
    Box box;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i % width == 0) left_cost[i / width] = box.area() * packets_of(i);
      box.add(items[along[i]].low, items[along[i]].high);
    }
    box = {};
    for (std::size_t i = items.size(); i-- > width;) {
      box.add(items[along[i]].low, items[along[i]].high);
      if (i % width != 0) continue;
      const float cost = left_cost[i / width] + box.area() * packets_of(items.size() - i);
      if (cost < best.cost) best = {axis, i, cost};
    }
  }
  if (best.axis < 0) best = {0, (items.size() / 2 + width - 1) / width * width, 0};  // no finite cost
  order[static_cast<std::size_t>(best.axis)].arrange(items);
  return best;
}

/// The bins along the axes into which items fall by their middles.
struct Bins {
  Eigen::Array4f low, per_bin;

  explicit Bins(std::span<const Item> items) noexcept {
    low = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array4f high = -low;
    for (const Item& item : items) {
      const Eigen::Array4f middle = item.middle();
      low = low.min(middle);
      high = high.max(middle);
    }
    per_bin = bins / (high - low);
  }
  /// Not a number where the items' box is flat: the first bin. The fourth means nothing.
  Eigen::Array4i of(const Item& item) const noexcept {
    const Eigen::Array4f places = (item.middle() - low) * per_bin;
    return (places > 0.0f).select(places, 0.0f).min(bins - 1.0f).cast<int>();
  }
};

/// The border between two bins that would split best, and how many items lie before it.
struct Border : Split {
  int bin = 0;
};

Border best_border(std::span<const Item> items, const Bins& along) {
  std::array<std::array<Box, bins>, 3> box;
  std::array<std::array<std::size_t, bins>, 3> count{};
  for (const Item& item : items) {
    const Eigen::Array4i bin_along = along.of(item);
    for (int axis = 0; axis < 3; ++axis) {
      const int bin = bin_along[axis];
      box[axis][bin].add(item.low, item.high);
      ++count[axis][bin];
    }
  }
  Border best;
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
      if (cost < best.cost) best = {{axis, n, cost}, b};
    }
  }
  return best;
}

/// Copies the items to the other span, those before the multiple of eight nearest to the best border in
/// front, in any order; says how many these are.
std::size_t binned_split(std::span<const Item> items, std::span<Item> to) {
  const Bins along(items);
  const Border border = best_border(items, along);
  const auto nearest_multiple = [&](std::size_t n) {
    return std::clamp((n + width / 2) / width * width, width, (items.size() - 1) / width * width);
  };
  const auto place = [&](std::size_t n) { return to.begin() + static_cast<std::ptrdiff_t>(n); };
  if (border.axis < 0) {  // all in one place
    const std::size_t half = nearest_multiple(items.size() / 2);
    std::copy(items.begin(), items.end(), to.begin());
    std::nth_element(to.begin(), place(half), to.end(), Along{0});
    return half;
  }
  // Without a branch that nobody can foretell: each goes to the next free place of its side.
  std::size_t left = 0, right = items.size();
  for (const Item& item : items) {
    const bool is_left = along.of(item)[border.axis] < border.bin;
    to[is_left ? left : right - 1] = item;
    left += is_left ? 1 : 0;
    right -= is_left ? 0 : 1;
  }
  const std::size_t split = nearest_multiple(border.at);
  // A few must change sides: the nearest.
  if (split > border.at) {
    std::partial_sort(place(border.at), place(split), to.end(), Along{border.axis});
  } else if (split < border.at) {
    const auto from_behind = [&](std::size_t n) { return std::make_reverse_iterator(place(n)); };
    const auto reversed = [axis = border.axis](const Item& a, const Item& b) { return Along{axis}(b, a); };
    std::partial_sort(from_behind(border.at), from_behind(split), from_behind(0), reversed);
  }
  return split;
}

/// Writes the items' numbers in the order of packets.
/// @param spare  as many items, of any value
void group(std::span<Item> items, std::span<Item> spare, std::span<std::int32_t> order) {
  if (items.size() <= width) {
    for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].triangle();
    std::sort(order.begin(), order.end());
    return;
  }
  std::size_t split = 0;
  if (items.size() <= few) {
    split = exact_split(items).at;
  } else {
    split = binned_split(items, spare);
    std::swap(items, spare);
  }
  const auto left = [&] { group(items.first(split), spare.first(split), order.first(split)); };
  const auto right = [&] { group(items.subspan(split), spare.subspan(split), order.subspan(split)); };
  if (items.size() <= on_one_thread) {
    left();
    right();
  } else {
    tbb::parallel_invoke(left, right);
  }
}

}  // namespace

std::vector<std::int32_t> packet_order(const Part& part) {
  const auto count = static_cast<std::size_t>(part.triangle_count());
  std::vector<Item> items(count), spare(count);
  // Scaled, so that areas of the largest and smallest parts are numbers a float can hold.
  const double extent = part.half_extent.maxCoeff(), scale = extent > 0 ? 1 / extent : 1;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t t) {
    Item& item = items[t];
    const auto triangle = static_cast<std::int32_t>(t);
    const auto corner = [&](int k) {
      return (part.vertices.col(part.triangles(k, triangle)) * scale).cast<float>().array().eval();
    };
    const Eigen::Array3f a = corner(0), b = corner(1), c = corner(2);
    item.low.head<3>() = a.min(b).min(c);
    item.high.head<3>() = a.max(b).max(c);
    item.name(triangle);
  });
  std::vector<std::int32_t> order(count);
  group(items, spare, order);
  return order;
}

}  // namespace fingerpad
