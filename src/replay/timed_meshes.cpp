#include "replay/timed_meshes.hpp"

#include <chrono>
#include <utility>

#include "base/error.hpp"
#include "replay/job_order.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

void TimedMeshes::load(const Scene& scene) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto note = [&] {
    const std::chrono::duration<double> taken = Clock::now() - start;
    load_s_.try_emplace(meshes_of(scene), taken.count());
  };
  try {
    for (const PartEntry& part : scene.parts) store_.load(part);
  } catch (const Error&) {
    note();
    throw;
  }
  note();
}

double TimedMeshes::take_load_s(const Scene& scene) {
  const auto known = load_s_.find(meshes_of(scene));
  return known == load_s_.end() ? 0 : std::exchange(known->second, 0.0);
}

}  // namespace fingerpad
