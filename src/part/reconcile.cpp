#include "part/reconcile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fingerpad {
namespace {

/// Two readings of one decimal number may differ in the last place of a float.
bool same_float(double file, double delivered) {
  const auto rounded = static_cast<float>(file);
  const auto other = static_cast<float>(delivered);
  if (rounded == other) return true;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  return std::nextafter(rounded, infinite) == other || std::nextafter(rounded, -infinite) == other;
}

class Comparison {
 public:
  Comparison(RawMesh& mesh, const OpenMeshDelivery& delivery) : mesh_(mesh), delivery_(delivery) {}

  /// Whether every polygon was delivered, but for those that are expected to be missing. Moves vertices as it
  /// goes.
  bool walk() {
    std::size_t next = 0;
    for (int i = 0; i < mesh_.polygon_count(); ++i) {
      pass_over_short(next);
      const std::span<const int> said(mesh_.corners.data() + mesh_.first_corner(i),
                                      static_cast<std::size_t>(mesh_.corner_count(i)));
      if (next < delivery_.ends.size() && matches(said, delivered(next))) {
        ++next;
        continue;
      }
      const bool missing = std::find(said.begin(), said.end(), -1) != said.end();
      if (missing) {
        // OpenMesh may pass it on all the same, with whatever corners.
        if (next < delivery_.ends.size() && has_missing(delivered(next))) ++next;
        continue;
      }
      const std::vector<int> once = without_repeats(said);
      if (once.size() == said.size()) return false;
      if (once.size() > 2 && next < delivery_.ends.size() && matches(once, delivered(next))) ++next;
    }
    pass_over_short(next);
    return next == delivery_.ends.size();
  }

 private:
  /// Faces of fewer than three corners, which the scan left out.
  void pass_over_short(std::size_t& next) const {
    while (next < delivery_.ends.size() && delivered(next).size() < 3) ++next;
  }

  std::span<const int> delivered(std::size_t i) const {
    const int from = i == 0 ? 0 : delivery_.ends[i - 1];
    return {delivery_.corners.data() + from, static_cast<std::size_t>(delivery_.ends[i] - from)};
  }

  static bool has_missing(std::span<const int> corners) {
    return std::find(corners.begin(), corners.end(), -1) != corners.end();
  }

  bool same_place(int said, int delivered) const {
    if (said < 0 || delivered < 0) return false;
    const Vec3& a = mesh_.vertices[static_cast<std::size_t>(said)];
    const Vec3& b = delivery_.vertices[static_cast<std::size_t>(delivered)];
    return same_float(a.x(), b.x()) && same_float(a.y(), b.y()) && same_float(a.z(), b.z());
  }

  bool matches(std::span<const int> said, std::span<const int> got) {
    if (said.size() != got.size()) return false;
    for (std::size_t k = 0; k < said.size(); ++k) {
      if (!same_place(said[k], got[k])) return false;
    }
    for (std::size_t k = 0; k < said.size(); ++k) {
      mesh_.vertices[static_cast<std::size_t>(said[k])] =
          delivery_.vertices[static_cast<std::size_t>(got[k])];
    }
    return true;
  }

  /// The corners without those that stand where an earlier one stands.
  std::vector<int> without_repeats(std::span<const int> corners) const {
    constexpr std::size_t large =
        1000;  // no reader takes repetitions out of so large a polygon: leave the square time
    std::vector<int> once(corners.begin(), corners.end());
    if (corners.size() > large) return once;
    once.clear();
    for (const int corner : corners) {
      const auto is_same = [&](int other) {
        return mesh_.vertices[static_cast<std::size_t>(other)] ==
               mesh_.vertices[static_cast<std::size_t>(corner)];
      };
      if (std::none_of(once.begin(), once.end(), is_same)) once.push_back(corner);
    }
    return once;
  }

  RawMesh& mesh_;
  const OpenMeshDelivery& delivery_;
};

}  // namespace

std::string reconcile(RawMesh& mesh, const OpenMeshDelivery& delivery) {
  std::string lost;
  if (!Comparison(mesh, delivery).walk()) {
    lost = fmt::format(
        "OpenMesh reads this file otherwise than it is written (its {} faces are not the file's {}): the "
        "file was taken at "
        "its own word",
        delivery.ends.size(), mesh.polygon_count());
  }
  // Vertices that no delivered face named, and all of them after a difference.
  for (Vec3& vertex : mesh.vertices) vertex = vertex.unaryExpr(&float32_of);
  return lost;
}

}  // namespace fingerpad
