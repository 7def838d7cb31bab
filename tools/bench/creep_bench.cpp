// A block at rest beside the engines that people use: fingerpad, MuJoCo and Bullet hold it against a push
// below the limit of friction, and let a spring pull it. Writes all figures as CSV and a chart, and prints
// the README's table, where the heads of the periods are what theory asks for.
//   build/bin/bench_creep CREEP.csv CHART.svg
// The engines have one coefficient of friction, 0.3, as fingerpad's coulomb has here; the other laws have 0.3
// and 0.2. A step is all that each does in a tick: the engines look for contacts and solve for a free box,
// fingerpad answers one finger on a plane. Laws and engines have their defaults, but for what their rows name
// and for the pull: 10 kHz, stick of 500 1/m, v_min 2 mm/s, Karnopp's band 0.1 mm/s.

#include <fmt/format.h>

#include <exception>
#include <iostream>

#include "creep_chart.hpp"
#include "trace/output_file.hpp"
#include "view/plot.hpp"

namespace fingerpad::bench {
namespace {

constexpr double shares[] = {0.3, 0.5, 0.7, 0.9, 0.95, 0.99};
constexpr double pull_rate_hz = 10000;

std::vector<CreepFindings> measure() {
  std::vector<Program> programs;
  for (const auto& some : {fingerpad_programs(), mujoco_programs(), bullet_programs()})
    programs.insert(programs.end(), some.begin(), some.end());
  const std::vector<double> step_ns = step_times_ns(programs);
  std::vector<CreepFindings> findings;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const Program& program = programs[i];
    std::cerr << program.name << " ...\n";
    CreepFindings one{program, {}, {}, {}, step_ns[i]};
    for (const double share : shares) one.held.push_back(hold(program, share));
    one.undamped = pull(program, undamped_block, pull_rate_hz);
    one.damped = pull(program, damped_block, pull_rate_hz);
    findings.push_back(std::move(one));
  }
  return findings;
}

int run(const std::string& csv_path, const std::string& chart_path) {
  const std::vector<CreepFindings> findings = measure();
  OutputFile csv(csv_path);
  csv.write(creep_csv(findings));
  csv.commit();
  write_chart(creep_chart(findings), chart_path);
  fmt::print("{}", creep_table(findings));
  return 0;
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: bench_creep CREEP.csv CHART.svg\n";
    return 2;
  }
  try {
    return fingerpad::bench::run(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::cerr << "bench_creep: " << e.what() << "\n";
    return 1;
  }
}
