// Closest points: fingerpad's tree beside one Embree primitive a triangle, a hand-written tree over the same
// packets, CGAL's and VTK's, in one run.
//   build/bin/bench_contact --benchmark_out=contact.json --benchmark_out_format=json
//   (on a busy machine: --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true)
// MESH/coherent: 0.1 m/s at 1 kHz within 2 mm of the surface; MESH/random: anywhere in the box; MESH/cold:
// coherent, but caches are evicted before every query. MESH/build: making the tree, with its
// bytes_a_triangle. Time is the mean of a query (of cold ones: mean_ns, the clock's own cost taken off);
// p99_ns is the 99th percentile of single queries. MESH/.../paired_with_METHOD asks fingerpad and the other
// in turn, some thousand queries each, and gives the median ratio times_faster: it holds on a busy machine
// too. Every method answers the same points; answers that disagree by more than 1e-9 m end it.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <numeric>
#include <string>

#include "contact/triangle_tree.hpp"
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
  std::map<std::string, std::shared_ptr<Locator>> locators{};
};

struct Method {
  std::string name;
  std::function<std::unique_ptr<Locator>(const std::shared_ptr<const Part>&)> make;
};

double nanoseconds(Clock::duration span) {
  return std::chrono::duration<double, std::nano>(span).count();
}

/// Time that this thread has run.
double thread_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
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

Locator& locator_of(Subject& subject, const Method& method) {
  if (!subject.part) subject.part = std::make_shared<const Part>(make_part(subject.mesh(), 0.5));
  auto& locator = subject.locators[method.name];
  if (!locator) locator = method.make(subject.part);
  return *locator;
}

void run(benchmark::State& state, Subject& subject, const Method& method, bool coherent, int count) {
  Locator* locator = &locator_of(subject, method);
  const std::vector<Vec3> points = coherent ? subject.coherent(count) : random_in_box(*subject.part, count);
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

/// Queries with nothing of the mesh in any cache.
void run_cold(benchmark::State& state, Subject& subject, const Method& method) {
  constexpr int count = 200, spacing = 400;
  Locator& locator = locator_of(subject, method);
  const std::vector<Vec3> points = subject.coherent(count * spacing);
  std::vector<char> other(std::size_t{64} << 20);  // larger than any cache here
  std::vector<double> spans;
  for (auto _ : state) {
    for (int i = 0; i < count; ++i) {
      double near = locator.distance2_m2(points[i * spacing]);  // so that the hint is the last tick's
      for (std::size_t k = 0; k < other.size(); k += 64) ++other[k];
      benchmark::DoNotOptimize(other.data());
      const auto start = Clock::now();
      const auto between = Clock::now();
      double d2 = locator.distance2_m2(points[i * spacing + 1]);
      benchmark::DoNotOptimize(d2 += near);
      spans.push_back(nanoseconds(Clock::now() - between) - nanoseconds(between - start));
    }
  }
  // Means without the worst hundredth: on a shared machine that is the scheduler.
  std::sort(spans.begin(), spans.end());
  const auto kept = static_cast<std::ptrdiff_t>(spans.size() - spans.size() / 100);
  state.counters["mean_ns"] =
      std::accumulate(spans.begin(), spans.begin() + kept, 0.0) / static_cast<double>(kept);
  state.counters["p99_ns"] = percentile(spans, 0.99);
  state.SetItemsProcessed(state.iterations() * count);
}

/// fingerpad and another method in turn, a few thousand queries each: a ratio that holds on a busy
/// machine.
void run_paired(benchmark::State& state, Subject& subject, const Method& ours, const Method& other,
                bool coherent) {
  const int count = coherent ? 100000 : 2000, chunk = coherent ? 4000 : 200;
  Locator* pair[2] = {&locator_of(subject, ours), &locator_of(subject, other)};
  const std::vector<Vec3> points = coherent ? subject.coherent(count) : random_in_box(*subject.part, count);
  std::vector<double> ratios, means[2];
  int at = 0;
  for (auto _ : state) {
    double mean[2];
    for (int which = 0; which < 2; ++which) {
      const double start = thread_ns();
      for (int i = 0; i < chunk; ++i) {
        double d2 = pair[which]->distance2_m2(points[at + i]);
        benchmark::DoNotOptimize(d2);
      }
      mean[which] = (thread_ns() - start) / chunk;
      means[which].push_back(mean[which]);
    }
    ratios.push_back(mean[1] / mean[0]);
    at = (at + chunk) % (count - chunk);
  }
  state.counters["fingerpad_ns"] = percentile(means[0], 0.5);
  state.counters["other_ns"] = percentile(means[1], 0.5);
  state.counters["times_faster"] = percentile(ratios, 0.5);
}

/// Making a tree, and what it takes.
void run_build(benchmark::State& state, Subject& subject) {
  if (!subject.part) subject.part = std::make_shared<const Part>(make_part(subject.mesh(), 0.5));
  double bytes = 0;
  for (auto _ : state) {
    const TriangleTree tree(subject.part);
    bytes = static_cast<double>(tree.memory_bytes());
  }
  state.counters["bytes_a_triangle"] = bytes / subject.part->triangle_count();
}

void register_all(std::vector<Subject>& subjects) {
  static const std::vector<Method> methods = {
      {"fingerpad", [](const auto& part) { return make_tree_locator(part); }},
      {"one_by_one", [](const auto& part) { return make_one_by_one_locator(part); }},
      {"wide_tree", [](const auto& part) { return make_wide_tree_locator(part); }},
      {"cgal_hint", [](const auto& part) { return make_cgal_locator(*part); }},
#ifdef FINGERPAD_BENCH_VTK
      {"vtk_static", [](const auto& part) { return make_vtk_locator(*part); }},
#endif
  };
  for (Subject& subject : subjects) {
    benchmark::RegisterBenchmark((subject.name + "/build").c_str(),
                                 [&subject](benchmark::State& state) { run_build(state, subject); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
    for (std::size_t k = 1; k < methods.size(); ++k) {
      for (const bool coherent : {true, false}) {
        const std::string name =
            subject.name + (coherent ? "/coherent" : "/random") + "/paired_with_" + methods[k].name;
        benchmark::RegisterBenchmark(name.c_str(), [&subject, k, coherent](benchmark::State& state) {
          run_paired(state, subject, methods[0], methods[k], coherent);
        })->Iterations(coherent ? 100 : 20);
      }
    }
    for (const Method& method : methods) {
      benchmark::RegisterBenchmark(
          (subject.name + "/cold/" + method.name).c_str(),
          [&subject, &method](benchmark::State& state) { run_cold(state, subject, method); })
          ->Iterations(3);
    }
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
      {"sphere_1k", [] { return icosphere(3); }, coherent_on_sphere},
      {"sphere_20k", [] { return icosphere(5); }, coherent_on_sphere},
      {"sphere_328k", [] { return icosphere(7); }, coherent_on_sphere},
      {"sphere_1311k", [] { return icosphere(8); }, coherent_on_sphere},
      {"drilled_plate", [] { return drilled_plate(); }, coherent_on_plate},
  };
  register_all(subjects);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
