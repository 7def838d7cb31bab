// Tells where points stand against a part: closest_points bracket.stl
#include <cstdio>
#include <fingerpad/fingerpad.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) throw fingerpad::Error(fingerpad::ErrorKind::usage, "closest_points", "name a mesh");
  const fingerpad::PartSurface part(argv[1], {.unit = "mm"});
  for (const fingerpad::Vec3 p_m : {part.lower_corner_m(), part.upper_corner_m()}) {
    const fingerpad::ClosestPoint near = part.closest(p_m);
    std::printf("%.4f mm from triangle %d at (%.4f, %.4f, %.4f) m, normal (%.3f, %.3f, %.3f)\n",
                1e3 * near.signed_distance_m, near.triangle, near.point_m.x(), near.point_m.y(),
                near.point_m.z(), near.normal.x(), near.normal.y(), near.normal.z());
  }
  return 0;
} catch (const fingerpad::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.kind());
}
