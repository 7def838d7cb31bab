#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace fingerpad {

/// Disjoint sets over 0 .. n-1. The lowest member stands for its set, so results do not depend on the order
/// of calls.
class UnionFind {
 public:
  explicit UnionFind(int n) : parent_(static_cast<std::size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (up(i) != i) {
      up(i) = up(up(i));
      i = up(i);
    }
    return i;
  }

  void join(int a, int b) {
    a = root(a);
    b = root(b);
    up(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& up(int i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace fingerpad
