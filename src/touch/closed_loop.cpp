#include "touch/closed_loop.hpp"

#include <algorithm>

namespace fingerpad {

ClosedLoop::ClosedLoop(std::shared_ptr<const World> world, const Scene& scene, FingerPath path)
    : touch_(std::move(world), scene), path_(std::move(path)) {
  if (!scene.hand) return;
  hand_.emplace(*scene.hand, 1 / scene.motion.rate_hz);
  hand_->start(path_.at(0).p_WQ);
}

TickRecord ClosedLoop::next() noexcept {
  const FingerSample intended = path_.at(tick_);
  const TickRecord record = hand_ ? next_in_hand(intended) : touch_.tick(intended);
  ++tick_;
  return record;
}

TickRecord ClosedLoop::next_in_hand(const FingerSample& intended) noexcept {
  FingerSample felt = intended;
  felt.p_WQ = hand_->encoded_W();
  felt.push_W_n = hand_->push_W_n(intended.p_WQ);
  TickRecord record = touch_.tick(felt);
  record.p_WQ = hand_->position_W();
  const Vec3 next = path_.at(std::min(tick_ + 1, path_.tick_count() - 1)).p_WQ;
  hand_->advance(intended.p_WQ, next, record.force_W_n);
  return record;
}

}  // namespace fingerpad
