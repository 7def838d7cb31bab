#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/part_measures.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

struct Surface;
struct World;

/// A contact method and normals for a whole world, and why.
struct ContactChoice {
  ContactMethod method = ContactMethod::closest_point;  ///< never automatic
  Normals normals = Normals::smooth;
  std::vector<std::string> reasons;  ///< one for each part where the scene left something to choose:
                                     ///< "FILE: proxy, because WHY (auto)"
};

/// How far a finger is taken to go on before the next tick can answer: this speed over the rate.
inline constexpr double choice_speed_m_per_s = 1;

/// Whether a scene leaves anything to choose: only then are its parts measured.
bool leaves_a_choice(const ContactSettings& contact) noexcept;

/// The cheapest method and normals that keep the scene's tolerances.
///
/// Method, where the scene says auto. Closest-point answers from the nearest surface, so it is wrong where
/// that changes under the finger; each of these calls for the proxy:
///   - the part is open, wound against itself or inside out: its inside is not known;
///   - bodies of the part overlap or touch over an area, or it passes through itself: the nearest sheet may
///   be
///     one that lies inside of another body, and its side says nothing (seen by samples: PartMeasures);
///   - a wall is thinner than twice the depth to which the greatest force presses the finger's centre
///   (greatest
///     force / stiffness - radius, and one tick's motion at 1 m/s): beyond its middle the far side is nearer;
///   - a knife edge, whose material is sharper than 60 degrees, where the centre can get inside;
///   - the finger has a radius and touches two walls at once: in a concave crease that turns by phi, where
///   the
///     nearest wall alone is wrong by sin(phi/2) of the force, or in a hollow of a smaller radius (taken as a
///     right angle), where that is more than the force tolerance;
///   - another surface stands nearer than the finger's width.
/// A blunter convex edge does not: there closest-point lets the finger slip off sideways when it is as near
/// to the other face as it is deep, but never pushes it on through.
///
/// Normals, where the scene says auto. Tilt of a normal is an error of the force's direction, and of the
/// coefficient of friction that is felt: it may be at most the force tolerance and the mu tolerance times
/// mu_dynamic. facet where half the largest turn over a smooth edge is less; else smooth; curved where
/// besides the facets cut into the surface by more than the force tolerance's share of the greatest depth,
/// and the method is closest-point (a proxy stands on the facets, whatever its normals: there the reason says
/// that only a finer mesh would do).
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

/// As scenes write them. In a world of planes alone nothing is searched: the method there is "plane".
std::string_view method_name(ContactMethod method) noexcept;
std::string_view normals_name(Normals normals) noexcept;
std::string_view method_in(const World& world, ContactMethod method) noexcept;

}  // namespace fingerpad
