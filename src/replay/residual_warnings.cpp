#include "replay/residual_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "replay/figures.hpp"

namespace fingerpad {
namespace {

/// A bias below both is a good sensor's.
constexpr double notable_n = 0.02, notable_share = 0.02;
/// A mean that is nearly all of the residual.
constexpr double nearly_all = 0.9;
constexpr double notable_lag_s = 2e-3, ms_per_s = 1e3;

/// So many times as hard as the model no pad's own stiffness makes a measurement, nor so many times less.
constexpr double far_off = 3;

/// Whether the measured force is another quantity than the model's, or the model's finger elsewhere.
enum class Scale { alike, opposite, far_off };

Scale scale_of(const std::vector<double>& figures) {
  const double scale = Figures::of(figures, "residual_scale");
  if (scale < -1 / far_off) return Scale::opposite;
  return scale > far_off || std::abs(scale) < 1 / far_off ? Scale::far_off : Scale::alike;
}

/// Where a constant in the residual is seen.
enum class BiasSeen { nowhere, without_contact, all_along };

BiasSeen bias_seen(const std::vector<double>& figures) {
  if (scale_of(figures) != Scale::alike) return BiasSeen::nowhere;  // which says more
  const double bias_n = Figures::of(figures, "residual_bias_n");
  const double most_n = Figures::of(figures, "max_normal_force_n");
  if (!(bias_n > std::max(notable_n, notable_share * most_n))) return BiasSeen::nowhere;
  const double free_ticks = Figures::of(figures, "ticks") - Figures::of(figures, "contact_ticks");
  if (free_ticks >= ResidualFigures::least_free_ticks) return BiasSeen::without_contact;
  return bias_n > nearly_all * Figures::of(figures, "residual_rms_n") ? BiasSeen::all_along
                                                                      : BiasSeen::nowhere;
}

bool is_late(const std::vector<double>& figures) {
  return std::abs(Figures::of(figures, "residual_lag_s")) >= notable_lag_s;
}

std::string scale_words(const std::vector<double>& figures) {
  const double scale = Figures::of(figures, "residual_scale");
  switch (scale_of(figures)) {
    case Scale::opposite:
      return fmt::format(
          "the measured force presses the other way than the model's, {} times as hard (residual_scale): is "
          "it "
          "the force on the plate? Say so by force_on = \"plate\" in [motion]",
          rounded_text(-scale, 2));
    case Scale::far_off:
      return fmt::format(
          "the measured force presses {} times as hard as the model (residual_scale): are positions the "
          "fingertip's, where [finger] radius_m takes them for a ball's centre, is the surface elsewhere, or "
          "the force's unit another (force_unit in [motion])?",
          rounded_text(scale, 2));
    case Scale::alike:
      break;
  }
  return "";
}

std::string bias_words(const std::vector<double>& figures) {
  const double bias_n = Figures::of(figures, "residual_bias_n");
  switch (bias_seen(figures)) {
    case BiasSeen::without_contact:
      return fmt::format(
          "the measured force is {} N on average while the model touches nothing (residual_bias_n): take "
          "the sensor's zero off the file's forces, as `fingerpad fit` does by itself (its tare), or mend "
          "the surface's place, where the finger did touch there",
          rounded_text(bias_n, 2));
    case BiasSeen::all_along:
      return fmt::format(
          "{} N of the residual's {} N are the same all along (residual_bias_n): the sensor was not "
          "tared, or the contact is too hard or too soft throughout; a recording that begins before the "
          "touch tells which, and `fingerpad fit` takes its tare off",
          rounded_text(bias_n, 2), rounded_text(Figures::of(figures, "residual_rms_n"), 2));
    case BiasSeen::nowhere:
      break;
  }
  return "";
}

std::string lag_words(const std::vector<double>& figures) {
  if (!is_late(figures)) return "";
  const double lag_s = Figures::of(figures, "residual_lag_s");
  return fmt::format(
      "the measured force fits the model's best when it is taken {} ms {} (residual_lag_s): the "
      "recorder's forces come {} than its positions, or the finger's spring is {} than the model's; "
      "`fingerpad fit` tells which: its delay, or its stick_stiffness",
      rounded_text(ms_per_s * std::abs(lag_s), 3), lag_s > 0 ? "earlier" : "later",
      lag_s > 0 ? "later" : "earlier", lag_s > 0 ? "softer" : "stiffer");
}

}  // namespace

std::vector<std::string> residual_warnings(const std::vector<double>& figures) {
  std::vector<std::string> warnings;
  for (std::string words : {scale_words(figures), bias_words(figures), lag_words(figures)}) {
    if (!words.empty()) warnings.push_back(std::move(words));
  }
  return warnings;
}

std::vector<std::string> residual_doubts(const std::vector<double>& figures) {
  std::vector<std::string> doubts;
  if (scale_of(figures) != Scale::alike)
    doubts.push_back(fmt::format("measured force {} times the model's",
                                 rounded_text(Figures::of(figures, "residual_scale"), 2)));
  if (bias_seen(figures) != BiasSeen::nowhere)
    doubts.push_back(fmt::format("measured force off by {} N{}",
                                 rounded_text(Figures::of(figures, "residual_bias_n"), 2),
                                 bias_seen(figures) == BiasSeen::without_contact ? " without contact" : ""));
  if (!is_late(figures)) return doubts;
  const double lag_s = Figures::of(figures, "residual_lag_s");
  doubts.push_back(fmt::format("measured force fits {} ms {}: {}, or a {} spring",
                               rounded_text(ms_per_s * std::abs(lag_s), 3), lag_s > 0 ? "later" : "earlier",
                               lag_s > 0 ? "late" : "early", lag_s > 0 ? "softer" : "stiffer"));
  return doubts;
}

}  // namespace fingerpad
