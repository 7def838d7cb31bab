#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.hpp"
#include "contact/normals.hpp"
#include "fingerpad/surface_properties.hpp"
#include "friction/law_settings.hpp"
#include "motion/hand_settings.hpp"
#include "motion/recording_format.hpp"
#include "motion/scripted_motion.hpp"
#include "motion/surface_motion.hpp"
#include "scene/device_settings.hpp"

namespace fingerpad {

struct PartEntry {
  std::string mesh;       ///< as written
  std::string mesh_path;  ///< resolved against the scene file
  double metres_per_unit = 1e-3;
  Vec3 position_m = Vec3::Zero();    ///< p_WP
  Mat3 rotation = Mat3::Identity();  ///< R_WP
  double crease_deg = 30;
  bool repair = false;  ///< see build_repaired_part
  SurfaceProperties surface;
};

struct PlaneEntry {
  Vec3 point_m = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit
  SurfaceProperties surface;
};

/// The contact method that a scene leaves to the program: the cheapest that keeps the tolerances
/// (choose_contact).
inline constexpr std::string_view automatic_method = "auto";

struct ContactSettings {
  std::string method{automatic_method};  ///< or the name of a row of contact_method_table()
  Normals normals = Normals::smooth;
  bool automatic_normals = false;  ///< `normals = "auto"`: as for the method
  // What a choice must keep.
  double force_tolerance = 0.03;  ///< error of the force, as a fraction of it
  double mu_tolerance = 0.1;      ///< error of the coefficient of friction, as a fraction of it
  double greatest_force_n = 10;   ///< that the finger will press with
};

/// Slip vibration (paper, fig. 11).
struct VibrationSettings {
  double frequency_hz = 89;
  double bandwidth_hz = 20;
  double amplitude = 0.05;      ///< RMS as a fraction of the slip force
  double normal_amplitude = 0;  ///< RMS as a fraction of the normal force
};

struct FrictionSettings {
  std::string law = "finger-pad";
  LawSettings settings;
  std::optional<VibrationSettings> vibration;
};

struct FingerSettings {
  double radius_m = 0;
  std::string radius_place;  ///< "pad.toml:9:12", where the file says it; empty: it does not
  Vec3 direction = Vec3(0, 1, -1).normalized();
  std::string profile;       ///< as written; empty: none
  std::string profile_path;  ///< resolved
};

/// Where a motion lies: its own coordinates are turned, then moved, in the world's frame or the first part's.
struct MotionPlacement {
  bool in_part = false;
  Vec3 position_m = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();

  bool is_world() const { return !in_part && position_m.isZero(0) && rotation.isIdentity(0); }
};

/// A motion file (CSV or trace), a scripted motion or one laid on the first part; neither in a scene that is
/// only viewed or touched live.
struct MotionSettings {
  std::string file;  ///< as written
  std::string file_path;
  std::optional<ScriptedMotion> scripted;
  std::optional<SurfaceMotion> laid;
  MotionPlacement placement;  ///< of a file or a scripted motion
  double rate_hz = 1000;
  bool rate_given = false;      ///< else a file is followed at its own rate, which load_motion finds
  bool automatic_rate = false;  ///< `rate_hz = "auto"`: choose_rate finds it

  // Of a file.
  RecordingFormat format;   ///< how its table is to be read
  std::string table_key;    ///< a key that says so, where one stands in the scene: a trace needs none
  double encoder_m = 0;     ///< quantum that its positions are rounded to; 0: none
  double smoothing_hz = 0;  ///< of ZeroPhaseLowPass; 0: none
  bool given() const { return !file.empty() || scripted.has_value() || laid.has_value(); }
  bool has_own_rate() const { return !file.empty() && !rate_given && !automatic_rate; }
  /// Whether the rate is known only once the motion is: rate_hz says nothing until then.
  bool is_rate_open() const { return has_own_rate() || automatic_rate; }
};

/// A scene file as plain values; defaults are the documented ones.
struct Scene {
  std::string name;
  std::string path;  ///< of the file, as given; "" for one made in code
  std::uint64_t seed = 1;
  std::vector<PartEntry> parts;
  std::vector<PlaneEntry> planes;
  ContactSettings contact;
  FrictionSettings friction;
  FingerSettings finger;
  MotionSettings motion;
  std::optional<HandSettings> hand;
  DeviceSettings device;
  std::string
      text;  ///< the whole scene as TOML, set keys put in: read_scene_text(text, path) gives this scene again
};

}  // namespace fingerpad
