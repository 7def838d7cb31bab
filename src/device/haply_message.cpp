#include "device/haply_message.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "device/reach.hpp"

namespace fingerpad {
namespace {

using nlohmann::json;

constexpr double haply_unit_tolerance = 1e-3;

/// A member of an object; null where it is none or has none.
const json& member(const json& object, const char* name) {
  static const json none;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : none;
}

/// The first of a list of devices.
const json& first_device(const json& frame, const char* kind) {
  static const json none;
  const json& devices = member(frame, kind);
  return devices.is_array() && !devices.empty() ? devices.front() : none;
}

/// Numbers of an object by their names, each finite and within +-most.
template <std::size_t count>
bool read_numbers(const json& object, const char* const (&names)[count], double most,
                  double (&numbers)[count]) {
  for (std::size_t k = 0; k < count; ++k) {
    const json& value = member(object, names[k]);
    if (!value.is_number()) return false;
    numbers[k] = value.get<double>();
    if (!(std::abs(numbers[k]) <= most)) return false;
  }
  return true;
}

/// How the grip is turned, and whether its first button is pressed. @returns false where that makes no sense
bool read_grip(const json& grip, DevicePlace& place) {
  const json& state = member(grip, "state");
  const json& pressed = member(member(state, "buttons"), "a");
  const json& only = member(state, "button");
  place.clutch = (pressed.is_boolean() && pressed.get<bool>()) || (only.is_boolean() && only.get<bool>());
  if (member(state, "orientation").is_null()) return true;
  double q[4];
  if (!read_numbers(member(state, "orientation"), {"w", "x", "y", "z"}, 2, q)) return false;
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (std::abs(length - 1) > haply_unit_tolerance) return false;
  place.attitude_D = Attitude(q[0], q[1], q[2], q[3]).normalized();
  return true;
}

}  // namespace

std::optional<HaplyFrame> read_haply_frame(std::string_view text) {
  const json frame = json::parse(text, nullptr, false);
  if (!frame.is_object()) return std::nullopt;
  HaplyFrame read;
  const json& device = first_device(frame, "inverse3");
  if (device.is_null()) return read;
  const json& id = member(device, "device_id");
  double p[3];
  if (!id.is_string() || id.get_ref<const std::string&>().empty()) return std::nullopt;
  if (!read_numbers(member(member(device, "state"), "cursor_position"), {"x", "y", "z"}, device_reach_m, p))
    return std::nullopt;
  read.device_id = id.get<std::string>();
  read.place.p_D = {p[0], p[1], p[2]};
  for (const char* kind : {"verse_grip", "wireless_verse_grip"}) {
    const json& grip = first_device(frame, kind);
    if (grip.is_null()) continue;
    if (!read_grip(grip, read.place)) return std::nullopt;
    break;
  }
  return read;
}

std::string haply_message(const std::string& device_id, const Vec3& force_D_n,
                          const std::string& profile_name) {
  const json vector = {{"x", force_D_n.x()}, {"y", force_D_n.y()}, {"z", force_D_n.z()}};
  json message = {
      {"inverse3", {{{"device_id", device_id}, {"commands", {{"set_cursor_force", {{"vector", vector}}}}}}}}};
  if (!profile_name.empty()) message["session"] = {{"configure", {{"profile", {{"name", profile_name}}}}}};
  return message.dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace fingerpad
