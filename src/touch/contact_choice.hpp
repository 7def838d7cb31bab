#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contact/normals.hpp"

namespace fingerpad {

struct ContactSettings;
struct PartMeasures;
struct Scene;
struct Surface;
struct World;

/// What a choice keeps of a scene's force_tolerance on one part.
struct ContactLimit {
  double kept_tolerance = 0;  ///< force_tolerance where it is kept; else what can be kept in its place
  std::string said;   ///< what cannot be kept, and what would: "force_tolerance 0.03 cannot be kept, 0.1
                      ///< can: its facets ...; a finer mesh or a STEP file would"; empty: all is kept
  std::string why{};  ///< as it stands there: "its facets ..."
};

/// A contact method and normals for a whole world, and why.
struct ContactChoice {
  std::string method = "closest-point";  ///< a row of contact_method_table(), never automatic
  Normals normals = Normals::smooth;
  std::vector<std::string> reasons;  ///< one for each part (or for the planes, where these alone decide)
                                     ///< where the scene left something to choose:
                                     ///< "FILE: proxy, because WHY (auto)"; then a line for each limit that
                                     ///< says something: "FILE: force_tolerance 0.03 cannot ... (auto)"
  std::vector<ContactLimit> limits;  ///< one for each part, likewise
  long reckoned = 0;                 ///< errors of a part under a press, which is what a choice costs
};

/// How far a finger is taken to go on before the next tick can answer: this speed over the rate.
inline constexpr double choice_speed_m_per_s = 1;

/// Whether a scene leaves anything to choose: only then are its parts measured.
bool leaves_a_choice(const ContactSettings& contact) noexcept;

/// The cheapest method and normals that keep the scene's tolerances, where it leaves them open: of all pairs
/// of rows of both tables whose method can do on every part (ContactMethodEntry::fails), and whose reckoned
/// error is within the tolerances on every part (reckoned_error.hpp), the one that a table of measured ratios
/// has as the cheapest (contact_cost.hpp).
///
/// The promise: on 99 % of ticks the contact's force is off by at most `force_tolerance` times the larger of
/// the true force and a tenth of `greatest_force_n`, up to `greatest_force_n`, and the finger never pops
/// through. True is the smooth surface that the facets stand for, where it is known; else the most complete
/// touch of the mesh at the same rate: the wall that a proxy finds, and the curved patch there. The tilt of
/// the normals is an error of the mean coefficient of friction of at most `mu_tolerance`. It speaks of
/// presses that the part holds, no deeper than four fifths of the rounding under the finger's centre, and of
/// ways that stay in any region of the part (an eighth of its longest side): what is within a hundredth of
/// such a region's area may be worse, and so may what is within a two-thousandth of the part's.
///
/// Where no pair keeps it, because the mesh does not (its facets cut too deep into the surface, or turn by
/// too much), or because the scene insists on a method or normals, the best is taken, and the choice says
/// which number is not kept, what is kept in its place, and what would keep it
/// (ContactLimit).
///
/// Creases are taken at the scene's word: an edge that turns by more than `crease_deg` is meant to be an
/// edge. So a sphere of 20 facets, whose every edge turns by 42 degrees, is an icosahedron, with flat faces:
/// nothing in the mesh tells the one from the other (a cube's edges turn alike too). Where it is meant to be
/// round, say so by a `crease_deg` above the turn of its facets.
///
/// One world has one method and one kind of normals: what one part needs all get. Of planes alone, two that
/// meet need a method that several walls can hold.
/// @param surfaces  as load_world made them: parts first
/// @param measures  one for each part; may be empty where the scene leaves no choice
ContactChoice choose_contact(const Scene& scene, std::span<const Surface> surfaces,
                             std::span<const PartMeasures> measures);

/// What a scene's touch uses in a world: the scene's own words, and for those it leaves open the world's
/// choice (closest-point and smooth in a world that was made without one).
ContactChoice settled_contact(const Scene& scene, const World& world);

/// The method's name as traces have it: where none is needed (needs_no_method) that is "plane".
std::string_view method_in(const World& world, std::string_view method) noexcept;

}  // namespace fingerpad
