#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"
#include "contact/reckoned_error.hpp"
#include "touch/error_memory.hpp"

namespace fingerpad {

struct Part;
struct Scene;
struct Surface;

/// One part of a scene, and what the scene asks of contact with it.
struct ContactCase {
  std::string file;  ///< the mesh's, without its folder
  ContactDemand contact;
  Press press;
  double across_m = 0;  ///< of the part
  double mu_tolerance = 0;
  double mean_tilt_rad = 0;  ///< that the tolerance of friction allows; infinity where there is no friction
  int finer = 1;             ///< it is reckoned as if its facets were so many times smaller
};

/// What a finger of some size meets of a part's surroundings.
struct Nearby {
  CrowdedHollow crowded{};
  bool has_neighbour = false;
};

/// The second of a part's three extents: a plate is as wide as its shorter side, a rod as it is thick [m].
double across_m(const Part& part) noexcept;

/// Whether another surface stands nearer to this one than a finger is wide.
bool has_neighbour(std::span<const Surface> surfaces, const Surface& surface, double finger_radius_m);

/// @param measures  of the surface's part; they outlive the case
ContactCase contact_case(const Scene& scene, const Surface& surface, const PartMeasures& measures,
                         const Nearby& nearby);

/// @param surfaces  parts first
/// @param measures  one for each part, which outlives the cases
std::vector<ContactCase> contact_cases(const Scene& scene, std::span<const Surface> surfaces,
                                       std::span<const PartMeasures> measures);

/// Beyond a third of the force reckoning says nothing, and an error of mu as large as mu is no tolerance.
inline constexpr double most_force_kept = 1.0 / 3, most_mu_kept = 1;

/// A contact method with normals, rows of their tables, and what is reckoned of them.
struct ContactPair {
  const ContactMethodEntry* method;
  Normals normals;
  double cost = 0;                         ///< of a tick's contact (contact_cost.hpp)
  std::vector<ReckonedError> errors = {};  ///< one a part
  std::vector<std::string> fails = {};     ///< one a part: why the method cannot do there; empty where it can

  bool touches_own_surface() const { return method->touches_own_surface && normals->own_surface != nullptr; }
  bool holds() const;
  /// Whether the contact goes round every rounding with the finger, as far as the tolerance asks: on plain
  /// facets a proxy that falls behind there does not get round at all.
  bool gets_round(std::span<const ContactCase> cases) const;
  /// The error on part i in tolerances, the force's or the normals' tilt's: 1 and less are kept.
  double tolerances(std::span<const ContactCase> cases, std::size_t i) const;
  /// The largest there is.
  double tolerances(std::span<const ContactCase> cases) const;
  /// By how many times it misses them from the lightest press to the hardest, on geometric mean: 1 where it
  /// keeps them under all. The largest there is.
  double misses(std::span<const ContactCase> cases) const;
  /// The same as far as reckoning says anything: no error counts as more than could be kept (most_force_kept,
  /// most_mu_kept).
  double told_misses(std::span<const ContactCase> cases) const;
};

/// Every pair that `auto` may take for a scene: those it leaves open, with all errors reckoned.
/// @param errors  those that were reckoned before, and from now on these
std::vector<ContactPair> contact_pairs(const Scene& scene, std::span<const Surface> surfaces,
                                       std::span<const ContactCase> cases, ErrorMemory& errors);

}  // namespace fingerpad
