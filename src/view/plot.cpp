#include "view/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "view/chart.hpp"
#include "view/chart_layout.hpp"
#include "view/flat_picture.hpp"
#include "view/overlay_words.hpp"
#include "view/several_walls.hpp"
#include "view/svg.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad {
namespace {

/// How wide a page is, in heights of its letters.
constexpr double ems_a_page = 62;

bool ends_with(const std::string& path, std::string_view ending) {
  std::string tail = path.size() < ending.size() ? path : path.substr(path.size() - ending.size());
  std::transform(tail.begin(), tail.end(), tail.begin(), [](unsigned char c) { return std::tolower(c); });
  return tail == ending;
}

/// What was left out; empty where every tick is there.
std::string thinned_words(const ViewInput& input) {
  if (input.every <= 1) return {};
  if (!input.every_is_told) return "ticks were left out (the last row comes sooner than the others)";
  return fmt::format("{}1 {}in {} is here", input.scene ? "of which " : "", input.scene ? "" : "tick ",
                     input.every);
}

/// @param tail  behind what was left out: what is not there therefore
std::string subtitle_of(const ViewInput& input, const char* tail) {
  std::string words;
  if (input.scene) {
    words = fmt::format("friction: {}, {} ticks a second", input.scene->friction.law,
                        static_cast<long>(std::lround(input.scene->motion.rate_hz)));
  }
  if (const std::string thinned = thinned_words(input); !thinned.empty())
    words += fmt::format("{}{}{}", words.empty() ? "" : ", ", thinned, tail);
  return words;
}

/// What u is, where it is no axis, and what forces are where several walls hold the finger.
std::string axes_words(const ViewInput& input, const Vec3& direction_W) {
  std::string words;
  if (direction_W.cwiseAbs().maxCoeff() < 0.99996192)
    words = fmt::format("u is the position along ({}, {}, {})", fixed_text(direction_W.x(), 2),
                        fixed_text(direction_W.y(), 2), fixed_text(direction_W.z(), 2));
  if (any_held_by_several_walls(input.rows))
    words += fmt::format("{}{}", words.empty() ? "" : "; ", several_walls_words);
  return words;
}

/// @returns where the page below its title begins
double draw_title(Drawing& page, const std::string& title, const std::vector<std::string>& subtitles,
                  int width, int height, double em) {
  double top = height - 1.0 * em;
  const auto line = [&](const std::string& words, double size, double least, TextStyle style) {
    const double room = width - 2 * em;
    const double whole = text_width(words, size, style.bold);
    style.size = std::max(least, whole > room ? size * room / whole : size);
    style.across = Across::centre;
    style.upright = Upright::top;
    page.text({width / 2.0, top}, fitted_in_middle(words, style.size, style.bold, room), style);
  };
  line(title, chart_title_ems * em, 1.1 * em, {.bold = true});
  top -= 2.1 * em;
  for (const std::string& words : subtitles) {
    line(words, em, 0.75 * em, {.colour = colours::grey});
    top -= 1.9 * em;
  }
  return top;
}

/// What the spectrum of some of the ticks is not.
std::string folding_words(const Chart& spectrum) {
  return fmt::format("ticks were left out: what is faster than {:.0f} Hz appears as something slower",
                     spectrum.panels[0].curves[0].x.back());
}

/// What a history of some of the ticks cannot tell.
std::vector<std::string> history_subtitles(const ViewInput& input, const Vec3& direction_W, Over over,
                                           const Chart& spectrum) {
  std::vector<std::string> subtitles = {subtitle_of(input, ": no rings where slip ended")};
  if (std::string axes = axes_words(input, direction_W); !axes.empty()) subtitles.push_back(std::move(axes));
  if (input.every <= 1) return subtitles;
  if (over != Over::time) subtitles.emplace_back(shortened_words(over));
  if (!spectrum.panels.empty() && !spectrum.panels[0].curves.empty())
    subtitles.push_back("spectrum: " + folding_words(spectrum));
  return subtitles;
}

Drawing history_drawing(const ViewInput& input, Over over, int width, int height) {
  Drawing page;
  const double em = width / ems_a_page, margin = 0.8 * em;
  const Vec3 direction_W = main_direction(input.rows);
  const Chart spectrum = spectrum_chart(touch_series(input.rows, direction_W));
  const double top =
      draw_title(page, input.title, history_subtitles(input, direction_W, over, spectrum), width, height, em);
  Chart touch = touch_chart(input.rows, direction_W, touch_levels(input));
  if (over != Over::time) put_over(touch, abscissa(input.rows, over), abscissa_label(over));
  const double spectrum_height = spectrum.panels.empty() ? 0 : 0.2 * height + 0.8 * em;
  const double bottom = 0.6 * em + spectrum_height;
  const Box above{margin, bottom, width - 2 * margin, top - bottom};
  const Box below{margin, 0.6 * em, width - 2 * margin, 0.2 * height};
  double left = stacked_layout(touch, above, em).panels.front().frame.left;
  if (!spectrum.panels.empty()) {
    left = std::max(left, stacked_layout(spectrum, below, em).panels.front().frame.left);
    draw_chart(page, spectrum, below, em, left);
  }
  draw_chart(page, touch, above, em, left);
  return page;
}

/// Where a curve is greatest, beyond the slow changes of the stroke itself.
double peak_hz(const ChartCurve& curve) {
  constexpr double slow_hz = 10;
  const std::vector<double>& density = curve.y;
  std::size_t best = density.size() - 1;
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (curve.x[i] > slow_hz && density[i] > density[best]) best = i;
  }
  return curve.x[best];
}

Drawing spectrum_drawing(const ViewInput& input, int width, int height) {
  Drawing page;
  const double em = width / ems_a_page, margin = 0.8 * em;
  const Vec3 direction_W = main_direction(input.rows);
  const Chart spectrum = spectrum_chart(touch_series(input.rows, direction_W));
  if (spectrum.panels.empty()) throw refused(input.title, "is too short for a spectrum: it needs 32 ticks");
  if (spectrum.panels[0].curves.empty())
    throw refused(input.title, "has forces that do not change: no spectrum");
  const ChartCurve& first = spectrum.panels[0].curves[0];
  std::vector<std::string> subtitles = {subtitle_of(input, "")};
  // Where ticks were left out a peak may be that of something faster.
  if (input.every > 1)
    subtitles.push_back(folding_words(spectrum));
  else
    subtitles[0] +=
        fmt::format("{}{} peaks at {:.0f} Hz", subtitles[0].empty() ? "" : "; ", first.name, peak_hz(first));
  if (std::string axes = axes_words(input, direction_W); !axes.empty()) subtitles.push_back(std::move(axes));
  const double top = draw_title(page, input.title, subtitles, width, height, em);
  draw_chart(page, spectrum, {margin, 0.6 * em, width - 2 * margin, top - 0.6 * em}, em);
  return page;
}

/// A page of a stacked chart.
Drawing stacked_drawing(const Chart& chart, int width, int height) {
  Drawing page;
  const double em = width / ems_a_page, margin = 0.8 * em;
  const double top = draw_title(page, chart.title, chart.notes, width, height, em);
  draw_chart(page, chart, {margin, 0.6 * em, width - 2 * margin, top - 0.6 * em}, em);
  return page;
}

void refuse_other_widths(const std::string& path, int page_width) {
  if (page_width < 300 || page_width > 10000)
    throw Error(ErrorKind::usage, path, "a page is 300 to 10000 pixels wide");
}

/// As high as its words and its panels take, which of many curves are higher.
void write_stacked(const Chart& chart, const std::string& path, int page_width) {
  constexpr std::size_t few_curves = 3;
  const auto panels = static_cast<int>(chart.panels.size());
  const auto notes = static_cast<int>(chart.notes.size());
  const bool are_many =
      chart.legend_rows > 1 && std::ranges::any_of(chart.panels, [](const ChartPanel& panel) {
        return panel.curves.size() > few_curves;
      });
  const double em = page_width / ems_a_page;
  const int height = page_width * (16 + 6 * notes + (are_many ? 50 : 36) * panels) / 200 +
                     static_cast<int>(further_legend_lines_px(chart, page_width - 1.6 * em, em));
  write_drawing(stacked_drawing(chart, page_width, height), page_width, height, chart.title, path);
}

}  // namespace

void write_comparison(const Comparison& comparison, Over over, const std::string& path, int page_width) {
  refuse_other_widths(path, page_width);
  write_stacked(comparison_chart(comparison, over), path, page_width);
}

void write_drawing(const Drawing& drawing, int width, int height, const std::string& title,
                   const std::string& path) {
  if (ends_with(path, ".svg")) {
    write_svg(drawing, width, height, title, path);
  } else if (ends_with(path, ".png")) {
    write_flat_png(drawing, width, height, path);
  } else {
    throw Error(ErrorKind::usage, path, "a plot ends in .png or .svg");
  }
}

void write_chart(const Chart& chart, const std::string& path) {
  // Letters as large as on a page of charts that do not stand over one another.
  constexpr auto stacked_page_width = static_cast<int>(ems_a_page * chart_page_em);
  if (chart.stacked) return write_stacked(chart, path, stacked_page_width);
  const ChartPage page = chart_page(chart);
  write_drawing(page.drawing, page.width, page.height, chart.title, path);
}

void write_plot(const ViewInput& input, const std::string& path, int page_width, PlotSubject subject,
                Over over) {
  refuse_other_widths(path, page_width);
  if (input.rows.size() < 2 || !(input.rows.back().t_s > input.rows.front().t_s)) {
    throw refused(input.title, "holds fewer than two moments: nothing to plot against time");
  }
  const bool history = subject == PlotSubject::history;
  if (history) refuse_standstill(abscissa(input.rows, over), over, input.title);
  const int height = history ? page_width * 6 / 5 : page_width / 2;
  const Drawing drawing = history ? history_drawing(input, over, page_width, height)
                                  : spectrum_drawing(input, page_width, height);
  write_drawing(drawing, page_width, height, input.title, path);
}

}  // namespace fingerpad
