#include "scene/scene_key_rows.hpp"
#include "contact/contact_method_table.hpp"
#include "scene/law_keys.hpp"
#include "scene/scene_key_makers.hpp"
#include "scene/scene_values.hpp"

namespace fingerpad {
namespace {

// Where the keys of a table go. Of parts and planes the newest is being read.
PartEntry& part(Scene& scene) {
  return scene.parts.back();
}
PlaneEntry& plane(Scene& scene) {
  return scene.planes.back();
}
SurfaceProperties& part_surface(Scene& scene) {
  return part(scene).surface;
}
SurfaceProperties& plane_surface(Scene& scene) {
  return plane(scene).surface;
}
Scene& whole(Scene& scene) {
  return scene;
}
ContactSettings& contact(Scene& scene) {
  return scene.contact;
}
VibrationSettings& vibration(Scene& scene) {
  return *scene.friction.vibration;
}
FingerSettings& finger(Scene& scene) {
  return scene.finger;
}
HandSettings& hand(Scene& scene) {
  return *scene.hand;
}

DeviceSettings& device(Scene& scene) {
  return scene.device;
}

std::vector<std::string> method_words() {
  std::vector<std::string> words{std::string(automatic_method)};
  for (const ContactMethodEntry& method : contact_method_table()) words.emplace_back(method.name);
  return words;
}

std::vector<std::string> normals_words() {
  std::vector<std::string> words;
  for (const Normals normals : normals_table()) words.emplace_back(normals->name);
  words.emplace_back(automatic_method);
  return words;
}

using Surface = SurfaceProperties;

/// The keys that [[part]] and [[plane]] share.
template <auto into>
std::vector<SceneKey> surface_keys() {
  return {
      number_key<into, &Surface::stiffness_n_per_m>("stiffness_n_per_m", 1e-6, 1e9, ""),
      number_key<into, &Surface::damping_n_s_per_m>("damping_n_s_per_m", 0, 1e9, ""),
      number_key<into, &Surface::mu_static>("mu_static", 0, 1000, ""),
      number_key<into, &Surface::mu_dynamic>("mu_dynamic", 0, 1000, "at most mu_static"),
  };
}

std::vector<SceneKey> file_keys() {
  return {
      text_key("name", "\"bracket\"", "default: the file's stem", read_name),
      whole_key<whole, &Scene::seed>("seed", 0, std::numeric_limits<std::int64_t>::max(),
                                     "of the random stream; used by vibration only"),
  };
}

std::vector<SceneKey> part_keys() {
  using P = PartEntry;
  return joined_keys(
      {{
           text_key("mesh", "\"parts/bracket.stl\"", "required; relative to this file, as are all paths",
                    read_mesh),
           unit_key("unit"),
           vector_key<part, &P::position_m>("position_m", ""),
           table_key("rotation", "", read_rotation),
           number_key<part, &P::crease_deg>("crease_deg", 0, 180, "edges sharper than this stay sharp"),
           flag_key<part, &P::repair>("repair", "mend what can be mended of a damaged mesh, and say so"),
       },
       surface_keys<part_surface>()});
}

/// Read as one value, read_rotation.
std::vector<SceneKey> rotation_keys() {
  return {
      required({"axis", KeyType::vector, "", "[0, 0, 1]"}),
      required({"angle_deg", KeyType::number, "", "0", {-3600, 3600, false}}),
  };
}

std::vector<SceneKey> plane_keys() {
  using P = PlaneEntry;
  return joined_keys({{
                          required(vector_key<plane, &P::point_m>("point_m", "required, as is normal")),
                          required(direction_key<plane, &P::normal>("normal", "outwards")),
                      },
                      surface_keys<plane_surface>()});
}

std::vector<SceneKey> contact_keys() {
  using C = ContactSettings;
  const std::string_view automatic = automatic_method;
  return {
      choice_key<take_method>("method", method_words(), C().method,
                              "auto: the cheapest that keeps the tolerances"),
      choice_key<take_normals>("normals", normals_words(), std::string(C().normals->name), ""),
      only_with({automatic}, number_key<contact, &C::force_tolerance>("force_tolerance", 1e-9, 1,
                                                                      "for auto: of the force")),
      only_with({automatic}, number_key<contact, &C::mu_tolerance>(
                                 "mu_tolerance", 1e-9, 1, "for auto: of the coefficient of friction")),
      only_with({automatic}, number_key<contact, &C::greatest_force_n>(
                                 "greatest_force_n", 1e-6, 1e6, "for auto: the hardest press to be held")),
  };
}

std::vector<SceneKey> vibration_keys() {
  using V = VibrationSettings;
  return {
      number_key<vibration, &V::frequency_hz>("frequency_hz", 1e-3, 1e6, ""),
      number_key<vibration, &V::bandwidth_hz>("bandwidth_hz", 1e-3, 1e6, ""),
      number_key<vibration, &V::amplitude>("amplitude", 0, 1, "of the slip force, RMS"),
      number_key<vibration, &V::normal_amplitude>("normal_amplitude", 0, 1, "of the normal force, RMS"),
  };
}

std::vector<SceneKey> finger_keys() {
  using F = FingerSettings;
  return {
      number_key<finger, &F::radius_m>("radius_m", 0, 1000, "0: a point"),
      direction_key<finger, &F::direction>("direction", "along the fingertip; a motion file can override it"),
      text_key("profile", "\"profiles/default.toml\"",
               "stick-ellipse axes against the finger's angle; no profile unless written", read_profile_key),
  };
}

std::vector<SceneKey> hand_keys() {
  using H = HandSettings;
  return {
      number_key<hand, &H::mass_kg>("mass_kg", 1e-6, 1e3, ""),
      number_key<hand, &H::damping_n_s_per_m>("damping_n_s_per_m", 0, 1e9, ""),
      number_key<hand, &H::stiffness_n_per_m>("stiffness_n_per_m", 0, 1e9,
                                              "the hand's spring towards the motion"),
      number_key<hand, &H::encoder_m>("encoder_m", 0, 1, "position quantum"),
      whole_key<hand, &H::delay_ticks>("delay_ticks", 0, 10000, ""),
      number_key<hand, &H::coulomb_n>("coulomb_n", 0, 1e9, "dry friction of the device"),
      text_key("axes", "\"xyz\"", "axes the hand moves along by itself", read_axes),
  };
}

std::vector<SceneKey> device_keys() {
  using D = DeviceSettings;
  return {
      table_key("rotation", "", read_device_rotation),
      number_key<device, &D::scale>("scale", 1e-6, 1e6, "metres of the world for a metre of the device"),
      vector_key<device, &D::offset_m>("offset_m", "where the device's origin lies"),
      number_key<device, &D::force_scale>("force_scale", 0, 1e3,
                                          "newtons of the device for one of the world"),
      number_key<device, &D::force_limit_n>("force_limit_n", 0, 1e3, "never more"),
      number_key<device, &D::force_rate_limit_n_per_s>("force_rate_limit_n_per_s", 1e-3, 1e9,
                                                       "never faster, but to 0 where it must stop"),
      number_key<device, &D::watchdog_s>("watchdog_s", 1e-3, 1, "silence that lifts the finger"),
      number_key<device, &D::soft_start_s>("soft_start_s", 0, 10,
                                           "after a loss of contact the limit grows from 0 over this"),
  };
}

}  // namespace

const std::vector<SceneTable>& scene_tables() {
  static const std::vector<SceneTable> tables = {
      {"", "the scene", "", file_keys()},
      {"part", "[[part]]", "any number; or [[plane]] with point_m and normal, which needs no mesh",
       part_keys()},
      {"part.rotation", "rotation of [[part]]", "", rotation_keys()},
      {"plane", "[[plane]]", "any number", plane_keys()},
      {"contact", "[contact]", "", contact_keys(), {"method", "normals"}, {"motion.rate_hz"}},
      {"friction", "[friction]", "a law's own keys are in the table of laws", friction_keys(), {"law"}},
      {"friction.vibration", "vibration of [friction]", "", vibration_keys()},
      {"finger", "[finger]", "", finger_keys()},
      {"motion", "[motion]", "a file, or a motion made by its kind", motion_keys(), {"kind"}},
      {"motion.rotation", "rotation of [motion]", "", rotation_keys()},
      {"motion.columns", "columns of [motion]", "", recording_column_keys()},
      {"hand", "[hand]", "optional: a simulated hand and device close the loop", hand_keys()},
      {"device", "[device]", "optional: how a live device lies in the world, and what its motors may do",
       device_keys()},
      {"device.rotation", "rotation of [device]", "", rotation_keys()},
  };
  return tables;
}

}  // namespace fingerpad
