#pragma once

#include <string>
#include <vector>

#include "scene/scene_key.hpp"

namespace fingerpad {

/// Finds keys that stand in a scene file and that none of its jobs reads: a law's number where another law is
/// chosen, a tolerance of `auto` where the method is named.
class UnreadKeys {
 public:
  /// Looks at a job: a scene with its set's values put in. Keys are judged by their own table alone, whatever
  /// else is wrong with the scene.
  void look(const TomlNode& scene);

  /// Throws Error (refused) at the first key that no job reads, with what reads it.
  void refuse(const std::string& path) const;

 private:
  struct Use {
    const SceneKey* row;
    Place place;
    bool read = false;
    std::vector<std::string> chosen{};  ///< what was chosen where it stood, each once: `law "coulomb"`
  };

  void look_at(const SceneTable& table, const TomlNode& node, std::vector<std::string> words);

  std::vector<Use> uses_;
};

}  // namespace fingerpad
