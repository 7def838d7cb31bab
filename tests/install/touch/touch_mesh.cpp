// Rubs a finger along the underside of a part and prints the force on it: touch_mesh bracket.stl
#include <cstdio>
#include <fingerpad/fingerpad.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) throw fingerpad::Error(fingerpad::ErrorKind::usage, "touch_mesh", "name a mesh");
  const fingerpad::PartSurface part(argv[1], {.unit = "mm"});
  for (const std::string& warning : part.warnings()) std::fprintf(stderr, "%s\n", warning.c_str());

  fingerpad::TouchWorld world;
  world.add(part, {.stiffness_n_per_m = 1000, .mu_static = 0.4, .mu_dynamic = 0.3});
  fingerpad::Finger finger(world, {.rate_hz = 1000, .friction = {"finger-pad", {{"v_min_m_per_s", 0.05}}}});

  const fingerpad::Vec3 low = part.lower_corner_m(), high = part.upper_corner_m();
  const fingerpad::Vec3 below(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), low.z() - 0.01);
  const fingerpad::ClosestPoint start = part.closest(below);
  for (int k = 0; k < 200; ++k) {
    fingerpad::FingerSample sample;
    sample.t_s = k / finger.rate_hz();
    sample.p_WQ = start.point_m + 1e-4 * k * fingerpad::Vec3::UnitX() - 1e-3 * start.normal;  // 0.1 m/s
    const fingerpad::TickRecord tick = finger.tick(sample);  // the servo loop is this line
    if (k % 20 != 0) continue;
    std::printf("%.3f s %-5s force (%6.3f, %6.3f, %6.3f) N\n", tick.t_s,
                fingerpad::phase_name(tick.phase).data(), tick.force_W_n.x(), tick.force_W_n.y(),
                tick.force_W_n.z());
  }
  return 0;
} catch (const fingerpad::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.kind());
}
