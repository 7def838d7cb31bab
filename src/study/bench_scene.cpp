#include "study/bench_scene.hpp"

#include <cmath>

namespace fingerpad {

BenchScene::BenchScene(double rate_hz, const std::string& law) {
  scene_.name = "study";
  scene_.planes.emplace_back();
  scene_.friction.law = law;
  scene_.motion.rate_hz = rate_hz;
}

HandSettings& BenchScene::hold(const HandSettings& hand) {
  scene_.hand = hand;
  return *scene_.hand;
}

ClosedLoop BenchScene::loop(double seconds, const std::function<Vec3(double)>& position_W) const {
  const double rate_hz = scene_.motion.rate_hz;
  const auto ticks = static_cast<Eigen::Index>(std::floor(seconds * rate_hz + 1e-6)) + 1;
  Motion motion;
  motion.p_WQ.resize(3, ticks);
  motion.t_s.reserve(static_cast<std::size_t>(ticks));
  for (Eigen::Index k = 0; k < ticks; ++k) {
    motion.t_s.push_back(static_cast<double>(k) / rate_hz);
    motion.p_WQ.col(k) = position_W(motion.t_s.back());
  }
  return {load_world(scene_), scene_, FingerPath(std::move(motion), rate_hz, scene_.finger.direction)};
}

}  // namespace fingerpad
