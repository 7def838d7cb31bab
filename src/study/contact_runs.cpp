#include "study/contact_runs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

constexpr double stiffness_n_per_m = 1000, tick_s = 1e-3;
const Vec3 finger_direction = Vec3(0, 0.6, -0.8);

std::vector<TickRecord> run(Touch& touch, const std::vector<Vec3>& positions) {
  std::vector<TickRecord> rows;
  rows.reserve(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    rows.push_back(touch.tick({static_cast<double>(k) * tick_s, positions[k], finger_direction}));
  return rows;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// @param off_m  (row, exact foot): how far a tick's surface point is off
template <typename Off>
RubError rub_error_by(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                      const Rub& rub, Off off_m) {
  Scene scene = scene_of_variant(variant, "none");
  scene.finger.radius_m = rub.radius_m;
  Touch touch(world, scene);
  const std::vector<TickRecord> rows = run(touch, rub.positions);
  RubError error;
  Vec3 last_exact_n = Vec3::Zero();
  for (std::size_t k = rub.approach_ticks; k < rows.size(); ++k) {
    const TickRecord& row = rows[k];
    const ExactFoot& foot = rub.exact[k];
    const Vec3 exact_n = stiffness_n_per_m * (rub.radius_m - foot.signed_distance_m) * foot.normal;
    const double force_share = (row.force_W_n - exact_n).norm() / exact_n.norm();
    error.force_rms_share += force_share * force_share;
    error.force_worst_share = std::max(error.force_worst_share, force_share);
    if (k > rub.approach_ticks) {
      const double step_n = (row.force_W_n - rows[k - 1].force_W_n).norm();
      error.step_share = std::max(error.step_share, step_n / exact_n.norm());
      error.exact_step_share =
          std::max(error.exact_step_share, (exact_n - last_exact_n).norm() / exact_n.norm());
    }
    last_exact_n = exact_n;
    if (row.phase == Phase::free) {
      ++error.lost_ticks;
      continue;
    }
    const double position_m = std::abs(off_m(row, foot));
    const double turned_rad = angle_between(row.normal_W, foot.normal);
    error.position_rms_m += position_m * position_m;
    error.normal_rms_rad += turned_rad * turned_rad;
    error.position_worst_m = std::max(error.position_worst_m, position_m);
    error.normal_worst_rad = std::max(error.normal_worst_rad, turned_rad);
  }
  const auto ticks = static_cast<double>(rows.size() - rub.approach_ticks);
  const double held = std::max(1.0, ticks - static_cast<double>(error.lost_ticks));
  error.force_rms_share = std::sqrt(error.force_rms_share / ticks);
  error.position_rms_m = std::sqrt(error.position_rms_m / held);
  error.normal_rms_rad = std::sqrt(error.normal_rms_rad / held);
  return error;
}

/// The n-th variant's. Methods beyond the first two are drawn as these are, but dotted.
CurveStyle variant_style(std::size_t n) {
  using enum Marker;
  constexpr Dash solid = Dash::solid, dashed = Dash::dashed;
  constexpr CurveStyle styles[] = {{0, dashed, ring, 1.5},    {6, dashed, square, 1.3},
                                   {2, dashed, diamond, 1.2}, {1, solid, disc, 0.9},
                                   {4, solid, triangle, 0.8}, {3, solid, cross, 0.7}};
  CurveStyle style = styles[n % std::size(styles)];
  if (n >= std::size(styles)) style.dash = Dash::dotted;
  return style;
}

/// What each piece of so many ticks takes [s], the best of several runs.
std::vector<double> best_times_s(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                                 const Rub& rub, const std::string& law, std::size_t piece_ticks) {
  constexpr int runs = 10;
  Scene scene = scene_of_variant(variant, law);
  scene.finger.radius_m = rub.radius_m;
  Touch touch(world, scene);
  const std::size_t ticks = rub.positions.size();
  std::vector<double> best_s((ticks + piece_ticks - 1) / piece_ticks, HUGE_VAL);
  for (int i = 0; i < runs; ++i) {
    touch.reset();
    for (std::size_t piece = 0; piece < best_s.size(); ++piece) {
      double sum = 0;  // of forces, so that nothing is left out
      const auto start = std::chrono::steady_clock::now();
      for (std::size_t k = piece * piece_ticks; k < std::min(ticks, (piece + 1) * piece_ticks); ++k)
        sum +=
            touch.tick({static_cast<double>(k) * tick_s, rub.positions[k], finger_direction}).force_W_n.x();
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      if (std::isfinite(sum)) best_s[piece] = std::min(best_s[piece], took.count());
    }
  }
  return best_s;
}

}  // namespace

const std::vector<ContactVariant>& contact_variants() {
  static const std::vector<ContactVariant> variants = [] {
    std::vector<ContactVariant> all;
    for (const ContactMethodEntry& method : contact_method_table()) {
      for (const Normals normals : normals_table()) {
        all.push_back(
            {normals, std::string(method.name), std::string(normals->name), variant_style(all.size())});
      }
    }
    return all;
  }();
  return variants;
}

std::shared_ptr<const World> world_of_mesh(const TriangleSoup& soup, const std::string& name) {
  return world_of_part(std::make_shared<const Part>(make_part(soup, std::numbers::pi / 6)), name);
}

std::shared_ptr<const World> world_of_part(std::shared_ptr<const Part> part, const std::string& name) {
  Surface surface;
  surface.mesh = name;
  surface.properties.stiffness_n_per_m = stiffness_n_per_m;
  surface.part = std::move(part);
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.tree->prepare_curved();
  auto world = std::make_shared<World>();
  world->surfaces.push_back(std::move(surface));
  return world;
}

Scene scene_of_variant(const ContactVariant& variant, const std::string& law) {
  Scene scene;
  scene.name = "study";
  scene.contact.method = variant.method_name;
  scene.contact.normals = variant.normals;
  scene.friction.law = law;
  scene.motion.rate_hz = 1 / tick_s;
  return scene;
}

AutomaticChoice automatic_choice(const World& world, double finger_radius_m, double greatest_force_n) {
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.contact.greatest_force_n = greatest_force_n;
  scene.finger.radius_m = finger_radius_m;
  scene.motion.rate_hz = 1 / tick_s;
  const Surface& surface = world.surfaces[0];
  const PartMeasures measures = measure_part(*surface.part, *surface.tree);
  const ContactChoice choice = choose_contact(scene, world.surfaces, {&measures, 1});
  const auto& all = contact_variants();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ContactVariant& v) {
    return v.method_name == choice.method && v.normals == choice.normals;
  });
  return {&*found, choice.reasons.at(0)};
}

Rub rub_under(const ExactSurface& surface, double under_m, double radius_m) {
  constexpr int ticks = 4000;
  Rub rub;
  rub.approach_ticks = 40;
  rub.radius_m = radius_m;
  const auto place = [&](double along, double below_m) {
    const Vec3 on = surface.way(along);
    return Vec3(on - below_m * surface.foot(on).normal);
  };
  // As far outside as it will be deep.
  const double from_m = -std::min(under_m + 2 * radius_m, surface.highest_m);
  for (std::size_t k = 0; k < rub.approach_ticks; ++k) {
    const double done = static_cast<double>(k) / static_cast<double>(rub.approach_ticks);
    rub.positions.push_back(place(0, from_m + done * (under_m - from_m)));
  }
  for (int k = 0; k < ticks; ++k) rub.positions.push_back(place(static_cast<double>(k) / ticks, under_m));
  rub.exact.reserve(rub.positions.size());
  for (const Vec3& position : rub.positions) rub.exact.push_back(surface.foot(position));
  return rub;
}

RubError rub_error(const std::shared_ptr<const World>& world, const ExactSurface& surface,
                   const ContactVariant& variant, const Rub& rub) {
  return rub_error_by(world, variant, rub, [&](const TickRecord& row, const ExactFoot&) {
    return surface.foot(row.contact_W).signed_distance_m;
  });
}

RubError rub_error(const std::shared_ptr<const World>& world, const ContactVariant& variant, const Rub& rub) {
  return rub_error_by(world, variant, rub, [&](const TickRecord& row, const ExactFoot& foot) {
    return row.depth_m - (rub.radius_m - foot.signed_distance_m);
  });
}

double rub_tick_ns(const std::shared_ptr<const World>& world, const ContactVariant& variant, const Rub& rub,
                   const std::string& law) {
  constexpr std::size_t piece_ticks = 200;
  const std::vector<double> pieces_s = best_times_s(world, variant, rub, law, piece_ticks);
  return std::accumulate(pieces_s.begin(), pieces_s.end(), 0.0) * 1e9 /
         static_cast<double>(rub.positions.size());
}

double rub_slowest_tick_ns(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                           const Rub& rub, const std::string& law) {
  const std::vector<double> ticks_s = best_times_s(world, variant, rub, law, 1);
  return *std::max_element(ticks_s.begin(), ticks_s.end()) * 1e9;
}

double edge_step_share(const std::shared_ptr<const World>& block, const ContactVariant& variant,
                       double speed_m_per_s) {
  constexpr double depth_m = 3e-3, edge_m = 0.03, from_m = 0.02;
  constexpr int press_ticks = 40;
  const double step_m = speed_m_per_s * tick_s;
  std::vector<Vec3> positions;
  positions.reserve(press_ticks);
  for (int k = 0; k < press_ticks; ++k) positions.emplace_back(from_m, 1e-3, 1e-3 - 1e-4 * k);
  const std::size_t pressed = positions.size();
  const int slide_ticks = static_cast<int>((edge_m + 2 * depth_m - from_m) / step_m) + 2;
  for (int k = 0; k < slide_ticks; ++k) positions.emplace_back(from_m + k * step_m, 1e-3, -depth_m);
  Touch touch(block, scene_of_variant(variant, "none"));
  const std::vector<TickRecord> rows = run(touch, positions);
  double worst_n = 0;
  for (std::size_t k = pressed + 1; k < rows.size(); ++k)
    worst_n = std::max(worst_n, (rows[k].force_W_n - rows[k - 1].force_W_n).norm());
  return worst_n / (stiffness_n_per_m * depth_m);
}

bool pops_through(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                  const Strike& strike) {
  return pops_through(world, variant, strike, Vec3(strike.at_m.x(), strike.at_m.y(), 0), Vec3::UnitZ());
}

bool pops_through(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                  const Strike& strike, const Vec3& surface_m, const Vec3& normal) {
  constexpr int held_ticks = 20;
  Scene scene = scene_of_variant(variant, "none");
  scene.finger.radius_m = strike.radius_m;
  Touch touch(world, scene);
  std::vector<Vec3> positions;
  const double step_m = strike.speed_m_per_s * tick_s, end_m = strike.radius_m - strike.depth_m;
  const auto at = [&](double above_m) { return Vec3(surface_m + above_m * normal); };
  const double start_m = strike.radius_m + strike.from_m + strike.phase * step_m;
  for (int k = 0; start_m - k * step_m > end_m; ++k) positions.push_back(at(start_m - k * step_m));
  for (int k = 0; k < held_ticks; ++k) positions.push_back(at(end_m));
  return !(run(touch, positions).back().force_W_n.dot(normal) > stiffness_n_per_m * strike.depth_m / 2);
}

}  // namespace fingerpad
