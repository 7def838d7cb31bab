#pragma once

#include <optional>
#include <string>

#include "view/pixels.hpp"
#include "view/view_input.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// Writes as PNG what the window would show: the parts, and where there are rows the finger, the contact, the
/// stick region, the forces, the path, a close-up and strip charts.
///
/// Starts a virtual screen where there is none.
/// @param at_s  the moment shown; without it the tick that telling_row picks. Clamped to the rows' times.
/// Throws Error: usage as refuse_picture_size does or where no screen is to be had, and as OutputFile
/// does.
void write_view_png(const ViewInput& input, const std::string& path, int width, int height,
                    std::optional<double> at_s, const ViewState& state);

/// Throws Error (usage) for a width or height outside 200 .. 8192, and for over 10 million pixels.
void refuse_picture_size(int width, int height);

/// As write_view_png, without a file.
Pixels view_pixels(const ViewInput& input, int width, int height, std::optional<double> at_s,
                   const ViewState& state);

/// The row at or just before a time; -1 without rows.
long row_at(const ViewInput& input, double t_s);

/// The moment that says most in a still picture: the stick (else the slip) with the greatest friction, else
/// the last; -1 without rows.
long telling_row(const ViewInput& input);

}  // namespace fingerpad
