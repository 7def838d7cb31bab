#include <cstdio>

#include "scene/scene.hpp"
#include "touch/touch.hpp"

// Presses a finger 1 mm into a plane and drags it: what a servo process does each tick.
int main() {
  using namespace fingerpad;
  auto world = std::make_shared<World>();
  world->surfaces.emplace_back();
  Scene scene;
  scene.friction.law = "finger-pad";
  Touch touch(world, scene);
  TickRecord row;
  for (int k = 0; k < 100; ++k) {
    FingerSample finger;
    finger.p_WQ = Vec3(0.0005 * k, 0, -0.001);
    row = touch.tick(finger);
  }
  std::printf("fn %.3f N, mu %.3f\n", row.normal_force_n, row.mu);
  return row.normal_force_n > 0.99 && row.mu > 0.199 && row.mu < 0.201 ? 0 : 1;
}
