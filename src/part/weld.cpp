#include "part/weld.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "part/union_find.hpp"

namespace fingerpad {
namespace {

using Cell = std::array<std::int64_t, 3>;

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of SplitMix64 (Steele, Lea & Flood 2014)
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t hash_of(const Cell& key) {
  std::uint64_t h = 0;
  for (const std::int64_t part : key) h = mixed(h + 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(part));
  return h;
}

Cell bits_of(const Vec3& p) {
  // Adding 0 turns -0 into 0.
  return {std::bit_cast<std::int64_t>(p.x() + 0.0), std::bit_cast<std::int64_t>(p.y() + 0.0),
          std::bit_cast<std::int64_t>(p.z() + 0.0)};
}

/// Open addressing over numbers from 0: where the number of an equal key stands, or -1 where it belongs.
class SlotTable {
 public:
  explicit SlotTable(std::size_t keys) : slots_(std::bit_ceil(2 * keys + 2), -1) {}

  /// @param is_it  whether the number in a slot stands for the key that was hashed
  template <typename IsIt>
  int& at(std::uint64_t hash, IsIt&& is_it) {
    std::size_t i = hash & (slots_.size() - 1);
    while (slots_[i] >= 0 && !is_it(slots_[i])) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }

 private:
  std::vector<int> slots_;
};

Welding renumbered(const Welding& welding, UnionFind& merged) {
  Welding result;
  result.id.resize(welding.id.size());
  std::vector<int> number(static_cast<std::size_t>(welding.count), -1);
  for (std::size_t i = 0; i < welding.id.size(); ++i) {
    int& n = number[static_cast<std::size_t>(merged.root(welding.id[i]))];
    if (n < 0) n = result.count++;
    result.id[i] = n;
  }
  return result;
}

}  // namespace

Welding weld_equal(const Points& points) {
  const auto n = static_cast<std::size_t>(points.cols());
  Welding welding;
  welding.id.resize(n);
  SlotTable table(n);
  std::vector<int> first;  // of each vertex: its first point
  for (int i = 0; i < points.cols(); ++i) {
    const auto same = [&](int id) {
      return points.col(first[static_cast<std::size_t>(id)]) == points.col(i);
    };
    int& slot = table.at(hash_of(bits_of(points.col(i))), same);
    if (slot < 0) {
      slot = welding.count++;
      first.push_back(i);
    }
    welding.id[static_cast<std::size_t>(i)] = slot;
  }
  return welding;
}

Welding weld_near(const Points& points, const Welding& welding, const std::vector<int>& candidates,
                  double reach) {
  const std::size_t n = candidates.size();
  std::vector<Cell> cells(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 at = points.col(candidates[i]) / reach;
    cells[i] = {std::llround(at.x()), std::llround(at.y()), std::llround(at.z())};
  }
  // The table knows one candidate of each cell, `next` chains the others. More pairs than this means that the
  // reach is no crack's width but the size of the mesh's own detail.
  std::size_t pairs_left = 64 * n;
  SlotTable table(n);
  std::vector<int> next(n, -1);
  UnionFind merged(welding.count);
  for (std::size_t i = 0; i < n; ++i) {
    for (int near = 0; near < 27; ++near) {
      const Cell cell{cells[i][0] + near % 3 - 1, cells[i][1] + near / 3 % 3 - 1, cells[i][2] + near / 9 - 1};
      int j = table.at(hash_of(cell), [&](int k) { return cells[static_cast<std::size_t>(k)] == cell; });
      for (; j >= 0; j = next[static_cast<std::size_t>(j)]) {
        if (pairs_left-- == 0) return welding;
        const auto a = static_cast<std::size_t>(candidates[i]);
        const auto b = static_cast<std::size_t>(candidates[static_cast<std::size_t>(j)]);
        if ((points.col(candidates[i]) - points.col(static_cast<int>(b))).norm() > reach) continue;
        merged.join(welding.id[a], welding.id[b]);
      }
    }
    int& slot =
        table.at(hash_of(cells[i]), [&](int k) { return cells[static_cast<std::size_t>(k)] == cells[i]; });
    next[i] = slot;
    slot = static_cast<int>(i);
  }
  return renumbered(welding, merged);
}

}  // namespace fingerpad
