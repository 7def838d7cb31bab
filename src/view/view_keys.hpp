#pragma once

#include <optional>
#include <string>

#include "view/key_table.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// Shows or hides what a key stands for. @returns whether it stands for such a thing
bool toggle(KeyAction action, ViewState& state);

/// A direction to look from, and how a window tells of it.
struct PresetLook {
  LookFrom from;
  std::string words;
};

/// None where a key is not of a direction.
std::optional<PresetLook> preset_look(KeyAction action);

}  // namespace fingerpad
