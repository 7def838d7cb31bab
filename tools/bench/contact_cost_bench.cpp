// The table of src/contact/contact_cost.cpp, measured on this machine: bench_contact_cost prints its rows.
// Each is what a tick without friction costs on tori of 256 to a million triangles, in units of closest-point
// with facets under a point on 1024; the best of several turns, in which all take turns. Takes a minute.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "study/contact_runs.hpp"

namespace {
using namespace fingerpad;

constexpr std::array levels{8, 16, 32, 64, 128, 256, 512};
constexpr int turns = 3;

/// By variant, a level.
std::vector<std::vector<double>> measured_ns(double radius_m) {
  const auto surfaces = exact_surfaces();
  const auto torus =
      std::find_if(surfaces.begin(), surfaces.end(), [](const ExactSurface& s) { return s.name == "torus"; });
  const Rub rub = rub_under(*torus, rub_depth_m - radius_m, radius_m);
  std::vector<std::vector<double>> ns(contact_variants().size());
  for (const int level : levels) {
    const auto world = world_of_mesh(torus->mesh(level), torus->name);
    for (auto& of_variant : ns) of_variant.push_back(HUGE_VAL);
    for (int turn = 0; turn < turns; ++turn) {
      for (std::size_t v = 0; v < ns.size(); ++v)
        ns[v].back() = std::min(ns[v].back(), rub_tick_ns(world, contact_variants()[v], rub, "none"));
    }
  }
  return ns;
}

}  // namespace

int main() {
  double unit_ns = 0;
  for (const double radius_m : {0.0, 0.007}) {
    const auto ns = measured_ns(radius_m);
    if (radius_m == 0) unit_ns = ns[0][1];
    for (std::size_t v = 0; v < ns.size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      fmt::print("    {{\"{}\", \"{}\", {}, {{", variant.method_name, variant.normals_name, radius_m > 0);
      for (std::size_t i = 0; i < ns[v].size(); ++i)
        fmt::print("{}{:.2f}", i > 0 ? ", " : "", ns[v][i] / unit_ns);
      fmt::print("}}}},\n");
    }
  }
  fmt::print("// in units of {:.0f} ns\n", unit_ns);
}
