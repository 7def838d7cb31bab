#include <limits>
#include <utility>

#include "contact/triangle_tree.hpp"
#include "locator.hpp"

namespace fingerpad::bench {
namespace {

class TreeLocator : public Locator {
 public:
  explicit TreeLocator(std::shared_ptr<const Part> part) : tree_(std::move(part)) {}

  double distance2_m2(const Vec3& q) override {
    const ClosestTriangle found = tree_.closest(q, last_, std::numeric_limits<double>::infinity());
    last_ = found.triangle;
    return found.at.distance2_m2;
  }

 private:
  TriangleTree tree_;
  int last_ = -1;
};

}  // namespace

std::unique_ptr<Locator> make_tree_locator(std::shared_ptr<const Part> part) {
  return std::make_unique<TreeLocator>(std::move(part));
}

}  // namespace fingerpad::bench
