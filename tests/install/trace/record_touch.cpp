// Slides a finger over a plane, records it, and reads the trace again: record_touch slide.h5
#include <cstdio>
#include <fingerpad/fingerpad.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) throw fingerpad::Error(fingerpad::ErrorKind::usage, "record_touch", "name a trace");
  fingerpad::TouchWorld world;
  world.add_plane({0, 0, 0}, {0, 0, 1});
  fingerpad::Finger finger(world);
  fingerpad::TraceRecorder recorder(argv[1], finger);
  for (int k = 0; k < 100; ++k) {
    fingerpad::FingerSample sample;
    sample.t_s = k / finger.rate_hz();
    sample.p_WQ = fingerpad::Vec3(5e-4 * k, 0, -1e-3);
    recorder.append(finger.tick(sample));
  }
  recorder.finish();

  const fingerpad::TraceFile trace = fingerpad::read_trace_file(argv[1]);
  const fingerpad::TickRecord& last = trace.rows.back();
  std::printf("%zu ticks, the last with mu %.3f\n", trace.rows.size(), last.mu);
  return trace.complete && trace.rows.size() == 100 && last.mu > 0.199 && last.mu < 0.201 ? 0 : 1;
} catch (const fingerpad::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.kind());
}
