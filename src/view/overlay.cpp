#include "view/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "view/axis.hpp"
#include "view/colours.hpp"

namespace fingerpad {
namespace {

constexpr Colour panel_colour{255, 255, 255, 0.86}, alarm_colour{178, 24, 32};

std::string number_with_unit(double value, int digits, const char* unit) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.{}f}{}{}", value, digits, *unit != '\0' ? " " : "", unit);
}

/// Draws the overlay; holds what its parts share.
class OverlayPainter {
 public:
  OverlayPainter(Drawing& drawing, const OverlayFacts& facts, const ViewState& state, const Layout& layout)
      : drawing_(drawing), facts_(facts), state_(state), layout_(layout), em_(layout.em) {}

  void paint() {
    paint_title();
    for (const auto& label : facts_.labels) {
      drawing_.text(label.at, label.words,
                    {.size = 0.95 * em_, .across = Across::centre, .upright = Upright::middle});
    }
    if (state_.hud) {
      if (facts_.row) {
        paint_readings();
        paint_legend();
      } else {
        paint_about();
      }
    }
    paint_scale_and_axes();
    if (facts_.inset_px_per_mm > 0) paint_inset_frame();
    if (layout_.timeline.height > 0) paint_timeline();
    if (!facts_.alarm.empty()) paint_alarm();
    if (state_.help) paint_help();
  }

 private:
  void panel(const Box& box) {
    drawing_.box(box, panel_colour);
    drawing_.frame(box, {colours::pale_grey, 1});
  }

  void paint_title() {
    drawing_.box(layout_.title, colours::white);
    const double middle = layout_.title.centre().y();
    drawing_.text({0.7 * em_, middle}, facts_.title,
                  {.size = 1.15 * em_, .upright = Upright::middle, .bold = true});
    if (!facts_.hint.empty()) {
      drawing_.text(
          {layout_.title.right() - 0.7 * em_, middle}, facts_.hint,
          {.size = 0.95 * em_, .colour = colours::grey, .across = Across::right, .upright = Upright::middle});
    }
  }

  double alarm_height() const { return facts_.alarm.empty() ? 0 : 2 * em_; }

  /// Below the title, cut where it does not fit: the terminal has it whole.
  void paint_alarm() {
    const double room = layout_.scene.width - 1.4 * em_, size = 1.15 * em_;
    std::string words = facts_.alarm, shown = words;
    while (!words.empty() && text_width(shown, size, true) > room) {
      while (!words.empty() && (words.back() & 0xc0) == 0x80) words.pop_back();  // the rest of a letter
      if (!words.empty()) words.pop_back();
      shown = words + "...";
    }
    const Box line{layout_.scene.left, layout_.scene.top() - alarm_height(), layout_.scene.width,
                   alarm_height()};
    drawing_.box(line, alarm_colour);
    drawing_.text({line.left + 0.7 * em_, line.centre().y()}, shown,
                  {.size = size, .colour = colours::white, .upright = Upright::middle, .bold = true});
  }

  void paint_readings() {
    const TickRecord& row = *facts_.row;
    const bool touching = row.phase != Phase::free;
    const auto in_contact = [&](double value, int digits, const char* unit) {
      return touching ? number_with_unit(value, digits, unit) : std::string("-");
    };
    std::vector<Reading> readings = {
        {"time", number_with_unit(row.t_s, 3, "s")},
        {"phase", std::string(phase_name(row.phase))},
        {"depth", in_contact(row.depth_m * 1e3, 3, "mm")},
        {"normal force", in_contact(row.normal_force_n, 3, "N")},
        {"friction", in_contact(row.friction_W_n.norm(), 3, "N")},
        {"mu", in_contact(row.mu, 3, "")},
        {"speed", in_contact(facts_.speed_m_per_s * 1e3, 1, "mm/s")},
        {"finger angle", in_contact(row.inclination_rad * 180 / std::numbers::pi, 1, "deg")},
        {"on", touching ? facts_.surface_name : std::string("-")},
    };
    readings.insert(readings.end(), facts_.readings.begin(), facts_.readings.end());
    const double line = 1.5 * em_;
    const double width = 14.5 * em_;
    const double bars = facts_.tick_bars.empty() ? 0 : 2.6 * em_;
    const double height = line * static_cast<double>(readings.size()) + 0.8 * em_ + bars;
    const Box box{layout_.scene.left + 0.7 * em_, layout_.scene.top() - alarm_height() - 0.7 * em_ - height,
                  width, height};
    panel(box);
    paint_tick_bars({box.left + 0.6 * em_, box.bottom + 0.5 * em_, width - 1.2 * em_, bars - 0.6 * em_});
    double y = box.top() - 0.4 * em_ - line / 2;
    for (const auto& [name, value] : readings) {
      const bool phase = name == "phase";
      drawing_.text({box.left + 0.6 * em_, y}, name,
                    {.size = em_, .colour = colours::grey, .upright = Upright::middle});
      if (phase) {
        const double chip = text_width(value, em_, true) + 1.2 * em_;
        drawing_.box({box.right() - 0.6 * em_ - chip, y - 0.68 * em_, chip, 1.36 * em_},
                     phase_colour(row.phase));
      }
      drawing_.text({box.right() - (phase ? 1.2 : 0.6) * em_, y}, value,
                    {.size = em_,
                     .colour = phase ? colours::white : colours::ink,
                     .across = Across::right,
                     .upright = Upright::middle,
                     .bold = phase});
      y -= line;
    }
  }

  void paint_tick_bars(const Box& box) {
    if (facts_.tick_bars.empty()) return;
    const double step = box.width / static_cast<double>(facts_.tick_bars.size());
    double left = box.left;
    for (const double share : facts_.tick_bars) {
      if (share > 0)
        drawing_.box({left, box.bottom, 0.9 * step, std::max(1.0, share * box.height)}, colours::grey);
      left += step;
    }
  }

  void paint_about() {
    if (facts_.about.empty()) return;
    double width = 0;
    for (const std::string& words : facts_.about) width = std::max(width, text_width(words, em_));
    const double line = 1.5 * em_;
    const double height = line * static_cast<double>(facts_.about.size()) + 0.8 * em_;
    const Box box{layout_.scene.left + 0.7 * em_, layout_.scene.top() - 0.7 * em_ - height, width + 1.4 * em_,
                  height};
    panel(box);
    double y = box.top() - 0.4 * em_ - line / 2;
    for (const std::string& words : facts_.about) {
      drawing_.text({box.left + 0.6 * em_, y}, words, {.size = em_, .upright = Upright::middle});
      y -= line;
    }
  }

  struct Key {
    std::string label;
    Colour colour;
    bool arrow;
  };

  std::vector<Key> legend_keys() const {
    std::vector<Key> keys;
    if (state_.forces) {
      keys.push_back({"normal force", colours::blue, true});
      keys.push_back({"friction", colours::vermillion, true});
      keys.push_back({"whole force", colours::reddish_purple, true});
    }
    if (facts_.row->stick_centre_W.allFinite()) {
      keys.push_back({"stick centre", colours::black, false});
    }
    if (facts_.region) {
      const bool holds = facts_.row->phase == Phase::stick;
      keys.push_back({holds ? "stick region" : "stick region, if it stuck now",
                      holds ? phase_colour(Phase::stick) : colours::grey, false});
    }
    return keys;
  }

  void paint_legend() {
    const std::vector<Key> keys = legend_keys();
    const bool path = state_.path && facts_.path;
    const bool bar = path && state_.colouring == PathColouring::force;
    const double line = 1.4 * em_;
    const double lines =
        static_cast<double>(keys.size()) + (state_.forces ? 1 : 0) + (path ? (bar ? 3.0 : 1.0) : 0.0);
    if (lines == 0) return;
    double width = 15.5 * em_;
    for (const Key& key : keys) width = std::max(width, text_width(key.label, em_) + 4 * em_);
    const Box box{layout_.scene.left + 0.7 * em_, layout_.scene.bottom + 0.7 * em_, width,
                  lines * line + 0.8 * em_};
    panel(box);
    const double left = box.left + 0.6 * em_;
    double y = box.top() - 0.4 * em_ - line / 2;
    for (const Key& key : keys) {
      if (key.arrow) {
        drawing_.line({left, y}, {left + 1.4 * em_, y}, {key.colour, 0.2 * em_});
        drawing_.area(
            {{left + 1.3 * em_, y - 0.35 * em_}, {left + 2 * em_, y}, {left + 1.3 * em_, y + 0.35 * em_}},
            key.colour);
      } else {
        drawing_.disc({left + 1 * em_, y}, 0.4 * em_, key.colour);
      }
      drawing_.text({left + 2.6 * em_, y}, key.label, {.size = em_, .upright = Upright::middle});
      y -= line;
    }
    if (state_.forces) {
      drawing_.text({left, y}, fmt::format("arrows: {} mm = 1 N", plain_number(facts_.mm_per_n)),
                    {.size = em_, .colour = colours::grey, .upright = Upright::middle});
      y -= line;
    }
    if (!path) return;
    if (bar) {
      paint_colour_bar({left, y - 2.2 * line, width - 1.2 * em_, 0.8 * em_}, y);
      return;
    }
    double x = left;
    drawing_.text({x, y}, "path:", {.size = em_, .colour = colours::grey, .upright = Upright::middle});
    x += text_width("path:", em_) + 0.6 * em_;
    for (const Phase phase : {Phase::free, Phase::stick, Phase::slip}) {
      const std::string name(phase_name(phase));
      drawing_.box({x, y - 0.35 * em_, 0.7 * em_, 0.7 * em_}, phase_colour(phase));
      drawing_.text({x + em_, y}, name, {.size = em_, .upright = Upright::middle});
      x += text_width(name, em_) + 1.9 * em_;
    }
  }

  void paint_colour_bar(const Box& box, double title_y) {
    drawing_.text({box.left, title_y}, "path: force on the finger [N]",
                  {.size = em_, .colour = colours::grey, .upright = Upright::middle});
    constexpr int cells = 40;
    for (int i = 0; i < cells; ++i) {
      drawing_.box(
          {box.left + box.width * i / cells, box.bottom + 1.2 * em_, box.width / cells + 0.5, box.height},
          ramp_colour((i + 0.5) / cells));
    }
    const double low = box.bottom + 0.95 * em_;
    drawing_.text({box.left, low}, "0", {.size = em_, .upright = Upright::top});
    drawing_.text({box.right(), low}, fmt::format("{:.3g}", facts_.max_force_n),
                  {.size = em_, .across = Across::right, .upright = Upright::top});
  }

  void paint_scale_and_axes() {
    const Vec2 middle(layout_.scene.right() - 3.6 * em_, layout_.scene.bottom + 3.6 * em_);
    constexpr const char* names[] = {"x", "y", "z"};
    std::array<int, 3> order{0, 1, 2};  // the axis nearest to the eye comes last
    std::sort(order.begin(), order.end(),
              [this](int a, int b) { return facts_.axes_px(2, a) < facts_.axes_px(2, b); });
    for (const int axis : order) {
      const Vec2 along = facts_.axes_px.col(axis).head<2>();
      const Colour colour = facts_.axes_px(2, axis) < -0.2 ? colours::grey : colours::ink;
      drawing_.line(middle, middle + along * 2.0 * em_, {colour, 0.15 * em_});
      drawing_.text(middle + along * 2.7 * em_, names[axis],
                    {.size = em_, .colour = colour, .across = Across::centre, .upright = Upright::middle});
    }
    if (!(facts_.px_per_mm > 0)) return;
    const double length_mm = round_down_125(9 * em_ / facts_.px_per_mm);
    paint_scale_bar({middle.x() - 4.2 * em_, layout_.scene.bottom + 1.2 * em_}, length_mm, facts_.px_per_mm);
  }

  /// A bar that ends at `right_end`, with its length above.
  void paint_scale_bar(const Vec2& right_end, double length_mm, double px_per_mm) {
    const Vec2 left_end = right_end - Vec2(length_mm * px_per_mm, 0);
    const double half = 0.3 * em_;
    const Stroke stroke{colours::ink, 0.14 * em_};
    drawing_.line(left_end, right_end, stroke);
    for (const Vec2& end : {left_end, right_end}) {
      drawing_.line(end - Vec2(0, half), end + Vec2(0, half), stroke);
    }
    drawing_.text((left_end + right_end) / 2 + Vec2(0, 0.4 * em_), plain_number(length_mm) + " mm",
                  {.size = em_, .across = Across::centre});
  }

  void paint_inset_frame() {
    const Box& box = facts_.inset;
    drawing_.frame(box, {colours::grey, std::max(1.0, 0.1 * em_)});
    drawing_.box({box.left, box.top() - 1.5 * em_, box.width, 1.5 * em_}, panel_colour);
    const double zoom = facts_.inset_px_per_mm / facts_.px_per_mm;
    drawing_.text({box.centre().x(), box.top() - 0.75 * em_},
                  fmt::format("contact, {:.{}f}x", zoom, zoom < 10 ? 1 : 0),
                  {.size = em_, .across = Across::centre, .upright = Upright::middle});
    drawing_.box({box.left, box.bottom, box.width, 2.3 * em_}, panel_colour);
    drawing_.text({box.left + 0.6 * em_, box.bottom + 1.15 * em_}, "up: finger",
                  {.size = em_, .colour = colours::grey, .upright = Upright::middle});
    const double length_mm = round_down_125(0.4 * box.width / facts_.inset_px_per_mm);
    paint_scale_bar({box.right() - 0.8 * em_, box.bottom + 0.6 * em_}, length_mm, facts_.inset_px_per_mm);
  }

  void paint_timeline() {
    drawing_.box(layout_.timeline, colours::white);
    drawing_.line({layout_.timeline.left, layout_.timeline.top()},
                  {layout_.timeline.right(), layout_.timeline.top()}, {colours::pale_grey, 1});
    const Box slider = time_slider(layout_);
    const double y = slider.centre().y();
    const double x = layout_.timeline.left + 0.9 * em_;
    if (state_.playing) {
      drawing_.box({x, y - 0.55 * em_, 0.35 * em_, 1.1 * em_}, colours::ink);
      drawing_.box({x + 0.6 * em_, y - 0.55 * em_, 0.35 * em_, 1.1 * em_}, colours::ink);
    } else {
      drawing_.area({{x, y - 0.6 * em_}, {x + 1.0 * em_, y}, {x, y + 0.6 * em_}}, colours::ink);
    }
    const double span_s = facts_.t_last_s - facts_.t_first_s;
    const double t_s = facts_.row ? facts_.row->t_s : facts_.t_first_s;
    const double share = span_s > 0 ? std::clamp((t_s - facts_.t_first_s) / span_s, 0.0, 1.0) : 0;
    drawing_.box({slider.left, y - 0.15 * em_, slider.width, 0.3 * em_}, colours::pale_grey);
    drawing_.box({slider.left, y - 0.15 * em_, slider.width * share, 0.3 * em_}, colours::blue);
    drawing_.disc({slider.left + slider.width * share, y}, 0.55 * em_, colours::blue);
    std::string time = fmt::format("{:.3f} / {:.3f} s", t_s, facts_.t_last_s);
    if (state_.speed != 1) time += fmt::format("  {}x", plain_number(state_.speed));
    drawing_.text({slider.right() + 1.2 * em_, y}, time, {.size = em_, .upright = Upright::middle});
  }

  void paint_help() {
    const double line = 1.6 * em_;
    const double height = line * static_cast<double>(facts_.help.size()) + 3.4 * em_;
    const Vec2 middle = layout_.window.centre();
    const double width = std::min(34 * em_, layout_.window.width - 2 * em_);
    const Box box{middle.x() - width / 2, middle.y() - height / 2, width, height};
    drawing_.box(box, Colour{255, 255, 255, 0.96});
    drawing_.frame(box, {colours::ink, 0.12 * em_});
    drawing_.text({middle.x(), box.top() - 1.4 * em_}, "keys",
                  {.size = 1.2 * em_, .across = Across::centre, .upright = Upright::middle, .bold = true});
    double y = box.top() - 3.2 * em_;
    for (const std::string& entry : facts_.help) {
      const std::size_t colon = entry.find(": ");
      drawing_.text({box.left + 1.2 * em_, y}, entry.substr(0, colon),
                    {.size = em_, .upright = Upright::middle, .bold = true});
      if (colon != std::string::npos) {
        drawing_.text({box.left + 11.5 * em_, y}, entry.substr(colon + 2),
                      {.size = em_, .upright = Upright::middle});
      }
      y -= line;
    }
  }

  Drawing& drawing_;
  const OverlayFacts& facts_;
  const ViewState& state_;
  const Layout& layout_;
  double em_;
};

}  // namespace

Colour ramp_colour(double share) {
  constexpr Colour stops[] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  const double place = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * 4;
  const int low = std::min(3, static_cast<int>(place));
  const double part = place - low;
  const auto mix = [&](std::uint8_t Colour::*channel) {
    return static_cast<std::uint8_t>(
        std::lround(stops[low].*channel * (1 - part) + stops[low + 1].*channel * part));
  };
  return {mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue)};
}

Box time_slider(const Layout& layout) {
  const double em = layout.em;
  const double left = layout.timeline.left + 3.2 * em;
  return {left, layout.timeline.bottom + 0.5 * em, layout.timeline.right() - 15 * em - left,
          layout.timeline.height - em};
}

Drawing overlay_drawing(const OverlayFacts& facts, const ViewState& state, const Layout& layout) {
  Drawing drawing;
  OverlayPainter(drawing, facts, state, layout).paint();
  return drawing;
}

}  // namespace fingerpad
