#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "study/fit_figures.hpp"

namespace fingerpad {

// What several of the pictures of a fit are put together from.

/// Samples of one trial.
struct TrialSpan {
  std::size_t trial = 0, from = 0, to = 0;
  std::size_t size() const { return to - from; }
};

/// The finger's angles of the trials that have a direction.
struct MeasuredAngles {
  double least_deg = 90, most_deg = 0;
  bool are_known() const noexcept { return least_deg <= most_deg; }
  /// Whether an angle is among them or hardly beyond.
  bool hold(double angle_deg) const noexcept {
    constexpr double hardly_deg = 2.5;
    return angle_deg > least_deg - hardly_deg && angle_deg < most_deg + hardly_deg;
  }
};
MeasuredAngles measured_angles(const Measurement& measurement);

/// Angles of the finger that a figure takes for one.
inline constexpr double alike_deg = 4;

/// How a trial is pushed along an axis, lateral and longitudinal: "across the finger".
inline constexpr const char* push_words[] = {"across the finger", "along the finger"};

/// Whether a trial's stick was pushed along an axis; of one without a direction nothing is known, and it was.
bool is_pushed(const FitPictureSource& source, std::size_t trial, std::size_t axis);

/// The angle of a subject's finger, of those nearest to 45 degrees the first, at which trials were pushed
/// along each of these axes; nothing where there is none.
std::optional<double> shown_angle_deg(const FitPictureSource& source, int subject,
                                      std::initializer_list<std::size_t> axes);

std::vector<int> subjects_in(const Measurement& measurement);

/// Which of the measurement's subjects one is: its colour and mark are the same in every panel.
std::size_t place_of(const FitPictureSource& source, int subject);

/// The direction of most motion in a span, unit.
Vec2 main_way(const StickSegments& segments, const TrialSpan& span);

std::vector<double> times_of(const MeasuredTrial& trial, const TrialSpan& span);

/// Values at samples of a span; where a contact begins anew there is a gap.
template <typename Value>
std::vector<double> over_span(const MeasuredTrial& trial, const TrialSpan& span, const Value& value) {
  std::vector<double> values;
  values.reserve(span.size());
  for (std::size_t i = span.from; i < span.to; ++i)
    values.push_back(trial.starts_anew[i] ? std::numeric_limits<double>::quiet_NaN() : value(i));
  return values;
}

/// One of several panels over time that stand over one another. Its curve is named as its axis, without the
/// unit.
ChartPanel strip(const std::string& y_label, std::string short_label, int colour,
                 const std::vector<double>& t_s, std::vector<double> y);

/// A chart that is not drawn, and why.
Chart refused_figure(std::string title, std::string why);

/// How many letters of a note a figure has room for, by its columns; one of strips has a page's width.
inline constexpr std::size_t note_of_one_column = 90, note_of_two_columns = 170, note_of_strips = 118;

/// Adds words to a figure's notes, in lines of at most so many letters.
void add_note(const std::string& words, std::size_t most_letters, Chart& chart);

/// Which of these numbers are refused, and why, in lines of at most so many letters; empty where none is.
std::vector<std::string> refusal_notes(const ProfileFit& fit, std::initializer_list<PadNumber> numbers,
                                       std::size_t most_letters);

}  // namespace fingerpad
