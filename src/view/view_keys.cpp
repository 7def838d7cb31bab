#include "view/view_keys.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace fingerpad {

bool toggle(KeyAction action, ViewState& state) {
  const struct {
    KeyAction action;
    bool* flag;
  } toggles[] = {{KeyAction::path, &state.path},           {KeyAction::finger, &state.finger},
                 {KeyAction::forces, &state.forces},       {KeyAction::frame, &state.frame},
                 {KeyAction::close_up, &state.close_up},   {KeyAction::creases, &state.creases},
                 {KeyAction::wireframe, &state.wireframe}, {KeyAction::dark, &state.dark},
                 {KeyAction::readings, &state.hud},        {KeyAction::help, &state.help}};
  for (const auto& toggle : toggles) {
    if (action != toggle.action) continue;
    *toggle.flag = !*toggle.flag;
    return true;
  }
  return false;
}

std::optional<PresetLook> preset_look(KeyAction action) {
  constexpr std::pair<KeyAction, std::string_view> names[] = {
      {KeyAction::front, "front"},        {KeyAction::back, "back"}, {KeyAction::left, "left"},
      {KeyAction::right, "right"},        {KeyAction::top, "top"},   {KeyAction::bottom, "bottom"},
      {KeyAction::isometric, "isometric"}};
  for (const auto& [preset, name] : names) {
    if (preset != action) continue;
    const bool askew = action == KeyAction::isometric;
    return PresetLook{*named_look(name), askew ? "askew" : fmt::format("from the {}", name)};
  }
  return std::nullopt;
}

}  // namespace fingerpad
