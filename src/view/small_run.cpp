#include "view/small_run.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

Vec3 shown_place(const TickRecord& row) {
  return row.phase == Phase::free ? row.p_WQ : row.contact_W;
}

/// Of what a path's points are spread over, this share is time, the rest is the way.
constexpr double share_of_time = 0.25;

/// From 0 to 1, growing.
std::vector<double> progress_of(const std::vector<TickRecord>& rows) {
  std::vector<double> way(rows.size(), 0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    way[i] = way[i - 1] + (shown_place(rows[i]) - shown_place(rows[i - 1])).norm();
  }
  const double whole = way.back();
  const auto last = static_cast<double>(rows.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double gone = whole > 0 ? way[i] / whole : 0;
    way[i] = (1 - share_of_time) * gone + share_of_time * static_cast<double>(i) / last;
  }
  return way;
}

/// What one tick gives to each curve.
using CurveValue = double (*)(const std::vector<TickRecord>& rows, std::size_t i);
struct CurveRow {
  std::string_view name, unit;
  CurveValue value;
};

double speed_at(const std::vector<TickRecord>& rows, std::size_t i) {
  if (rows.size() < 2) return 0;
  i = std::max<std::size_t>(i, 1);  // it has come to the first tick as it goes on
  const double dt_s = rows[i].t_s - rows[i - 1].t_s;
  return dt_s > 0 ? (rows[i].p_WQ - rows[i - 1].p_WQ).norm() / dt_s : TickRecord::nan;
}

constexpr CurveRow curve_rows[] = {
    {"normal force", "N", [](const auto& rows, std::size_t i) { return rows[i].normal_force_n; }},
    {"friction", "N", [](const auto& rows, std::size_t i) { return rows[i].friction_W_n.norm(); }},
    {"mu", "1", [](const auto& rows, std::size_t i) { return rows[i].mu; }},
    {"depth", "m", [](const auto& rows, std::size_t i) { return rows[i].depth_m; }},
    {"speed", "m/s", speed_at},
};

/// A stretch of time and its rows.
struct Bucket {
  std::size_t begin = 0, end = 0;
  double begin_s = 0, length_s = 0;

  std::uint8_t place(double t_s) const {
    const double share = length_s > 0 ? (t_s - begin_s) / length_s : 0;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  }
};

/// The least and the greatest value of a bucket in the order in which they come, each at its own time.
void add_extremes(const std::vector<TickRecord>& rows, const Bucket& bucket, const CurveRow& row,
                  StripCurve& curve) {
  std::size_t low = bucket.begin, high = bucket.begin;
  for (std::size_t i = bucket.begin; i < bucket.end; ++i) {
    const double value = row.value(rows, i);
    if (!(value >= row.value(rows, low))) low = i;
    if (!(value <= row.value(rows, high))) high = i;
  }
  if (low == high) high = bucket.end - 1;  // level
  for (const std::size_t i : {std::min(low, high), std::max(low, high)}) {
    curve.values.push_back(row.value(rows, i));
    curve.places.push_back(bucket.place(rows[i].t_s));
  }
}

/// In 255ths, of ticks begin to end - 1: how many are in this phase; never 0 where one is.
std::uint8_t share_of(Phase phase, const std::vector<TickRecord>& rows, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) count += rows[i].phase == phase ? 1 : 0;
  if (count == 0) return 0;
  const std::size_t ticks = end - begin;
  return static_cast<std::uint8_t>(std::max<std::size_t>(1, (255 * count + ticks / 2) / ticks));
}

void add_shares(const std::vector<TickRecord>& rows, std::size_t begin, std::size_t end,
                SmallSeries& series) {
  series.slip_share.push_back(share_of(Phase::slip, rows, begin, end));
  series.stick_share.push_back(share_of(Phase::stick, rows, begin, end));
  int ruptures = 0;
  for (std::size_t i = begin; i < end; ++i) ruptures += rows[i].ruptures;
  series.ruptures.push_back(static_cast<std::uint8_t>(std::clamp(ruptures, 0, 255)));
}

SmallSeries every_tick(const std::vector<TickRecord>& rows) {
  SmallSeries series;
  for (const CurveRow& row : curve_rows) {
    StripCurve& curve = series.curves.emplace_back(StripCurve{row.name, row.unit, {}});
    for (std::size_t i = 0; i < rows.size(); ++i) curve.values.push_back(row.value(rows, i));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) add_shares(rows, i, i + 1, series);
  return series;
}

}  // namespace

SmallPath small_path(const std::vector<TickRecord>& rows, std::size_t most) {
  SmallPath path;
  if (rows.empty()) return path;
  const std::vector<double> progress = progress_of(rows);
  const auto due = [&](std::size_t kept) {
    return static_cast<double>(kept) / static_cast<double>(most - 1);
  };
  double force_n = 0;
  Phase phase = rows.front().phase;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double here_n = rows[i].force_W_n.norm();
    if (here_n >= force_n) {
      force_n = here_n;
      phase = rows[i].phase;
    }
    const bool last = i + 1 == rows.size();
    // One place is kept for the last row.
    if (!last && (progress[i] < due(path.points_W.size()) || path.points_W.size() + 1 >= most)) continue;
    path.points_W.push_back(shown_place(rows[i]));
    path.force_n.push_back(force_n);
    path.phases.push_back(phase);
    force_n = 0;
  }
  return path;
}

SmallSeries small_series(const std::vector<TickRecord>& rows, std::size_t most) {
  SmallSeries series;
  if (rows.empty()) return series;
  const double whole_s = rows.back().t_s - rows.front().t_s;
  const std::size_t buckets = most / 2;
  if (rows.size() <= most) {
    series = every_tick(rows);
  } else {
    for (const CurveRow& row : curve_rows) series.curves.push_back({row.name, row.unit, {}});
    series.bucket_s = whole_s / static_cast<double>(buckets);
    for (std::size_t k = 0; k < buckets; ++k) {
      const Bucket bucket{rows.size() * k / buckets, rows.size() * (k + 1) / buckets,
                          rows.front().t_s + static_cast<double>(k) * series.bucket_s, series.bucket_s};
      for (std::size_t c = 0; c < series.curves.size(); ++c)
        add_extremes(rows, bucket, curve_rows[c], series.curves[c]);
      add_shares(rows, bucket.begin, bucket.end, series);
    }
  }
  series.begin_s = rows.front().t_s;
  series.step_s = series.bucket_s > 0 ? series.bucket_s
                  : rows.size() > 1   ? whole_s / static_cast<double>(rows.size() - 1)
                                      : 0;
  return series;
}

}  // namespace fingerpad
