// Writes a large synthetic measurement: the known trials of tests/support/pad_measurement over and over,
// through sensors with noise, tare, hum and delay, until there are as many samples. usage: bench_fit_large
// FILE SAMPLES
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "base/random_stream.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad {
namespace {

int write_large(const char* path, long samples) {
  std::ofstream file(path);
  file << "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dy,dz,subject,trial\n";
  const std::vector<test::KnownTrial> trials = test::known_trials();
  RandomStream random(1);
  int number = 0;
  for (long written = 0; written < samples;) {
    const test::KnownTrial& trial = trials[static_cast<std::size_t>(number++) % trials.size()];
    for (const test::KnownRow& row :
         test::measured_rows(test::of_subject({}, trial.subject), test::bad_sensors(), trial, random)) {
      ++written;
      const Vec3 &p = row.position_W, &f = row.force_W, &d = row.direction_W;
      file << fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f},{:.4g},{:.4g},{:.4g},{},{}\n",
                          row.t_s, p.x(), p.y(), p.z(), f.x(), f.y(), f.z(), d.x(), d.y(), d.z(),
                          trial.subject, number);
    }
  }
  return file.flush() ? 0 : 1;
}

}  // namespace
}  // namespace fingerpad

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: bench_fit_large FILE SAMPLES\n", stderr), 2;
  return fingerpad::write_large(argv[1], std::atol(argv[2]));
}
