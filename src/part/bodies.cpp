#include "part/bodies.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "part/index.hpp"
#include "part/union_find.hpp"

namespace fingerpad {
namespace {

std::vector<int> numbered_bodies(const IndexTriples& welded, const EdgeTable& edges, int* count) {
  const int n = static_cast<int>(welded.cols());
  UnionFind joined(n);
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    if (on.size() == 2) joined.join(on[0] / 3, on[1] / 3);
  }
  std::vector<int> body(at(n), -1);
  for (int t = 0; t < n; ++t) {
    if (is_collapsed(welded, t)) continue;
    // A root is the lowest triangle of its body, so it was numbered before the others.
    const int root = joined.root(t);
    body[at(t)] = root == t ? (*count)++ : body[at(root)];
  }
  return body;
}

/// Opens the bodies that pass an edge more often one way than the other.
void find_open(Bodies& bodies, const IndexTriples& welded, const EdgeTable& edges) {
  std::vector<std::pair<int, int>> passes;  // body, +1 or -1
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    if (on.size() == 2) {
      if (edge_from(welded, on[0]) == edge_from(welded, on[1]))
        bodies.all[at(bodies.of_triangle[at(on[0] / 3)])].closed = false;
      continue;
    }
    passes.clear();
    for (const int h : on) {
      passes.emplace_back(bodies.of_triangle[at(h / 3)], edge_from(welded, h) < edge_to(welded, h) ? 1 : -1);
    }
    std::sort(passes.begin(), passes.end());
    for (std::size_t i = 0; i < passes.size();) {
      const int body = passes[i].first;
      int sum = 0;
      for (; i < passes.size() && passes[i].first == body; ++i) sum += passes[i].second;
      if (sum != 0) bodies.all[at(body)].closed = false;
    }
  }
}

/// Facet centres whose depth speaks for their body's.
struct Sample {
  Vec3 p = Vec3::Zero();
  int body = 0;
};
constexpr int samples_of_body = 3;

/// Where the vertical line through (x, y) pierces a triangle. Whether it does is decided edge by edge from
/// the lower welded vertex, so that the triangles of a closed body tile the plane: no line slips between two.
class VerticalLine {
 public:
  VerticalLine(const Points& places, double x, double y) : places_(places), x_(x), y_(y) {}

  /// @param height  set where it does
  bool pierces(const IndexTriples& welded, int t, double* height) const {
    bool odd = false;
    int crossings = 0;
    std::array<std::array<double, 2>, 2> crossing{};  // x, z where two edges cross y
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({welded(k, t), welded((k + 1) % 3, t)});
      const auto a = places_.col(low), b = places_.col(high);
      if ((a.y() <= y_) == (b.y() <= y_)) continue;
      const double along = (y_ - a.y()) / (b.y() - a.y());
      const double x = a.x() + along * (b.x() - a.x());
      if (x > x_) odd = !odd;
      if (crossings < 2) crossing[at(crossings++)] = {x, a.z() + along * (b.z() - a.z())};
    }
    if (!odd) return false;
    const auto [first, second] = crossing;
    const double width = second[0] - first[0];
    const double share = width != 0 ? std::clamp((x_ - first[0]) / width, 0.0, 1.0) : 0.5;
    *height = first[1] + share * (second[1] - first[1]);
    return true;
  }

 private:
  const Points& places_;
  double x_, y_;
};

/// Samples by their place in the xy plane.
class SampleGrid {
 public:
  explicit SampleGrid(const std::vector<Sample>& samples) {
    for (const Sample& sample : samples) box_.extend(sample.p.head<2>());
    cells_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(samples.size()))), 1, 1024);
    in_cell_.resize(at(cells_) * at(cells_));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec2 p = samples[i].p.head<2>();
      in_cell_[at(cell(p.x(), 0)) * at(cells_) + at(cell(p.y(), 1))].push_back(static_cast<int>(i));
    }
  }

  template <typename Visit>
  void visit(const Eigen::AlignedBox2d& area, Visit&& visit) const {
    if (!area.intersects(box_)) return;
    for (int i = cell(area.min().x(), 0); i <= cell(area.max().x(), 0); ++i) {
      for (int j = cell(area.min().y(), 1); j <= cell(area.max().y(), 1); ++j) {
        for (const int sample : in_cell_[at(i) * at(cells_) + at(j)]) visit(sample);
      }
    }
  }

 private:
  int cell(double x, int axis) const {
    const double width = box_.sizes()[axis];
    const double share = width > 0 ? (x - box_.min()[axis]) / width : 0;
    return static_cast<int>(std::clamp(share, 0.0, 1.0) * (cells_ - 1));
  }

  Eigen::AlignedBox2d box_;
  int cells_ = 1;
  std::vector<std::vector<int>> in_cell_;
};

/// Where each welded vertex stands: one of its vertices, so that triangles meet without gaps.
Points welded_places(const Points& vertices, const IndexTriples& triangles, const IndexTriples& welded) {
  Points places = Points::Zero(3, welded.maxCoeff() + 1);
  for (int t = static_cast<int>(triangles.cols()) - 1; t >= 0; --t) {
    for (int k = 0; k < 3; ++k) places.col(welded(k, t)) = vertices.col(triangles(k, t));
  }
  return places;
}

std::vector<Sample> take_samples(const Bodies& bodies, const Points& places, const IndexTriples& welded) {
  std::vector<std::vector<int>> triangles(bodies.all.size());
  for (int t = 0; t < welded.cols(); ++t) {
    const int body = bodies.of_triangle[at(t)];
    if (body >= 0 && bodies.all[at(body)].closed) triangles[at(body)].push_back(t);
  }
  std::vector<Sample> samples;
  for (std::size_t body = 0; body < triangles.size(); ++body) {
    const std::vector<int>& own = triangles[body];
    if (own.empty()) continue;
    for (int i = 0; i < samples_of_body; ++i) {
      const int t = own[(own.size() - 1) * at(i) / (samples_of_body - 1)];
      Sample sample{Vec3::Zero(), static_cast<int>(body)};
      for (int k = 0; k < 3; ++k) sample.p += places.col(welded(k, t)) / 3;
      samples.push_back(sample);
    }
  }
  return samples;
}

/// Sheets above samples, as sample and body; false where there are too many.
bool sheets_above(const Bodies& bodies, const std::vector<Sample>& samples, const Points& places,
                  const IndexTriples& welded, std::vector<std::pair<int, int>>& above) {
  constexpr std::int64_t most_work = 200'000'000;  // a second or so
  constexpr std::size_t most_sheets = 10'000'000;  // 80 MB
  const SampleGrid grid(samples);
  std::int64_t work = 0;
  for (int t = 0; t < welded.cols() && work < most_work; ++t) {
    const int body = bodies.of_triangle[at(t)];
    if (body < 0 || !bodies.all[at(body)].closed) continue;
    Eigen::AlignedBox2d area;
    for (int k = 0; k < 3; ++k) area.extend(places.col(welded(k, t)).head<2>());
    grid.visit(area, [&](int s) {
      ++work;
      const Sample& sample = samples[at(s)];
      double height = 0;
      if (sample.body == body || above.size() >= most_sheets) return;
      if (!bodies.all[at(body)].box.contains(bodies.all[at(sample.body)].box)) return;
      if (VerticalLine(places, sample.p.x(), sample.p.y()).pierces(welded, t, &height) &&
          height > sample.p.z())
        above.emplace_back(s, body);
    });
  }
  return work < most_work && above.size() < most_sheets;
}

void find_depths(Bodies& bodies, const Points& places, const IndexTriples& welded) {
  const std::vector<Sample> samples = take_samples(bodies, places, welded);
  if (samples.size() <= samples_of_body) return;
  std::vector<std::pair<int, int>> above;
  bodies.depths_known = sheets_above(bodies, samples, places, welded, above);
  if (!bodies.depths_known) return;
  // An odd number of sheets above: inside. Two of three samples decide.
  std::sort(above.begin(), above.end());
  std::vector<std::pair<int, int>> inside;  // body, body around it
  for (std::size_t i = 0; i < above.size();) {
    std::size_t end = i;
    while (end < above.size() && above[end] == above[i]) ++end;
    if ((end - i) % 2 == 1) inside.emplace_back(samples[at(above[i].first)].body, above[i].second);
    i = end;
  }
  std::sort(inside.begin(), inside.end());
  for (std::size_t i = 1; i < inside.size(); ++i) {
    const bool third = i > 1 && inside[i] == inside[i - 2];
    if (inside[i] == inside[i - 1] && !third) ++bodies.all[at(inside[i].first)].depth;
  }
}

}  // namespace

Bodies find_bodies(const Points& vertices, const IndexTriples& triangles, const IndexTriples& welded,
                   const EdgeTable& edges) {
  Bodies bodies;
  int count = 0;
  bodies.of_triangle = numbered_bodies(welded, edges, &count);
  bodies.all.resize(at(count));
  for (int t = 0; t < triangles.cols(); ++t) {
    const int number = bodies.of_triangle[at(t)];
    if (number < 0) continue;
    Body& body = bodies.all[at(number)];
    const Vec3 a = vertices.col(triangles(0, t)), b = vertices.col(triangles(1, t)),
               c = vertices.col(triangles(2, t));
    body.volume_m3 += a.dot(b.cross(c)) / 6;
    body.box.extend(a).extend(b).extend(c);
  }
  find_open(bodies, welded, edges);
  if (count > 1) find_depths(bodies, welded_places(vertices, triangles, welded), welded);
  return bodies;
}

}  // namespace fingerpad
