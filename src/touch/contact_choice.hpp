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

/// A contact method and normals for a whole world, and why.
struct ContactChoice {
  std::string method = "closest-point";  ///< a row of contact_method_table(), never automatic
  Normals normals = Normals::smooth;
  std::vector<std::string> reasons;  ///< one for each part where the scene left something to choose:
                                     ///< "FILE: proxy, because WHY (auto)"
};

/// How far a finger is taken to go on before the next tick can answer: this speed over the rate.
inline constexpr double choice_speed_m_per_s = 1;

/// Whether a scene leaves anything to choose: only then are its parts measured.
bool leaves_a_choice(const ContactSettings& contact) noexcept;

/// The cheapest method and normals that keep the scene's tolerances, where it leaves them open: of each table
/// the last row that says of some part that it is needed (ContactMethodEntry::needed, NormalsEntry::needed).
///
/// What normals may cost: their tilt is an error of the force's direction, and of the coefficient of friction
/// that is felt, so it may be at most the force tolerance and the mu tolerance times mu_dynamic; the facets'
/// sag may be at most the force tolerance's share of the greatest depth.
///
/// Creases are taken at the scene's word: an edge that turns by more than `crease_deg` is meant to be an
/// edge. So a sphere of 20 facets, whose every edge turns by 42 degrees, is an icosahedron, with flat faces:
/// nothing in the mesh tells the one from the other (a cube's edges turn alike too). Where it is meant to be
/// round, say so by a `crease_deg` above the turn of its facets.
///
/// One world has one method and one kind of normals: what one part needs all get.
/// @param surfaces  as load_world made them: parts first
/// @param measures  one for each part; may be empty where the scene leaves no choice
ContactChoice choose_contact(const Scene& scene, std::span<const Surface> surfaces,
                             std::span<const PartMeasures> measures);

/// What a scene's touch uses in a world: the scene's own words, and for those it leaves open the world's
/// choice (closest-point and smooth in a world that was made without one).
ContactChoice settled_contact(const Scene& scene, const World& world);

/// The method's name as traces have it: in a world of planes alone nothing is searched, and that is "plane".
std::string_view method_in(const World& world, std::string_view method) noexcept;

}  // namespace fingerpad
