// Closest points: fingerpad's tree beside CGAL's and VTK's, in one run.
//   build/bin/bench_contact --benchmark_out=contact.json --benchmark_out_format=json
// Time is the mean of a query; the counter p99_ns is the 99th percentile of single queries, measured apart
// with the clock's own cost taken off. Every method answers the same points; answers that disagree by more
// than 1e-9 m end it.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "locator.hpp"
#include "meshes.hpp"
#include "query_paths.hpp"

namespace fingerpad::bench {
namespace {

using Clock = std::chrono::steady_clock;

struct Subject {
  std::string name;
  std::function<TriangleSoup()> mesh;
  std::function<std::vector<Vec3>(int)> coherent;
  std::shared_ptr<const Part> part{};
};

struct Method {
  std::string name;
  std::function<std::unique_ptr<Locator>(const std::shared_ptr<const Part>&)> make;
};

double nanoseconds(Clock::duration span) {
  return std::chrono::duration<double, std::nano>(span).count();
}

double percentile(std::vector<double> values, double part) {
  const auto place = values.begin() + static_cast<long>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The 99th percentile of single queries [ns].
double p99_ns(Locator& locator, const std::vector<Vec3>& points) {
  std::vector<double> empty, spans;
  for (const Vec3& q : points) {
    const auto start = Clock::now();
    const auto between = Clock::now();
    double d2 = locator.distance2_m2(q);
    benchmark::DoNotOptimize(d2);
    spans.push_back(nanoseconds(Clock::now() - between));
    empty.push_back(nanoseconds(between - start));
  }
  return percentile(spans, 0.99) - percentile(empty, 0.5);
}

void check_agreement(Locator& locator, Locator& ours, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); i += 997) {
    const double theirs = std::sqrt(locator.distance2_m2(points[i]));
    const double mine = std::sqrt(ours.distance2_m2(points[i]));
    if (std::abs(theirs - mine) > 1e-9) {
      std::fprintf(stderr, "distances disagree: %.17g and %.17g\n", theirs, mine);
      std::exit(1);
    }
  }
}

void run(benchmark::State& state, Subject& subject, const Method& method, bool coherent, int count) {
  if (!subject.part) subject.part = std::make_shared<const Part>(make_part(subject.mesh(), 0.5));
  const std::vector<Vec3> points = coherent ? subject.coherent(count) : random_in_box(*subject.part, count);
  const auto locator = method.make(subject.part);
  check_agreement(*locator, *make_tree_locator(subject.part), points);
  std::size_t i = 0;
  for (auto _ : state) {
    double d2 = locator->distance2_m2(points[i]);
    benchmark::DoNotOptimize(d2);
    if (++i == points.size()) i = 0;
  }
  state.counters["p99_ns"] = p99_ns(*locator, points);
  state.counters["triangles"] = subject.part->triangle_count();
}

void register_all(std::vector<Subject>& subjects) {
  static const std::vector<Method> methods = {
      {"fingerpad", [](const auto& part) { return make_tree_locator(part); }},
      {"cgal_hint", [](const auto& part) { return make_cgal_locator(*part); }},
#ifdef FINGERPAD_BENCH_VTK
      {"vtk_static", [](const auto& part) { return make_vtk_locator(*part); }},
#endif
  };
  for (Subject& subject : subjects) {
    for (const bool coherent : {true, false}) {
      for (const Method& method : methods) {
        const std::string name = subject.name + (coherent ? "/coherent/" : "/random/") + method.name;
        const int count = coherent ? 100000 : 2000;
        benchmark::RegisterBenchmark(name.c_str(),
                                     [&subject, &method, coherent, count](benchmark::State& state) {
                                       run(state, subject, method, coherent, count);
                                     });
      }
    }
  }
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  using namespace fingerpad::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  std::vector<Subject> subjects = {
      {"sphere_20k", [] { return icosphere(5); }, coherent_on_sphere},
      {"sphere_328k", [] { return icosphere(7); }, coherent_on_sphere},
      {"sphere_1311k", [] { return icosphere(8); }, coherent_on_sphere},
      {"drilled_plate", [] { return drilled_plate(); }, coherent_on_plate},
  };
  register_all(subjects);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
