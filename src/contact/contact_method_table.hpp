#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contact/contact_method.hpp"
#include "contact/crowded_hollow.hpp"
#include "contact/normals.hpp"

namespace fingerpad {

struct PartMeasures;
struct PlacedSurface;

/// What a scene asks of contact with one of its parts: what `auto` decides by.
struct ContactDemand {
  const PartMeasures& part;
  double finger_radius_m = 0;
  double force_tolerance = 0;  ///< error of the force that is allowed, as a fraction of it
  double centre_depth_m = 0;   ///< that the finger's centre reaches at the most; negative: it stays outside
  std::string press{};         ///< the same in words: "10 N at 1000 N/m presses 10 mm deep"
  bool has_neighbour = false;  ///< another surface stands nearer than the finger's width
  CrowdedHollow crowded{};     ///< in which the finger is near the most triangles
};

/// One row of the table of contact methods.
struct ContactMethodEntry {
  std::string_view name;     ///< as scenes write it
  std::string_view summary;  ///< what it does, in a line
  std::string_view holds;    ///< what it holds the finger against, and what not, in a line
  /// Whether a finger that begins inside of a part is put at the nearest place outside, which is told.
  bool starts_outside = false;
  /// Whether several walls can hold the finger at once.
  bool holds_several = false;
  /// Whether normals with a surface of their own (`curved`) are touched there; else they only shade.
  bool touches_own_surface = false;
  /// Whether a tick's work is bounded, so that what holds the finger may be told a tick or more late
  /// (Contact::behind).
  bool may_lag = false;
  /// Whether a finger deep in a rounding is held by a facet for longer than the facet is the nearest.
  bool lags_on_facets = false;
  /// Why this method cannot keep a scene's forces on a part, in words that follow "because" where another is
  /// taken; empty where it can. Null: `auto` never takes it.
  std::string (*fails)(const ContactDemand& demand) = nullptr;
  /// Why it can, in words that follow "because"; null, or empty, where nothing needs to be said.
  std::string (*holds_here)(const ContactDemand& demand) = nullptr;
  /// @param surfaces  all that can be touched, in the world's order; parts with their trees
  std::unique_ptr<ContactMethod> (*make)(std::vector<PlacedSurface> surfaces, double radius_m,
                                         Normals normals);
};

/// All contact methods, the most complete last.
std::span<const ContactMethodEntry> contact_method_table() noexcept;
/// The row of a name; nullptr if there is none.
const ContactMethodEntry* find_contact_method(std::string_view name) noexcept;

/// Both tables, of methods and of normals, for a help text.
std::string contact_help_text();

}  // namespace fingerpad
