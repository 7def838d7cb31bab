#include "part/edge_table.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "part/index.hpp"
#include "part/union_find.hpp"

namespace fingerpad {
namespace {

struct Upper {
  int vertex, half_edge;
  bool operator<(const Upper& other) const {
    return vertex != other.vertex ? vertex < other.vertex : half_edge < other.half_edge;
  }
};

}  // namespace

EdgeTable make_edge_table(const IndexTriples& corners, int vertex_count) {
  const int triangles = static_cast<int>(corners.cols());
  // Bucket the half-edges by their lower vertex, then sort each (small) bucket by the upper one.
  std::vector<int> begin(at(vertex_count) + 1, 0);
  const auto each_half_edge = [&](auto&& visit) {
    for (int t = 0; t < triangles; ++t) {
      if (is_collapsed(corners, t)) continue;
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const auto [lower, upper] = std::minmax({edge_from(corners, h), edge_to(corners, h)});
        visit(h, lower, upper);
      }
    }
  };
  each_half_edge([&](int, int lower, int) { ++begin[at(lower) + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Upper> bucketed(at(begin.back()));
  std::vector<int> fill(begin.begin(), begin.end() - 1);
  each_half_edge([&](int h, int lower, int upper) { bucketed[at(fill[at(lower)]++)] = {upper, h}; });

  EdgeTable table;
  table.half_edges.reserve(bucketed.size());
  for (int v = 0; v < vertex_count; ++v) {
    const auto from = bucketed.begin() + begin[at(v)], to = bucketed.begin() + begin[at(v) + 1];
    std::sort(from, to);
    for (auto i = from; i != to; ++i) {
      if (i == from || i->vertex != (i - 1)->vertex) {
        table.starts.push_back(static_cast<int>(table.half_edges.size()));
      }
      table.half_edges.push_back(i->half_edge);
    }
  }
  table.starts.push_back(static_cast<int>(table.half_edges.size()));
  return table;
}

EdgeCounts count_edges(const EdgeTable& table, const IndexTriples& corners) {
  EdgeCounts counts;
  for (int e = 0; e < table.edge_count(); ++e) {
    const auto on = table.on_edge(e);
    if (on.size() == 1) ++counts.boundary;
    if (on.size() > 2) ++counts.nonmanifold;
    if (on.size() == 2 && edge_from(corners, on[0]) == edge_from(corners, on[1])) ++counts.inconsistent;
  }
  return counts;
}

std::vector<int> component_of(const EdgeTable& table, int triangle_count, int* component_count) {
  UnionFind joined(triangle_count);
  std::vector<bool> present(at(triangle_count), false);
  for (int e = 0; e < table.edge_count(); ++e) {
    const auto on = table.on_edge(e);
    for (const int h : on) {
      present[at(h / 3)] = true;
      joined.join(on[0] / 3, h / 3);
    }
  }
  std::vector<int> component(at(triangle_count), -1);
  int count = 0;
  for (int t = 0; t < triangle_count; ++t) {
    if (!present[at(t)]) continue;
    // A root is the lowest triangle of its component, so it was numbered before the others.
    const int r = joined.root(t);
    component[at(t)] = r == t ? count++ : component[at(r)];
  }
  *component_count = count;
  return component;
}

int component_count(const IndexTriples& corners, int vertex_count) {
  UnionFind joined(vertex_count);
  std::vector<bool> present(at(vertex_count), false);
  for (int t = 0; t < corners.cols(); ++t) {
    if (is_collapsed(corners, t)) continue;
    present[at(corners(0, t))] = true;
    joined.join(corners(0, t), corners(1, t));
    joined.join(corners(0, t), corners(2, t));
  }
  int count = 0;
  for (int v = 0; v < vertex_count; ++v) {
    // The root need not be a corner 0 itself.
    if (present[at(v)]) present[at(joined.root(v))] = true;
  }
  for (int v = 0; v < vertex_count; ++v) count += present[at(v)] && joined.root(v) == v ? 1 : 0;
  return count;
}

std::vector<bool> find_duplicates(const EdgeTable& table, const IndexTriples& corners) {
  std::vector<bool> duplicate(at(static_cast<int>(corners.cols())), false);
  std::vector<std::pair<int, int>> around;  // opposite vertex, triangle
  for (int e = 0; e < table.edge_count(); ++e) {
    const auto on = table.on_edge(e);
    if (on.size() < 2) continue;
    if (on.size() == 2) {
      if (edge_opposite(corners, on[0]) == edge_opposite(corners, on[1])) duplicate[at(on[1] / 3)] = true;
      continue;
    }
    around.clear();
    for (const int h : on) around.emplace_back(edge_opposite(corners, h), h / 3);
    std::sort(around.begin(), around.end());
    for (std::size_t i = 1; i < around.size(); ++i) {
      if (around[i].first == around[i - 1].first) duplicate[at(around[i].second)] = true;
    }
  }
  return duplicate;
}

}  // namespace fingerpad
