#include "replay/motion_key.hpp"

#include "base/number_text.hpp"
#include "scene/scene.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {

std::string motion_key(const Scene& scene) {
  std::string key = scene.path + "\n" + scene.name + "\n" + scene.motion.file_path + "\n";
  if (scene.motion.automatic_rate || scene.motion.laid) return key + scene.text;
  const TomlNode root = parse_toml(scene.text, scene.path);
  for (const char* table : {"motion", "hand", "finger"}) {
    const TomlEntry* entry = find_entry(root, table);
    if (entry != nullptr) key += std::string(table) + "\n" + write_toml(entry->value);
  }
  if (scene.motion.placement.in_part) {
    const PartEntry& part = scene.parts.front();
    for (const double number : part.rotation.reshaped()) key += number_text(number) + " ";
    for (const double number : part.position_m) key += number_text(number) + " ";
  }
  return key;
}

}  // namespace fingerpad
