#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "scene/scene_change.hpp"
#include "touch/touch.hpp"

namespace fingerpad {

/// The same surfaces with the scene's properties, ready for its normals.
std::shared_ptr<const World> changed_world(const World& world, const Scene& scene);

/// Something else that has to change with the touch, at the same tick: made ready as the touch is.
struct ChangeBeside {
  virtual ~ChangeBeside() = default;
  /// Takes its place, and keeps what was there before until this ends. On the touch's thread; noexcept,
  /// allocates nothing.
  virtual void put_in() noexcept = 0;
};

/// Changes a touch between two of its ticks. What a change needs (the method, the law, the surfaces'
/// properties) is made ready on the thread that asks for it and put in the touch's place by an exchange of
/// pointers: the tick neither waits nor allocates, and what it no longer needs is freed by another thread.
///
/// What goes on over a change: see Touch::take_over.
class TouchSwap {
 public:
  /// @param world, scene  as the touch was made of them
  TouchSwap(std::shared_ptr<const World> world, Scene scene);
  ~TouchSwap();
  TouchSwap(const TouchSwap&) = delete;
  TouchSwap& operator=(const TouchSwap&) = delete;

  /// Makes ready what has to change beside the touch; null: nothing. The world lives as long as this.
  using Beside = std::function<std::unique_ptr<ChangeBeside>(const World& world, const Scene& scene)>;
  /// From the next change on. Before the first tick.
  void change_too(Beside beside) { beside_ = std::move(beside); }

  /// Makes changes ready for their times, as a recording has them: in order of time, before the first tick.
  /// Throws Error (refused) for one that the scene cannot have.
  void schedule(const std::vector<SceneChange>& changes);
  bool is_scheduled() const noexcept { return !scheduled_.empty(); }

  /// Changes the touch at once: at its next tick, unless the one before has not been taken yet; then together
  /// with that one. Any thread but the touch's. Throws as schedule, and changes nothing then.
  void change(const SceneChange& change);

  /// The scene with all that was asked for so far. Any thread but the touch's.
  Scene scene() const;
  /// What has been taken, with the times of the ticks from which it holds, but for the first `from`. Any
  /// thread but the touch's.
  std::vector<SceneChange> taken(std::size_t from);

  /// What is due takes its place. On the touch's thread, before the tick at t_s.
  void before_tick(Touch& touch, double t_s) noexcept;

 private:
  struct Next;
  std::unique_ptr<Next> make(const std::vector<SceneChange>& changes, Scene& scene);
  void collect();

  mutable std::mutex mutex_;  // of the threads that ask; the touch's never takes it
  Scene scene_;
  Beside beside_;
  std::shared_ptr<const World> first_world_;
  std::vector<std::shared_ptr<const World>> worlds_;
  std::vector<SceneChange> log_;

  std::atomic<Next*> offered_{nullptr}, retired_{nullptr};
  std::vector<std::unique_ptr<Next>> scheduled_;
  std::atomic<std::size_t> scheduled_taken_{0};
  std::size_t scheduled_told_ = 0;
};

}  // namespace fingerpad
