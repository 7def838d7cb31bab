#include <limits>
#include <utility>

#include "contact/closest_memory.hpp"
#include "contact/triangle_tree.hpp"
#include "locator.hpp"

namespace fingerpad::bench {
namespace {

class TreeLocator : public Locator {
 public:
  explicit TreeLocator(std::shared_ptr<const Part> part) : tree_(std::move(part)) {}

  double distance2_m2(const Vec3& q) override {
    return tree_.closest(q, memory_, std::numeric_limits<double>::infinity()).at.distance2_m2;
  }

 private:
  TriangleTree tree_;
  ClosestMemory memory_;
};

}  // namespace

std::unique_ptr<Locator> make_tree_locator(std::shared_ptr<const Part> part) {
  return std::make_unique<TreeLocator>(std::move(part));
}

}  // namespace fingerpad::bench
