#pragma once

#include <optional>
#include <string>

#include "fingerpad/error.hpp"

namespace fingerpad {

/// A picture of a trace.
struct PictureOptions {
  int width = 1280;            ///< [px], 200 .. 8192
  int height = 800;            ///< [px], 200 .. 8192
  std::optional<double> at_s;  ///< the moment shown; without it the one with the greatest friction
};

/// Draws the scene of a trace at one moment, with forces, path and strip charts, as PNG. Needs no screen: a
/// virtual one (Xvfb) is started where there is none. Throws Error: refused for the trace, usage for a size
/// that cannot be, fault where the file cannot be written.
void draw_trace(const std::string& trace_path, const std::string& png_path,
                const PictureOptions& options = {});

/// Plots position, speed, forces, coefficient of friction and their spectra over time, as PNG or SVG by the
/// path's ending. Throws Error as draw_trace.
void plot_trace(const std::string& trace_path, const std::string& picture_path);

/// Opens a window on a trace and returns when it is closed. Throws Error: refused for the trace, usage where
/// there is no display.
void show_trace(const std::string& trace_path);

}  // namespace fingerpad
