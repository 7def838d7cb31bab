#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/placed_surface.hpp"
#include "fingerpad/surface_properties.hpp"
#include "part/load_progress.hpp"
#include "part/verdict.hpp"
#include "touch/contact_choice.hpp"

namespace fingerpad {

/// One thing that can be touched, and what the scene says of it.
struct Surface : PlacedSurface {
  SurfaceProperties properties;
  std::string mesh;       ///< as written in the scene; empty for a plane
  std::string mesh_hash;  ///< of the file's bytes
};

/// All that can be touched in a scene, loaded: parts first, then planes. Immutable, shared by any number of
/// contacts.
struct World {
  std::vector<Surface> surfaces;
  std::vector<Verdict> verdicts;  ///< one per part
  std::optional<ContactChoice>
      contact;  ///< as load_world chose it for its scene; none in worlds made by hand
};

/// "bracket.stl", its mesh without the folders; "plane".
std::string shown_name(const Surface& surface);
/// "part 2 (knob.stl)", "plane 1": counted as they stand in the scene's file, from 1.
std::string counted_name(const World& world, std::size_t surface);

/// Whether two planes meet: a finger in their corner is held by both.
bool any_planes_meet(std::span<const Surface> surfaces) noexcept;
/// Whether only planes can be touched, no two of which meet: every contact method, with any normals, finds
/// the same there.
bool needs_no_method(const World& world) noexcept;

/// That of all parts together, or the most that an int holds.
int triangles_of(std::span<const Surface> surfaces);

/// Where everything in a world stands, in its order: what a contact method is made for.
std::vector<PlacedSurface> placed_surfaces(const World& world);

class MeshStore;
struct PartMeasures;
struct Scene;

/// Gives a world of which all surfaces are there the choice of what the scene leaves open, and makes ready
/// what its normals need.
/// @param measures  one for each part; may be empty where the scene leaves no choice
void settle_contact(World& world, const Scene& scene, std::span<const PartMeasures> measures);

/// Loads every part of a scene, and measures them where it leaves its contact method or normals to choose.
/// Throws Error (refused) for a mesh that cannot be touched.
/// @param progress  as MeshStore's
std::shared_ptr<const World> load_world(const Scene& scene, const LoadProgress& progress = {});

/// As above, with meshes shared between many scenes.
std::shared_ptr<const World> load_world(const Scene& scene, MeshStore& meshes);

}  // namespace fingerpad
