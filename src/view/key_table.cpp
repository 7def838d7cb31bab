#include "view/key_table.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

using A = KeyAction;

// In the order of the help page: what a newcomer needs comes first.
const std::vector<KeyRow>& rows() {
  static const std::vector<KeyRow> table = {
      {"x", "emergency stop: no force on the device", windows::motors, {{"x", A::stop}}},
      {"g, Shift-x",
       "give the device its force back",
       windows::motors,
       {{"g", A::give_back}, {"X", A::give_back}}},
      {"move the mouse", "the finger follows over the part", windows::led},
      {"hold left button", "press on the part; a click taps it", windows::led},
      {"Space", "press without holding, lift", windows::led, {{"space", A::press}}},
      {"wheel, Page keys", "press harder, softer", windows::led, {{"Prior", A::harder}, {"Next", A::softer}}},
      {"arrow keys",
       "move the finger on the surface",
       windows::led,
       {{"Left", A::go_left}, {"Right", A::go_right}, {"Up", A::go_up}, {"Down", A::go_down}}},
      {"drag beside part", "turn the view", windows::led},
      {"+, -",
       "view nearer, farther",
       windows::live,
       {{"plus", A::nearer},
        {"equal", A::nearer},
        {"minus", A::farther},
        {"KP_Add", A::nearer},
        {"KP_Subtract", A::farther}}},
      {"Space", "play, pause", windows::trace, {{"space", A::play}}},
      {"Left, Right", "one tick back, on", windows::trace, {{"Left", A::tick_back}, {"Right", A::tick_on}}},
      {"Page keys",
       "a twentieth of all back, on",
       windows::trace,
       {{"Prior", A::leap_back}, {"Next", A::leap_on}}},
      {"Home, End", "first tick, last tick", windows::trace, {{"Home", A::to_first}, {"End", A::to_last}}},
      {"+, -",
       "play faster, slower",
       windows::trace,
       {{"plus", A::faster},
        {"equal", A::faster},
        {"KP_Add", A::faster},
        {"minus", A::slower},
        {"KP_Subtract", A::slower}}},
      {"click charts, line", "go to that time", windows::trace},
      {"left drag", "turn the view", windows::view | windows::watched},
      {"middle drag", "move the view"},
      {"right drag, wheel", "nearer, farther", windows::view | windows::watched},
      {"wheel on a chart", "zoom; drag: move along", windows::moving},
      {"mouse over curve", "its value", windows::moving},
      {"1, 2, 3, 4",
       "from the front, back, left, right",
       windows::all,
       {{"1", A::front}, {"2", A::back}, {"3", A::left}, {"4", A::right}}},
      {"5, 6, 7",
       "from the top, the bottom, askew",
       windows::all,
       {{"5", A::top}, {"6", A::bottom}, {"7", A::isometric}}},
      {"0", "all in sight", windows::all, {{"0", A::all_in_sight}}},
      {"r", "view and charts as at first", windows::all, {{"r", A::first_view}}},
      {"t", "parts, to show and hide", windows::all, {{"t", A::parts}}},
      {"m", "material: friction, stiffness, law, method", windows::live, {{"m", A::materials}}},
      {"Tab, [, ]",
       "material: next row, less, more",
       windows::live,
       {{"Tab", A::next_row}, {"bracketleft", A::less}, {"bracketright", A::more}}},
      {"k", "mark a place; of two: their distance", windows::all, {{"k", A::mark}}},
      {"w", "parts as wires", windows::all, {{"w", A::wireframe}}},
      {"d", "dark or light", windows::all, {{"d", A::dark}}},
      {"s", "screenshot, whose name is told", windows::all, {{"s", A::screenshot}}},
      {"c", "colour the path by phase or by force", windows::trace, {{"c", A::colouring}}},
      {"p", "show the path", windows::trace, {{"p", A::path}}},
      {"f, a, n",
       "show finger, forces, tangent frame",
       windows::moving,
       {{"f", A::finger}, {"a", A::forces}, {"n", A::frame}}},
      {"i", "show the close-up", windows::moving, {{"i", A::close_up}}},
      {"e, o", "show edges, readings", windows::all, {{"e", A::creases}, {"o", A::readings}}},
      {"h, F1", "this page", windows::all, {{"h", A::help}, {"F1", A::help}}},
      {"q, Escape", "close", windows::all, {{"q", A::close}, {"Escape", A::leave}}},
  };
  return table;
}

std::string where_text(unsigned in) {
  if (in == windows::all) return "all";
  if (in == windows::live) return "live";
  if (in == windows::motors) return "live, with motors";
  if (in == windows::led) return "live, by mouse";
  if (in == (windows::view | windows::watched)) return "view; live, by a device";
  if (in == windows::view) return "view";
  if (in == windows::trace) return "view of a trace";
  return "view of a trace, live";
}

/// In code where it is typed; Markdown makes nothing of it there.
std::string key_text(const KeyRow& row) {
  return row.keys.empty() ? std::string(row.shown) : "`" + std::string(row.shown) + "`";
}

}  // namespace

std::span<const KeyRow> key_table() {
  return rows();
}

std::optional<KeyAction> action_of(std::string_view symbol, unsigned window) {
  for (const KeyRow& row : rows()) {
    if ((row.in & window) == 0) continue;
    for (const BoundKey& key : row.keys) {
      if (key.symbol == symbol) return key.action;
    }
  }
  return std::nullopt;
}

std::vector<std::string> help_lines(unsigned window) {
  std::vector<std::string> lines;
  for (const KeyRow& row : rows()) {
    if ((row.in & window) != 0) lines.push_back(std::string(row.shown) + ": " + std::string(row.does));
  }
  return lines;
}

std::string key_table_text() {
  std::string text = "| key or mouse | what it does | window |\n|---|---|---|\n";
  for (const KeyRow& row : rows()) {
    text += "| " + key_text(row) + " | " + std::string(row.does) + " | " + where_text(row.in) + " |\n";
  }
  return text;
}

}  // namespace fingerpad
