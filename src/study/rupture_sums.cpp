#include "study/rupture_sums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/position_parabola.hpp"
#include "study/spring_way.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t fewest = 5;        // samples of a line
constexpr std::size_t usual_tail = 2;    // samples in which a drop that is not at once is over
constexpr long fewest_drops = 20;        // that tell how late a drop is
constexpr std::size_t drop_samples = 5;  // of a drop and what it comes to: no tooth that counts is shorter

/// Whether the teeth of a finger that moves on so have enough samples, wherever between two of them each
/// gives way: did the tooth's own number decide, those that give way late would be kept.
/// @param tooth_m  the spring's way from where it is entered to where it gives way; a bent spring's is soft
///                 in its beginning, so that its stiffness at the end would make it too short
/// @param step_m   the finger's from sample to sample
/// @param left_out  samples of a tooth that no line takes
bool has_long_teeth(double tooth_m, double step_m, std::size_t left_out) {
  return tooth_m >= static_cast<double>(fewest + left_out) * step_m;
}

/// How far springs give way along a direction, for a unit of the force ratio.
class GivingWay {
 public:
  GivingWay(const std::array<SpringBend, 2>& bend, const Vec2& forward) : bend_(bend), forward_(forward) {}

  double at(double ratio) const {
    return forward_.x() * forward_.x() * bend_[0].at(ratio)[0] +
           forward_.y() * forward_.y() * bend_[1].at(ratio)[0];
  }
  /// The ratio at which they have given way so far: a straight spring's is the way itself.
  double ratio_of(double way) const {
    constexpr int passes = 50;
    double least = 0, most = 1;
    while (most * at(most) < way && most < 1e3) most *= 2;
    for (int pass = 0; pass < passes; ++pass) {
      const double middle = (least + most) / 2;
      (middle * at(middle) < way ? least : most) = middle;
    }
    return (least + most) / 2;
  }

 private:
  const std::array<SpringBend, 2>& bend_;
  Vec2 forward_;
};

/// The spring's own way g(q) at some samples of stick, as a line over the finger's.
struct GivenLine {
  Vec2 mean_q{0, 0}, slope{0, 0};
  double mean_s = 0, squares = 0, count = 0;

  template <typename Given, typename Way>
  GivenLine(std::size_t from, std::size_t to, const Given& given_at, const Way& way_at)
      : count(static_cast<double>(to - from)) {
    for (std::size_t j = from; j < to; ++j) {
      mean_q += given_at(j) / count;
      mean_s += way_at(static_cast<double>(j)) / count;
    }
    for (std::size_t j = from; j < to; ++j) {
      const double off = way_at(static_cast<double>(j)) - mean_s;
      squares += off * off;
      slope += off * (given_at(j) - mean_q);
    }
    if (squares > 0) slope /= squares;
  }
  Vec2 at(double way_m) const { return mean_q + (way_m - mean_s) * slope; }
};

/// What the samples around a rupture tell.
struct RuptureLine {
  double ratio = 0;                 ///< |q| where stick gives way
  std::optional<double> late = {};  ///< samples by which the middle of the drop is later than half a sample
                                    ///< before the first that is seen to drop
};

/// How late a drop's middle is: where stick goes on at once behind it, by what the samples around are above
/// the line before it, lowered by the drop from there on. The last sample before may have dropped a little,
/// and is none of the line's.
template <typename Given, typename Way>
std::optional<double> drop_lateness(const MeasuredTrial& trial, std::size_t from, std::size_t i,
                                    const Given& given_at, const Way& way_at) {
  if (i + drop_samples > trial.force_ratio.size() || i < from + fewest)
    return std::nullopt;  // one is left out
  for (std::size_t j = i + 1; j < i + drop_samples; ++j)
    if (trial.starts_anew[j]) return std::nullopt;
  const GivenLine line(from, i - 1, given_at, way_at);
  const Vec2 along = line.at(way_at(static_cast<double>(i) - 0.5)).normalized();
  const auto above = [&](std::size_t j) {
    return (given_at(j) - line.at(way_at(static_cast<double>(j)))).dot(along);
  };
  const double drop = -(above(i + drop_samples - 2) + above(i + drop_samples - 1)) / 2;
  if (!(drop > 0)) return std::nullopt;
  double late = above(i - 1) / drop;
  for (std::size_t j = i; j + 2 < i + drop_samples; ++j) late += above(j) / drop + 1;
  return late;
}

/// |q| where stick gives way. The spring's own way at the last samples is a line over the finger's, which is
/// taken on to half a sample after the last: of a bent spring the ratio itself is none. The finger's way is
/// the parabola through the positions around, so that their noise does not flatten the line; what the noise
/// of q adds to its length on the average is taken off.
///
/// A sensor whose low pass takes some samples for the drop shows the line as late as the drop's middle (its
/// mean delay, whatever the filter): so the line goes on to there, `lag` samples later, and is told without
/// the last sample before, which may have dropped a little.
/// @param goes_on  stick goes on at once behind it, which tells the drop's lateness
std::optional<RuptureLine> rupture_line(const MeasuredTrial& trial, const StickSegments& segments,
                                        const std::vector<Vec2>& ratio, const std::array<SpringBend, 2>& bend,
                                        std::size_t i, double lag, bool goes_on) {
  constexpr std::size_t most = 8;
  std::size_t from = i - 1;
  const auto half = static_cast<std::size_t>(segments.half_window);
  while (from > 0 && i - from < most + half && !segments.begins_run[from] &&
         segments.phase[from - 1] == PadPhase::stick)
    --from;
  // Slip before it may reach so far; and so far what a slow sensor shows of the drop that began the tooth.
  const std::size_t own = from + (segments.begins_run[from] ? segments.drop_tail : half),
                    clean = from + (segments.begins_run[from] ? usual_tail : half);
  const std::size_t first = i > most ? i - most : 0;
  from = std::max(own, first);
  if (i < from + fewest || !(segments.velocity_m_per_s[i].norm() > 0)) return std::nullopt;
  const auto way = position_parabola(trial, i, 2 * static_cast<std::size_t>(segments.half_window),
                                     segments.velocity_m_per_s[i].normalized());
  if (!way) return std::nullopt;
  const auto way_at = [&](double j) { return way->at(j - static_cast<double>(i)); };
  const GivingWay spring(bend, segments.velocity_m_per_s[i].normalized());
  const auto given_at = [&](std::size_t j) -> Vec2 { return spring.at(ratio[j].norm()) * ratio[j]; };
  const GivenLine line(from, lag > 0 ? i - 1 : i, given_at, way_at);
  if (!(line.squares > 0)) return std::nullopt;
  const double at_m = way_at(static_cast<double>(i) - 0.5 + lag), ahead = at_m - line.mean_s;
  const Vec2 at_rupture = line.at(at_m);
  if (!(line.slope.dot(at_rupture) > 0)) return std::nullopt;  // not pulled until then
  const double variance = segments.ratio_noise * segments.ratio_noise *
                          (1 / line.count + ahead * ahead / line.squares),
               pull = spring.ratio_of(at_rupture.norm());
  RuptureLine found{pull - variance / (2 * pull)};
  if (goes_on) found.late = drop_lateness(trial, std::max(clean, first), i, given_at, way_at);
  return found;
}

}  // namespace

void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence) {
  const std::array<SpringBend, 2>& bend = about.bend;
  const double mu_static = about.mu_static_of(evidence);
  for (std::size_t i = 2; i < ratio.size(); ++i) {
    const Vec2& velocity = segments.velocity_m_per_s[i];
    if (!segments.is_rupture[i] || !(velocity.norm() > 0)) continue;
    const Vec2 forward = velocity.normalized();
    const double before = ratio[i - 1].norm(), after = ratio[i].norm(),
                 step_m = velocity.norm() / trial.rate_hz;
    const double longer = about.axes_at(trial.normal_force_n[i - 1]),
                 rise = spring_stiffness_per_m(evidence, bend, forward, before) / longer * step_m;
    // Of the pad's tooth, once it is known: of its own, those would be kept that noise makes long.
    const bool knows_tooth = mu_static > 0 && evidence.slip_samples > 0;
    const double top = knows_tooth ? mu_static : before,
                 foot =
                     knows_tooth ? evidence.slip_ratio / static_cast<double>(evidence.slip_samples) : after;
    const double tooth_m =
        longer * (spring_way_m(evidence, bend, forward, top) - spring_way_m(evidence, bend, forward, foot));
    const std::size_t left_out = segments.drop_tail > 0 ? segments.drop_tail + 1 : 0;
    if (rise > 0 && !has_long_teeth(tooth_m, step_m, left_out)) {
      ++evidence.short_teeth;
      evidence.short_drop += before - after;
      continue;
    }
    // Above v_min slip follows, which has another line.
    constexpr double surely_below = 0.8;
    const bool goes_on = knows_tooth && velocity.norm() < surely_below * about.v_min_m_per_s;
    const auto at_rupture = rupture_line(trial, segments, ratio, bend, i, about.rupture_lag, goes_on);
    if (!at_rupture) continue;
    evidence.drop_lag += at_rupture->late.value_or(0);
    evidence.drop_lags += at_rupture->late ? 1 : 0;
    evidence.rupture_rise += rise;
    evidence.rupture_ratio += at_rupture->ratio;
    evidence.rupture_log_load += std::log(trial.normal_force_n[i - 1]);
    ++evidence.ruptures;
  }
}

double seen_rupture_lag(const std::vector<TrialEvidence>& trials) {
  double sum = 0;
  long drops = 0;
  for (const TrialEvidence& trial : trials) sum += trial.drop_lag, drops += trial.drop_lags;
  return drops >= fewest_drops ? std::clamp(sum / static_cast<double>(drops), 0.0, 2.0) : 0;
}

double rupture_lag(const std::vector<TrialEvidence>& trials) {
  constexpr double least = 0.04;  // samples
  const double late = seen_rupture_lag(trials);
  return late > least ? late : 0;
}

std::size_t drop_tail_samples(const std::vector<TrialEvidence>& trials) {
  constexpr double within_one = 0.1;  // a drop so late is over within a sample
  constexpr double slow_hz = 600;
  constexpr long many = 200;  // ruptures: those of a few trials are needed whole
  if (const double lag = rupture_lag(trials); lag > 0)
    return 1 + (lag > within_one ? static_cast<std::size_t>(std::ceil(2 * lag)) : 0);
  long drops = 0, ruptures = 0;
  double least_hz = slow_hz;
  for (const TrialEvidence& trial : trials) {
    drops += trial.drop_lags;
    ruptures += trial.ruptures + trial.short_teeth;
    least_hz = std::min(least_hz, trial.rate_hz);
  }
  return drops < fewest_drops && ruptures > many && least_hz < slow_hz ? 1 : 0;
}

}  // namespace fingerpad
