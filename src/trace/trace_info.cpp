#include "trace/trace_info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/content_hash.hpp"
#include "base/input_file.hpp"
#include "contact/contact_method_table.hpp"
#include "motion/field_format.hpp"
#include "motion/finger_path.hpp"
#include "scene/pad_profile_file.hpp"
#include "scene/scene.hpp"
#include "touch/contact_choice.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// All but what its motion says.
TraceInfo info_of(const Scene& scene, const World& world, const std::string& version) {
  TraceInfo info;
  info.scene_name = scene.name;
  info.scene_text = scene.text;
  info.seed = scene.seed;
  info.rate_hz = scene.motion.rate_hz;
  info.version = version;
  for (const Surface& surface : world.surfaces) {
    if (!surface.part) continue;
    info.mesh_files.push_back(surface.mesh);
    info.mesh_hashes.push_back(surface.mesh_hash);
  }
  info.motion_file = scene.motion.file;
  if (!scene.finger.profile_path.empty())
    info.profile_text = read_whole_file(scene.finger.profile_path, profile_file);
  const ContactChoice contact = settled_contact(scene, world);
  info.contact_method = method_in(world, contact.method);
  info.contact_normals = contact.normals->name;
  const ContactMethodEntry* method = find_contact_method(contact.method);
  info.several_walls = method != nullptr && method->holds_several;
  info.contact_reasons = contact.reasons;
  return info;
}

}  // namespace

std::string motion_hash_of(const Scene& scene) {
  if (scene.motion.file_path.empty()) return "";
  std::vector<std::string> hashes;
  for (const std::string& file : field_files(scene.motion.file_path, scene.motion.format))
    hashes.push_back(file_hash(file));
  return fmt::format("{}", fmt::join(hashes, "+"));
}

TraceInfo trace_info(const Scene& scene, const World& world, const std::string& version) {
  TraceInfo info = info_of(scene, world, version);
  info.motion_hash = motion_hash_of(scene);
  return info;
}

TraceInfo trace_info(const Scene& scene, const World& world, const FingerPath& path,
                     const std::string& version) {
  return trace_info(scene, world, path, motion_hash_of(scene), version);
}

TraceInfo trace_info(const Scene& scene, const World& world, const FingerPath& path,
                     const std::string& motion_hash, const std::string& version) {
  TraceInfo info = info_of(scene, world, version);
  info.motion_hash = motion_hash;
  info.turning = path.turns();
  info.attitudes = path.has_attitudes();
  info.compared = path.has_measured_force() && !scene.hand;
  info.in_hand = scene.hand.has_value() || path.was_in_hand();
  info.estimated = scene.hand.has_value() || path.has_velocity();
  return info;
}

}  // namespace fingerpad
