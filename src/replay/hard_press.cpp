#include "replay/hard_press.hpp"

#include "replay/figures.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

/// The normal force that a rub laid on a part asks for; 0 where a scene asks for none.
double asked_n(const Scene& scene) {
  if (!scene.motion.laid || scene.hand || scene.parts.empty()) return 0;
  const SurfaceMotion& rub = *scene.motion.laid;
  return rub.depth_m > 0 ? rub.depth_m * scene.parts[0].surface.stiffness_n_per_m : rub.normal_force_n;
}

}  // namespace

std::optional<HardPress> hard_press(const Scene& scene, const std::vector<double>& figures) {
  constexpr double hard_share = 3;
  const double wanted_n = asked_n(scene);
  if (!(wanted_n > 0)) return std::nullopt;
  const double felt_n = Figures::of(figures, "max_normal_force_n");
  if (!(felt_n > hard_share * wanted_n)) return std::nullopt;
  return HardPress{felt_n, wanted_n};
}

}  // namespace fingerpad
