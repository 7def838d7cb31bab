#include "touch/touch_swap.hpp"

#include <utility>

#include "touch/world.hpp"

namespace fingerpad {

std::shared_ptr<const World> changed_world(const World& world, const Scene& scene) {
  auto changed = std::make_shared<World>(world);
  for (std::size_t i = 0; i < changed->surfaces.size(); ++i) {
    if (i < scene.parts.size() + scene.planes.size())
      changed->surfaces[i].properties = surface_properties(scene, static_cast<int>(i));
  }
  if (const auto prepare = settled_contact(scene, *changed).normals->prepare) {
    for (const Surface& surface : changed->surfaces) {
      if (surface.tree) prepare(*surface.tree);
    }
  }
  return changed;
}

struct TouchSwap::Next {
  Touch touch;  // until it is taken the new one, then the old one
  std::vector<SceneChange> changes;
  std::unique_ptr<ChangeBeside> beside;
  double due_s = 0, taken_s = 0;
};

TouchSwap::TouchSwap(std::shared_ptr<const World> world, Scene scene)
    : scene_(std::move(scene)), first_world_(std::move(world)) {}

TouchSwap::~TouchSwap() {
  delete offered_.load();
  delete retired_.load();
}

std::unique_ptr<TouchSwap::Next> TouchSwap::make(const std::vector<SceneChange>& changes, Scene& scene) {
  for (const SceneChange& change : changes) apply(change, scene);
  worlds_.push_back(changed_world(*first_world_, scene));
  return std::make_unique<Next>(
      Next{Touch(worlds_.back(), scene), changes, beside_ ? beside_(*worlds_.back(), scene) : nullptr});
}

void TouchSwap::schedule(const std::vector<SceneChange>& changes) {
  const std::lock_guard lock(mutex_);
  for (std::size_t first = 0; first < changes.size();) {
    std::size_t end = first + 1;
    while (end < changes.size() && changes[end].t_s == changes[first].t_s) ++end;
    using Difference = std::vector<SceneChange>::difference_type;
    const std::vector<SceneChange> together(changes.begin() + static_cast<Difference>(first),
                                            changes.begin() + static_cast<Difference>(end));
    scheduled_.push_back(make(together, scene_));
    scheduled_.back()->due_s = changes[first].t_s;
    first = end;
  }
}

void TouchSwap::change(const SceneChange& change) {
  const std::lock_guard lock(mutex_);
  collect();
  Scene scene = scene_;
  // Made before what was offered is taken back: that holds on where this cannot be made.
  std::unique_ptr<Next> next = make({change}, scene);
  const std::unique_ptr<Next> before(offered_.exchange(nullptr, std::memory_order_acq_rel));
  if (before) next->changes.insert(next->changes.begin(), before->changes.begin(), before->changes.end());
  scene_ = std::move(scene);
  offered_.store(next.release(), std::memory_order_release);
}

Scene TouchSwap::scene() const {
  const std::lock_guard lock(mutex_);
  return scene_;
}

void TouchSwap::collect() {
  const auto log = [this](const Next& next) {
    for (SceneChange change : next.changes) {
      change.t_s = next.taken_s;
      log_.push_back(std::move(change));
    }
  };
  const std::size_t taken = scheduled_taken_.load(std::memory_order_acquire);
  for (; scheduled_told_ < taken; ++scheduled_told_) log(*scheduled_[scheduled_told_]);
  const std::unique_ptr<Next> retired(retired_.exchange(nullptr, std::memory_order_acq_rel));
  if (retired) log(*retired);
}

std::vector<SceneChange> TouchSwap::taken(std::size_t from) {
  const std::lock_guard lock(mutex_);
  collect();
  if (from >= log_.size()) return {};
  return {log_.begin() + static_cast<std::vector<SceneChange>::difference_type>(from), log_.end()};
}

void TouchSwap::before_tick(Touch& touch, double t_s) noexcept {
  const auto take = [&](Next& next) {
    next.touch.take_over(touch);
    std::swap(next.touch, touch);
    if (next.beside) next.beside->put_in();
    next.taken_s = t_s;
  };
  std::size_t due = scheduled_taken_.load(std::memory_order_relaxed);
  // A recording's time and the tick's own may be a rounding apart; no two ticks are so near.
  constexpr double rounding_s = 1e-9;
  for (; due < scheduled_.size() && scheduled_[due]->due_s <= t_s + rounding_s; ++due) {
    take(*scheduled_[due]);
    scheduled_taken_.store(due + 1, std::memory_order_release);
  }
  if (offered_.load(std::memory_order_relaxed) == nullptr) return;
  // The one before is still to be fetched: then this one waits for a later tick.
  if (retired_.load(std::memory_order_acquire) != nullptr) return;
  Next* const next = offered_.exchange(nullptr, std::memory_order_acq_rel);
  if (next == nullptr) return;
  take(*next);
  retired_.store(next, std::memory_order_release);
}

}  // namespace fingerpad
