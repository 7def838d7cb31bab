#pragma once

#include <string>

#include "base/chart.hpp"
#include "view/comparison.hpp"
#include "view/drawing.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// What a plot shows of a touch.
enum class PlotSubject { history, spectrum };

/// Plots a touch as the paper lays out its figures: position (stick dotted, stick centre dashed), speed,
/// forces, coefficient of friction and phase over one time axis, and the spectra of the forces below.
///
/// PNG or SVG by the path's ending. SVG needs no screen; PNG starts a virtual one where there is none.
/// Throws Error: usage for another ending, refused for rows without a time span, and as OutputFile does.
/// @param page_width  [px], 300 .. 10000; the page is 1.2 times as high
/// @param over  what a history is drawn over; refused where that does not go on at all
/// `spectrum` draws the spectra alone (paper, fig. 11), on a page half as high as wide.
void write_plot(const ViewInput& input, const std::string& path, int page_width,
                PlotSubject subject = PlotSubject::history, Over over = Over::time);
inline constexpr int plot_page_width = 1400;

/// Draws runs laid over one another, with what is left between them. Errors as write_plot.
void write_comparison(const Comparison& comparison, Over over, const std::string& path, int page_width);

/// Draws a chart as a page of panels, PNG or SVG by the path's ending. Errors as write_plot.
void write_chart(const Chart& chart, const std::string& path);

/// Writes any drawing as PNG or SVG by the path's ending; errors as write_plot.
void write_drawing(const Drawing& drawing, int width, int height, const std::string& title,
                   const std::string& path);

}  // namespace fingerpad
