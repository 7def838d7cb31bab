#include "scene/scene_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"
#include "contact/contact_method_table.hpp"
#include "scene/key_ranges.hpp"
#include "scene/scene_keys.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// A table named `key` at the top of the file; nullptr if there is none.
const TomlNode* find_table(const TomlNode& root, std::string_view key, const std::string& path) {
  const TomlEntry* entry = find_entry(root, key);
  if (entry == nullptr) return nullptr;
  if (!entry->value.is(TomlNode::Type::table)) {
    throw refused(place_text(path, entry->place),
                  fmt::format("'{}' must be a table, [{}], not {}", key, key, type_text(entry->value.type)));
  }
  return &entry->value;
}

/// The tables of an array of tables at the top of the file.
std::vector<const TomlNode*> find_tables(const TomlNode& root, std::string_view key,
                                         const std::string& path) {
  std::vector<const TomlNode*> tables;
  const TomlEntry* entry = find_entry(root, key);
  if (entry == nullptr) return tables;
  const auto refuse = [&](const TomlNode& value) {
    return refused(place_text(path, entry->place),
                   fmt::format("'{}' is {}; there may be several, so write it as [[{}]]", key,
                               type_text(value.type), key));
  };
  if (!entry->value.is(TomlNode::Type::array)) throw refuse(entry->value);
  for (const TomlNode& item : entry->value.items) {
    if (!item.is(TomlNode::Type::table)) throw refuse(item);
    tables.push_back(&item);
  }
  return tables;
}

SurfaceProperties read_surface(const TomlTable& table) {
  SurfaceProperties surface;
  surface.stiffness_n_per_m =
      table.number("stiffness_n_per_m", surface.stiffness_n_per_m, key_range("part.stiffness_n_per_m"));
  surface.damping_n_s_per_m =
      table.number("damping_n_s_per_m", surface.damping_n_s_per_m, key_range("part.damping_n_s_per_m"));
  surface.mu_static = table.number("mu_static", surface.mu_static, key_range("part.mu_static"));
  surface.mu_dynamic = table.number("mu_dynamic", surface.mu_dynamic, key_range("part.mu_dynamic"));
  if (surface.mu_dynamic > surface.mu_static) {
    const char* key = table.has("mu_dynamic") ? "mu_dynamic" : "mu_static";
    throw table.error(key, fmt::format("mu_dynamic {} is above mu_static {}{}",
                                       number_text(surface.mu_dynamic), number_text(surface.mu_static),
                                       table.has("mu_dynamic") && table.has("mu_static")
                                           ? ""
                                           : " (one of them is the default; give both)"));
  }
  return surface;
}

Mat3 read_rotation(const TomlTable& part) {
  const TomlNode* value = part.value("rotation");
  if (value == nullptr) return Mat3::Identity();
  if (!value->is(TomlNode::Type::table)) {
    throw part.error("rotation", fmt::format("{} must be {{ axis = [x, y, z], angle_deg = a }}, not {}",
                                             part.name("rotation"), type_text(value->type)));
  }
  const TomlTable table(*value, part.file(), "rotation of [[part]]", scene_keys("part.rotation"));
  table.require("axis");
  table.require("angle_deg");
  const Vec3 axis = table.direction("axis", Vec3::UnitZ());
  const double angle_deg = table.number("angle_deg", 0, key_range("part.rotation.angle_deg"));
  return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis).toRotationMatrix();
}

PartEntry read_part(const TomlNode& node, const std::string& path, Missing missing) {
  const TomlTable table(node, path, "[[part]]", scene_keys("part"));
  PartEntry part;
  if (missing != Missing::mesh) table.require("mesh");
  part.mesh = table.text("mesh", "");
  if (table.has("mesh") && part.mesh.empty()) throw table.error("mesh", table.name("mesh") + " is empty");
  part.mesh_path = resolved_path(path, part.mesh);
  const std::string unit = table.text("unit", "mm");
  const auto metres = metres_per_unit(unit);
  if (!metres)
    throw table.error("unit", fmt::format("[[part]]: unknown unit '{}' (known: {})", unit, unit_names));
  part.metres_per_unit = *metres;
  part.position_m = table.vector("position_m", part.position_m);
  part.rotation = read_rotation(table);
  part.crease_deg = table.number("crease_deg", part.crease_deg, key_range("part.crease_deg"));
  part.repair = table.flag("repair", part.repair);
  part.surface = read_surface(table);
  return part;
}

PlaneEntry read_plane(const TomlNode& node, const std::string& path) {
  const TomlTable table(node, path, "[[plane]]", scene_keys("plane"));
  PlaneEntry plane;
  table.require("point_m");
  table.require("normal");
  plane.point_m = table.vector("point_m", plane.point_m);
  plane.normal = table.direction("normal", plane.normal);
  plane.surface = read_surface(table);
  return plane;
}

ContactSettings read_contact(const TomlNode& node, const std::string& path) {
  const TomlTable table(node, path, "[contact]", scene_keys("contact"));
  ContactSettings contact;
  std::vector<std::string> methods{contact.method};
  for (const ContactMethodEntry& method : contact_method_table()) methods.emplace_back(method.name);
  contact.method = methods[table.choice("method", 0, methods)];
  contact.force_tolerance =
      table.number("force_tolerance", contact.force_tolerance, key_range("contact.force_tolerance"));
  contact.mu_tolerance =
      table.number("mu_tolerance", contact.mu_tolerance, key_range("contact.mu_tolerance"));
  contact.greatest_force_n =
      table.number("greatest_force_n", contact.greatest_force_n, key_range("contact.greatest_force_n"));
  std::vector<std::string> words;
  for (const Normals normals : normals_table()) words.emplace_back(normals->name);
  words.emplace_back("auto");
  if (!table.has("normals")) return contact;
  const std::size_t word = table.choice("normals", 0, words);
  contact.automatic_normals = word == normals_table().size();
  if (!contact.automatic_normals) contact.normals = normals_table()[word];
  return contact;
}

/// What the laws say about a number of [friction]; the chosen law's word counts before the others'.
const LawParameter* find_parameter(const LawEntry& chosen, std::string_view key) {
  const auto among = [key](const LawEntry& law) -> const LawParameter* {
    for (const LawParameter& parameter : law.parameters) {
      if (parameter.key == key) return &parameter;
    }
    return nullptr;
  };
  if (const LawParameter* own = among(chosen)) return own;
  for (const LawEntry& law : law_table()) {
    if (const LawParameter* found = among(law)) return found;
  }
  return nullptr;
}

std::optional<VibrationSettings> read_vibration(const TomlTable& friction) {
  const TomlNode* value = friction.value("vibration");
  if (value == nullptr || (value->is(TomlNode::Type::boolean) && !value->boolean)) return std::nullopt;
  if (!value->is(TomlNode::Type::table)) {
    throw friction.error(
        "vibration", friction.name("vibration") + " must be false or a table such as { frequency_hz = 89 }");
  }
  const TomlTable table(*value, friction.file(), "vibration of [friction]", scene_keys("friction.vibration"));
  VibrationSettings vibration;
  vibration.frequency_hz =
      table.number("frequency_hz", vibration.frequency_hz, key_range("friction.vibration.frequency_hz"));
  vibration.bandwidth_hz =
      table.number("bandwidth_hz", vibration.bandwidth_hz, key_range("friction.vibration.bandwidth_hz"));
  vibration.amplitude =
      table.number("amplitude", vibration.amplitude, key_range("friction.vibration.amplitude"));
  vibration.normal_amplitude = table.number("normal_amplitude", vibration.normal_amplitude,
                                            key_range("friction.vibration.normal_amplitude"));
  return vibration;
}

FrictionSettings read_friction(const TomlNode& node, const std::string& path) {
  const TomlTable table(node, path, "[friction]", scene_keys("friction"));
  FrictionSettings friction;
  std::vector<std::string> laws;
  for (const LawEntry& law : law_table()) laws.emplace_back(law.name);
  if (table.has("law")) friction.law = laws[table.choice("law", 0, laws)];
  const LawEntry* chosen = find_law(friction.law);
  if (chosen == nullptr) throw refused(path, fmt::format("the law '{}' is not built in", friction.law));

  for (const std::string& key : scene_keys("friction")) {
    if (!table.has(key) || key == "law" || key == "restick" || key == "remedy" || key == "vibration")
      continue;
    const LawParameter* parameter = find_parameter(*chosen, key);
    const NumberRange range = parameter != nullptr
                                  ? law_range(parameter->min, !parameter->min_allowed, parameter->max)
                                  : law_range(0, true, 1e9);
    friction.settings.numbers[key] = table.number(key, 0, range);
  }
  friction.settings.restick =
      table.choice("restick", 0, {"level", "crossing"}) == 0 ? Restick::level : Restick::crossing;
  constexpr Remedy remedies[] = {Remedy::none, Remedy::damping, Remedy::implicit, Remedy::cap};
  friction.settings.remedy = remedies[table.choice("remedy", 0, {"none", "damping", "implicit", "cap"})];
  friction.vibration = read_vibration(table);
  return friction;
}

FingerSettings read_finger(const TomlNode& node, const std::string& path, FrictionSettings& friction) {
  const TomlTable table(node, path, "[finger]", scene_keys("finger"));
  FingerSettings finger;
  finger.radius_m = table.number("radius_m", finger.radius_m, key_range("finger.radius_m"));
  finger.direction = table.direction("direction", finger.direction);
  finger.profile = table.text("profile", "");
  if (finger.profile.empty()) return finger;
  finger.profile_path = resolved_path(path, finger.profile);
  if (const auto why = why_unreadable(finger.profile_path, profile_file)) {
    throw table.error("profile", fmt::format("the profile {} {}", finger.profile_path, *why));
  }
  friction.settings.profile = read_profile(finger.profile_path);
  return finger;
}

HandSettings read_hand(const TomlNode& node, const std::string& path) {
  const TomlTable table(node, path, "[hand]", scene_keys("hand"));
  HandSettings hand;
  hand.mass_kg = table.number("mass_kg", hand.mass_kg, key_range("hand.mass_kg"));
  hand.damping_n_s_per_m =
      table.number("damping_n_s_per_m", hand.damping_n_s_per_m, key_range("hand.damping_n_s_per_m"));
  hand.stiffness_n_per_m =
      table.number("stiffness_n_per_m", hand.stiffness_n_per_m, key_range("hand.stiffness_n_per_m"));
  hand.encoder_m = table.number("encoder_m", hand.encoder_m, key_range("hand.encoder_m"));
  hand.delay_ticks = static_cast<int>(table.whole("delay_ticks", hand.delay_ticks, 0, 10000));
  hand.coulomb_n = table.number("coulomb_n", hand.coulomb_n, key_range("hand.coulomb_n"));
  const std::string axes = table.text("axes", "xyz");
  for (int i = 0; i < 3; ++i) hand.free_axis[i] = axes.find("xyz"[i]) != std::string::npos;
  const auto given = static_cast<std::size_t>(hand.free_axis[0] + hand.free_axis[1] + hand.free_axis[2]);
  if (axes.empty() || given != axes.size()) {
    throw table.error("axes",
                      table.name("axes") + " must name some of x, y and z, each once, such as \"xy\"");
  }
  return hand;
}

/// A hand so light, or with a spring or damper so strong, that it does a great many turns in a tick: what its
/// matrix exponential loses by rounding grows with their number.
void refuse_hand_too_quick(const HandSettings& hand, double rate_hz, const std::string& place) {
  constexpr double most = 1e9;
  const double quickness = std::max(hand.stiffness_n_per_m, hand.damping_n_s_per_m) / hand.mass_kg / rate_hz;
  if (quickness <= most) return;
  throw refused(place,
                fmt::format("a [hand] of {} kg with {} N/m and {} N s/m moves too quickly for ticks at {} "
                            "Hz: stiffness_n_per_m and damping_n_s_per_m may be at most 1e9 times mass_kg "
                            "times rate_hz",
                            number_text(hand.mass_kg), number_text(hand.stiffness_n_per_m),
                            number_text(hand.damping_n_s_per_m), number_text(rate_hz)));
}

bool is_beyond_ascii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

/// The scene's name becomes a file name, so that it must be one.
std::string read_name(const TomlTable& top, const std::string& path) {
  const auto bad = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == '/' || c == '\\' || c == 0x7f;
  };
  std::string name = top.text("name", "");
  if (!top.has("name")) {
    if (!stream_descriptor(path)) name = fs::path(path).stem().string();
    std::replace_if(name.begin(), name.end(), bad, '_');
    if (name.starts_with('-')) name.front() = '_';
    if (printable(name) != name) std::replace_if(name.begin(), name.end(), is_beyond_ascii, '_');
    return name.empty() ? "scene" : name;
  }
  if (name.empty() || name.size() > 200 || name == "." || name == ".." || name.starts_with('-') ||
      printable(name) != name || std::any_of(name.begin(), name.end(), bad)) {
    throw top.error(
        "name",
        "'name' names the files that replay writes: 1 to 200 bytes, no '/', no '\\', no '-' at its"
        " beginning, no control characters");
  }
  return name;
}

}  // namespace

std::string resolved_path(const std::string& scene_path, const std::string& written) {
  if (written.empty()) return {};
  // A scene that comes as a stream has no folder: its paths start where the program was called.
  if (stream_descriptor(scene_path)) return written;
  return (fs::path(scene_path).parent_path() / written).string();
}

Scene read_scene(const TomlNode& root, const std::string& path, Missing missing) {
  const TomlTable top(root, path, "the scene", scene_keys(""));
  Scene scene;
  scene.path = path;
  scene.name = read_name(top, path);
  scene.seed = static_cast<std::uint64_t>(
      top.whole("seed", static_cast<std::int64_t>(scene.seed), 0, std::numeric_limits<std::int64_t>::max()));
  for (const TomlNode* node : find_tables(root, "part", path)) {
    // A set's mesh goes to the first part.
    const Missing lacks = scene.parts.empty() ? missing : Missing::nothing;
    scene.parts.push_back(read_part(*node, path, lacks));
  }
  for (const TomlNode* node : find_tables(root, "plane", path))
    scene.planes.push_back(read_plane(*node, path));
  if (scene.parts.empty() && scene.planes.empty() && missing == Missing::nothing) {
    throw refused(path,
                  "the scene has nothing to touch: it needs a [[part]] with 'mesh', or a [[plane]] with "
                  "'point_m' and 'normal'");
  }
  if (const TomlNode* node = find_table(root, "contact", path)) scene.contact = read_contact(*node, path);
  const TomlNode no_keys;
  const TomlNode* friction = find_table(root, "friction", path);
  scene.friction = read_friction(friction != nullptr ? *friction : no_keys, path);
  if (const TomlNode* node = find_table(root, "finger", path)) {
    scene.finger = read_finger(*node, path, scene.friction);
  }
  if (const TomlNode* node = find_table(root, "motion", path))
    scene.motion = read_motion_settings(*node, path);
  if (const TomlNode* node = find_table(root, "hand", path)) {
    scene.hand = read_hand(*node, path);
    refuse_hand_too_quick(*scene.hand, scene.motion.rate_hz, place_text(path, node->place));
  }
  return scene;
}

}  // namespace fingerpad
