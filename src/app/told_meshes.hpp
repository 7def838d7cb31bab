#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/check_mesh.hpp"
#include "part/verdict.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What tells a file from another, by whatever path, with the ending by which its format goes; of one that is
/// not there, the path.
std::string file_words(const std::string& path);

/// Which mesh a part is, and how it is taken.
std::string mesh_keys(const PartEntry& entry);
/// The same of all parts of a scene, in their order.
std::string part_keys(const Scene& scene);

/// The meshes of a scene's jobs, each told once, however many parts of however many jobs are of it.
class ToldMeshes {
 public:
  /// @param report  where --json tells each
  ToldMeshes(bool as_json, nlohmann::ordered_json& report) : as_json_(as_json), report_(&report) {}

  /// Tells those of a scene's parts that no scene before had. A good mesh that stands in the scene twice is
  /// told for each. @returns whether all of its parts can be touched
  bool look_at(const Scene& scene);

  /// What replay would touch, each part where the scene places it. @pre look_at() has found that all can be
  World world(const Scene& scene);
  /// The same without the parts' triangles: their verdicts.
  World world_in_words(const Scene& scene) const;
  /// Which of the report's objects tell a scene's parts, in their order. @pre as for world(); in JSON
  std::vector<std::size_t> objects(const Scene& scene) const;

  int count() const noexcept;    ///< of meshes
  int refused() const noexcept;  ///< of these

 private:
  struct Told {
    Verdict verdict;
    std::vector<std::size_t> objects;  ///< of the report; a mesh that stands in a scene twice has two
  };

  void turn_to(const Scene& scene);
  const CheckedMesh& read(const PartEntry& entry);

  bool as_json_;
  nlohmann::ordered_json* report_;
  std::map<std::string, Told> told_;
  std::set<std::string> at_hand_;            ///< what the scene that is looked at has
  std::map<std::string, CheckedMesh> kept_;  ///< of these, and of scenes before until another is read
};

}  // namespace fingerpad
