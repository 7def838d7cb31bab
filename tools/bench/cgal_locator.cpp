#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

#include "locator.hpp"

namespace fingerpad::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal_point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

class CgalLocator : public Locator {
 public:
  explicit CgalLocator(const Part& part) {
    for (int t = 0; t < part.triangle_count(); ++t) {
      const auto corner = [&](int k) { return cgal_point(part.vertices.col(part.triangles(k, t))); };
      triangles_.emplace_back(corner(0), corner(1), corner(2));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
    last_ = {triangles_.front().vertex(0), triangles_.cbegin()};
  }

  double distance2_m2(const Vec3& q) override {
    last_ = tree_.closest_point_and_primitive(cgal_point(q), last_);
    return CGAL::squared_distance(cgal_point(q), last_.first);
  }

 private:
  std::vector<Triangle> triangles_;
  Tree tree_;
  Tree::Point_and_primitive_id last_;
};

}  // namespace

std::unique_ptr<Locator> make_cgal_locator(const Part& part) {
  return std::make_unique<CgalLocator>(part);
}

}  // namespace fingerpad::bench
