#pragma once

#include "base/random_stream.hpp"
#include "part/part.hpp"

namespace fingerpad::test {

/// Goes towards one facet after another, some thousandth of the part under it, with a tremble, and now and
/// then far off. Begins close above the part's box.
class Wanderer {
 public:
  explicit Wanderer(const Part& part)
      : part_(part), at_(part.centre_P + Vec3(0, 0, part.half_extent.z() + 0.03 * part.size_m())) {
    aim();
  }

  /// @param pace  1: a thousandth of the part a tick, and now and then twenty
  Vec3 next(double pace = 1) {
    const double size_m = part_.size_m();
    const double step_m = pace * 1e-3 * size_m * (random_.uniform() < 0.01 ? 20 : 1);
    if ((aim_ - at_).norm() < step_m || random_.uniform() < 2e-4) aim();
    at_ += (aim_ - at_).normalized() * step_m + pace * 2e-4 * size_m * random();
    return at_;
  }

 private:
  Vec3 random() { return {random_.normal(), random_.normal(), random_.normal()}; }
  void aim() {
    const auto t =
        static_cast<Eigen::Index>((static_cast<long>(++station_) * 7919 * 31) % part_.triangle_count());
    const Vec3 middle =
        (part_.vertices.col(part_.triangles(0, t)) + part_.vertices.col(part_.triangles(1, t)) +
         part_.vertices.col(part_.triangles(2, t))) /
        3;
    aim_ = part_.centre_P + middle - 5e-3 * part_.size_m() * part_.facet_normals.col(t);
    if (random_.uniform() < 0.2) aim_ += 0.3 * part_.size_m() * random();
  }

  const Part& part_;
  RandomStream random_{7};
  Vec3 at_, aim_ = Vec3::Zero();
  int station_ = 0;
};

}  // namespace fingerpad::test
