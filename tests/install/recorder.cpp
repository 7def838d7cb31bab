#include <cstdio>

#include "scene/scene.hpp"
#include "touch/touch.hpp"
#include "trace/trace_writer.hpp"

// Slides a finger over a plane and keeps its trace: what a rig that records does.
int main() {
  using namespace fingerpad;
  auto world = std::make_shared<World>();
  world->surfaces.emplace_back();
  Touch touch(world, Scene());
  const char* path = "recorder.h5";
  const auto writer = TraceWriter::create(path, TraceFormat::hdf5, TraceInfo(), *world);
  for (int k = 0; k < 100; ++k) {
    FingerSample finger;
    finger.t_s = 0.001 * k;
    finger.p_WQ = Vec3(0.0005 * k, 0, -0.001);
    const TickRecord row = touch.tick(finger);
    writer->append({&row, 1});
  }
  writer->finish();
  const Trace trace = read_trace(path);
  std::printf("%zu ticks in %s\n", trace.rows.size(), path);
  return trace.complete && trace.rows.size() == 100 ? 0 : 1;
}
