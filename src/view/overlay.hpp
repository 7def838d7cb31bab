#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "view/drawing.hpp"
#include "view/layout.hpp"
#include "view/view_input.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// A name and its value, as the head-up display has them.
using Reading = std::pair<std::string, std::string>;

/// How often ticks took how long: heights of bars up to 1, and what the first and the last one mean.
struct TickBars {
  std::vector<double> heights;  ///< may be none
  std::string shortest, longest;
};

/// What the flat parts of a picture (head-up display, legends, scale bar, time line) are drawn from.
struct OverlayFacts {
  std::string title, subtitle;     ///< what is shown; with what it is touched
  std::vector<std::string> about;  ///< lines on the part, where nothing moves
  std::optional<TickRecord> row;   ///< the moment shown
  double speed_m_per_s = 0;        ///< tangential, nan where unknown
  std::string surface_name;        ///< of what is touched
  std::vector<Reading> readings;   ///< beside those of the row
  TickBars tick_bars;
  bool brief = false;            ///< in a small window: phase and forces alone, and no legend
  Box hud, legend;               ///< where readings and legend stand; empty: they have no room
  std::vector<Box> panels = {};  ///< where lists stand
  double mm_per_n = 1;           ///< of force arrows
  double px_per_mm = 1;          ///< of the scene
  double max_force_n = 0;        ///< the colour bar's end
  double t_first_s = 0, t_last_s = 0;
  Mat3 axes_px = Mat3::Identity();  ///< column i: world axis i as seen on the screen (x, y, towards the eye)
  double inset_px_per_mm = 0;       ///< 0: no inset
  Box inset;                        ///< where it stands
  bool path = false;                ///< a path is drawn
  bool region = false;              ///< a stick region is drawn
  double grid_mm = 0;               ///< of a plane; 0: none
  struct Label {
    Vec2 at;
    std::string words;
  };
  std::vector<Label> labels;      ///< of the tangent frame's axes, in the scene
  std::optional<Vec2> finger_px;  ///< the contact, or the finger in the air; what is told keeps clear of it
  std::string invitation;         ///< how to begin, until it was done once
  std::string message;            ///< what has just been done, for a moment
  std::string notice;             ///< what is missing in the picture, and why
  std::vector<Vec2> marks;        ///< places that were marked, on the screen
  std::string marks_words;        ///< the distance of two, or where the one is
  std::string hint;               ///< of keys; empty in a picture
  std::string alarm;              ///< what has gone wrong; empty: nothing
  std::vector<std::string> help;  ///< "key: what it does", for the help page
};

/// Where what has gone wrong is told: a line or a few at the top of the scene, empty where nothing has.
Box alarm_line(const std::string& alarm, const Layout& layout);
/// The layout with the scene that this leaves.
Layout below_alarm(const std::string& alarm, const Layout& layout);

/// The time line's slider within a layout.
Box time_slider(const Layout& layout);

/// The flat part of a picture that changes from moment to moment: the readings; over them what belongs to
/// places of the scene (axes, scale, legend, marks); and over that and the lists all the rest. The readings
/// are drawn by themselves, since a device of VTK keeps fifty texts from one frame to the next, and of more
/// none.
Drawing readings_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout);
Drawing ground_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout);
Drawing overlay_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout);

/// A colour for 0 .. 1, dark to light (viridis of van der Walt & Smith, five stops).
Colour ramp_colour(double share);

}  // namespace fingerpad
