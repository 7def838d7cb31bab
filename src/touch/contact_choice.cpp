#include "touch/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "touch/world.hpp"

namespace fingerpad {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double right_angle_rad = std::numbers::pi / 2;

/// What one part needs, and why.
template <typename What>
struct Need {
  What what;
  std::string why;
};

std::string millimetres(double length_m) {
  return fmt::format("{:.3g} mm", 1e3 * length_m);
}

/// The scene's greatest press on a part.
struct Press {
  double depth_m = 0;         ///< of the finger's surface
  double centre_depth_m = 0;  ///< of its centre, one tick's motion on; negative: it stays outside
  std::string text;           ///< "10 N at 1000 N/m presses 10 mm deep"
};

Press press_of(const Scene& scene, double stiffness_n_per_m) {
  const double force_n = scene.contact.greatest_force_n, radius_m = scene.finger.radius_m;
  Press press;
  press.depth_m = force_n / stiffness_n_per_m;
  press.centre_depth_m = press.depth_m - radius_m + choice_speed_m_per_s / scene.motion.rate_hz;
  press.text = fmt::format("{:.3g} N at {:.4g} N/m presses {}{} deep", force_n, stiffness_n_per_m,
                           radius_m > 0 ? fmt::format("a {} finger ", millimetres(radius_m)) : "",
                           millimetres(press.depth_m));
  return press;
}

/// Why the part's inside is not known; empty where it is.
std::string unknown_inside(const PartMeasures& part) {
  if (part.open_edges > 0)
    return fmt::format("the mesh is not closed ({} edges without one neighbour)", part.open_edges);
  if (part.contradicting_edges > 0) return "its facets are wound against each other";
  if (part.overlap_count > 0)
    return "it overlaps itself, and inside of another body the nearest surface is no wall";
  return part.volume_m3 < 0 ? "it is inside out" : "";
}

/// Why a pressed finger would come out on the far side; empty where it would not.
std::string way_through(const PartMeasures& part, const Press& press) {
  if (press.centre_depth_m <= 0) return {};
  if (part.thinnest_m <= 2 * press.centre_depth_m)
    return fmt::format("walls are {} thick and {}", millimetres(part.thinnest_m), press.text);
  if (part.sharpest_ridge_rad < opposite_turn_rad) return {};
  return fmt::format("an edge is as sharp as {:.0f} degrees and {}", 180 - degrees * part.sharpest_ridge_rad,
                     press.text);
}

/// Why the finger touches more than the nearest surface; empty where the nearest is enough.
std::string second_wall(const PartMeasures& part, const Scene& scene) {
  const double radius_m = scene.finger.radius_m, tolerance = scene.contact.force_tolerance;
  if (!(radius_m > 0)) return {};
  if (std::sin(part.sharpest_valley_rad / 2) > tolerance)
    return fmt::format("a {} finger touches two walls at once where they meet at {:.0f} degrees",
                       millimetres(radius_m), 180 - degrees * part.sharpest_valley_rad);
  if (part.tightest_hollow_m < radius_m && std::sin(right_angle_rad / 2) > tolerance)
    return fmt::format("a {} finger bridges hollows of {} radius", millimetres(radius_m),
                       millimetres(part.tightest_hollow_m));
  return {};
}

/// The part's box in the world, as middle and half extents [m].
struct WorldBox {
  Vec3 middle, half;
};

WorldBox box_of(const Surface& surface) {
  return {surface.R_WP * surface.part->centre_P + surface.p_WP,
          surface.R_WP.cwiseAbs() * surface.part->half_extent};
}

/// Whether another surface is within `width_m` of the part's box.
bool has_neighbour(std::span<const Surface> surfaces, const Surface& part, double width_m) {
  const WorldBox box = box_of(part);
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const Surface& other) {
    if (&other == &part) return false;
    if (!other.part) {
      const double middle_m = other.plane_normal_W.dot(box.middle - other.plane_point_W);
      return middle_m - other.plane_normal_W.cwiseAbs().dot(box.half) <= width_m;
    }
    const WorldBox beside = box_of(other);
    return ((beside.middle - box.middle).cwiseAbs() - beside.half - box.half).maxCoeff() <= width_m;
  });
}

Need<ContactMethod> method_for(const Scene& scene, std::span<const Surface> surfaces, const Surface& surface,
                               const PartMeasures& part) {
  const Press press = press_of(scene, surface.properties.stiffness_n_per_m);
  for (std::string why :
       {unknown_inside(part), way_through(part, press), second_wall(part, scene),
        std::string(has_neighbour(surfaces, surface, 2 * scene.finger.radius_m)
                        ? "another surface is so near that the finger can touch both at once"
                        : "")}) {
    if (!why.empty()) return {ContactMethod::proxy, std::move(why)};
  }
  if (press.centre_depth_m <= 0) {
    return {ContactMethod::closest_point,
            press.text + " and no more: its centre stays outside, and it touches one wall at a time"};
  }
  if (!std::isfinite(part.thinnest_m))
    return {ContactMethod::closest_point, "it is closed and has no walls that face away from each other"};
  return {ContactMethod::closest_point,
          fmt::format("walls are {} thick or more and {}", millimetres(part.thinnest_m), press.text)};
}

/// @param method  that the world gets: the proxy stands on the facets, whatever its normals
Need<Normals> normals_for(const Scene& scene, const Surface& surface, const PartMeasures& part,
                          ContactMethod method) {
  const ContactSettings& contact = scene.contact;
  const double mu = surface.properties.mu_dynamic, turn_rad = part.largest_smooth_turn_rad;
  double tilt_rad = contact.force_tolerance;
  if (mu > 0) tilt_rad = std::min(tilt_rad, contact.mu_tolerance * mu);
  if (turn_rad == 0) return {Normals::facet, "its faces are flat"};
  const std::string turn = fmt::format(
      "its facets turn by {:.2g} degrees where they stand for a smooth surface", degrees * turn_rad);
  if (turn_rad / 2 <= tilt_rad) return {Normals::facet, turn + " and no more"};
  const double greatest_depth_m = contact.greatest_force_n / surface.properties.stiffness_n_per_m;
  if (part.largest_sag_m <= contact.force_tolerance * greatest_depth_m) return {Normals::smooth, turn};
  const std::string sag =
      fmt::format("its facets cut {} into a smooth surface", millimetres(part.largest_sag_m));
  if (method != ContactMethod::proxy) return {Normals::curved, sag};
  return {Normals::smooth,
          turn + "; " + sag + ", beyond the tolerance, and a proxy stands on them: use a finer mesh"};
}

std::string file_of(const Surface& surface) {
  return std::filesystem::path(surface.mesh).filename().string();
}

/// What all parts get, because one of them needs the most.
template <typename What>
struct Shared {
  What what;
  std::size_t needed_by = 0;

  explicit Shared(const std::vector<Need<What>>& needs) : what(needs.front().what) {
    for (std::size_t i = 1; i < needs.size(); ++i) {
      if (!(needs[i].what > what)) continue;
      what = needs[i].what;
      needed_by = i;
    }
  }
  std::string why(const std::vector<Need<What>>& needs, std::size_t i,
                  std::span<const Surface> surfaces) const {
    return needs[i].what == what ? needs[i].why : file_of(surfaces[needed_by]) + " needs it";
  }
};

}  // namespace

bool leaves_a_choice(const ContactSettings& contact) noexcept {
  return contact.method == ContactMethod::automatic || contact.automatic_normals;
}

ContactChoice choose_contact(const Scene& scene, std::span<const Surface> surfaces,
                             std::span<const PartMeasures> measures) {
  const ContactSettings& asked = scene.contact;
  const bool method_open = asked.method == ContactMethod::automatic;
  ContactChoice choice;
  choice.normals = asked.normals;
  if (!method_open) choice.method = asked.method;
  if (!leaves_a_choice(asked) || measures.empty()) return choice;

  std::vector<Need<ContactMethod>> methods;
  for (std::size_t i = 0; i < measures.size(); ++i)
    methods.push_back(method_for(scene, surfaces, surfaces[i], measures[i]));
  const Shared<ContactMethod> method(methods);
  if (method_open) choice.method = method.what;
  std::vector<Need<Normals>> normals;
  for (std::size_t i = 0; i < measures.size(); ++i)
    normals.push_back(normals_for(scene, surfaces[i], measures[i], choice.method));
  const Shared<Normals> shared_normals(normals);
  if (asked.automatic_normals) choice.normals = shared_normals.what;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    std::string line = file_of(surfaces[i]) + ": ";
    if (method_open)
      line += fmt::format("{}, because {}", method_name(method.what), method.why(methods, i, surfaces));
    if (method_open && asked.automatic_normals) line += "; ";
    if (asked.automatic_normals) {
      line += fmt::format("{} normals, because {}", normals_name(shared_normals.what),
                          shared_normals.why(normals, i, surfaces));
    }
    choice.reasons.push_back(line + " (auto)");
  }
  return choice;
}

ContactChoice settled_contact(const Scene& scene, const World& world) {
  ContactChoice settled;
  if (world.contact) settled = *world.contact;
  if (scene.contact.method != ContactMethod::automatic) settled.method = scene.contact.method;
  if (!scene.contact.automatic_normals) settled.normals = scene.contact.normals;
  return settled;
}

std::string_view method_name(ContactMethod method) noexcept {
  constexpr std::string_view names[] = {"auto", "closest-point", "proxy"};
  return names[static_cast<std::size_t>(method)];
}

std::string_view normals_name(Normals normals) noexcept {
  constexpr std::string_view names[] = {"facet", "smooth", "curved"};
  return names[static_cast<std::size_t>(normals)];
}

std::string_view method_in(const World& world, ContactMethod method) noexcept {
  const bool planes_only = std::none_of(world.surfaces.begin(), world.surfaces.end(),
                                        [](const Surface& surface) { return surface.part != nullptr; });
  return planes_only ? "plane" : method_name(method);
}

}  // namespace fingerpad
