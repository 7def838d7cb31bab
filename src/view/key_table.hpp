#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// What a key of a window does.
enum class KeyAction {
  help,
  close,
  leave,  // leave: what lies over the scene, else the window
  screenshot,
  wireframe,
  dark,
  parts,
  materials,
  mark,
  first_view,
  all_in_sight,
  front,
  back,
  left,
  right,
  top,
  bottom,
  isometric,
  nearer,
  farther,
  colouring,
  path,
  finger,
  forces,
  frame,
  close_up,
  creases,
  readings,
  play,
  tick_back,
  tick_on,
  leap_back,
  leap_on,
  to_first,
  to_last,
  faster,
  slower,
  press,
  harder,
  softer,
  go_left,
  go_right,
  go_up,
  go_down,
  next_row,
  less,
  more,
  stop,
  give_back
};

/// The kinds of windows, to be joined by |.
namespace windows {
inline constexpr unsigned still = 1;     ///< a mesh, or a scene without a motion: nothing moves
inline constexpr unsigned trace = 2;     ///< of a trace, or of a scene that was replayed
inline constexpr unsigned touch = 4;     ///< live
inline constexpr unsigned motors = 8;    ///< live, on a device with motors
inline constexpr unsigned led = 16;      ///< live, the mouse leads the finger
inline constexpr unsigned watched = 32;  ///< live, something else leads it: the mouse turns the view
inline constexpr unsigned view = still | trace, live = touch | motors, moving = trace | live,
                          all = view | live;
}  // namespace windows

/// A key as X names it.
struct BoundKey {
  std::string_view symbol;
  KeyAction action;
};

/// One line of the help page and of the README's table: keys or a way of the mouse, and what they do.
struct KeyRow {
  std::string_view shown, does;
  unsigned in = windows::all;
  std::vector<BoundKey> keys{};  ///< none: the mouse's
};

/// Everything that keys and mouse do in a window: windows, help page and README go by these rows.
std::span<const KeyRow> key_table();

/// What a key does in a window; none: nothing.
/// @param window  what it is of `windows`, joined by |
std::optional<KeyAction> action_of(std::string_view symbol, unsigned window);

/// "key: what it does", a line a row, for a window's help page.
std::vector<std::string> help_lines(unsigned window);

/// The table in Markdown, as the README shows it.
std::string key_table_text();

}  // namespace fingerpad
