#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/random_stream.hpp"
#include "base/spectrum.hpp"
#include "view/playback.hpp"
#include "view/rub.hpp"
#include "view/touch_chart.hpp"
#include "view/touch_series.hpp"

namespace fingerpad::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A rub over the plane z = 0 along a direction, 10 mm to and fro at 1 Hz.
std::vector<TickRecord> plane_rub(const Vec3& along) {
  std::vector<TickRecord> rows;
  for (int i = 0; i <= 1000; ++i) {
    TickRecord row;
    row.t_s = 1e-3 * i;
    row.phase = Phase::slip;
    row.contact_W = Vec3(0.3, 0.4, 0) + along * (0.01 * std::sin(2 * pi * row.t_s));
    row.p_WQ = row.contact_W - Vec3(0, 0, 1e-3 * (1 + std::sin(30 * row.t_s)));
    row.normal_W = Vec3::UnitZ();
    row.friction_W_n = -0.2 * along;
    rows.push_back(row);
  }
  return rows;
}

TEST(TouchSeries, RunsAlongTheDirectionOfTheRub) {
  const Vec3 along = Vec3(-0.6, 0.8, 0);
  const auto rows = plane_rub(along);
  const Vec3 direction = main_direction(rows);
  EXPECT_NEAR((direction - along).norm(), 0, 1e-9);
  const TouchSeries series = touch_series(rows, direction);
  EXPECT_EQ(series.direction_name, "u");
  EXPECT_NEAR(series.position_m[250], 0.01, 1e-9);
  EXPECT_NEAR(series.friction_n[10], -0.2, 1e-12);
  EXPECT_TRUE(std::isnan(series.speed_m_per_s[0]));
  // The finger bobs up and down too; only what is tangential counts. Mid-tick slope of a 1 Hz sine: to 1e-5.
  EXPECT_NEAR(series.speed_m_per_s[1], 0.01 * 2 * pi, 1e-5);
}

TEST(FrictionAlongSliding, BeginsWithItsValueWhereTheRowsBeginWithinARub) {
  const auto rows = plane_rub(Vec3::UnitX());
  EXPECT_NEAR(friction_along_sliding(std::span(rows).subspan(30, 100))[0], -0.2, 1e-12) << "sliding";
  std::vector<TickRecord> rest(5, rows[30]);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i].t_s = rows[30].t_s - 0.01 * double(rest.size() - i);
  rest.insert(rest.end(), rows.begin() + 30, rows.begin() + 40);
  EXPECT_NEAR(friction_along_sliding(rest)[0], -0.2, 1e-12) << "a rest before the first slide";
}

TEST(ShownSpeed, IsTheFingersOwnInTheAirAndTangentialInContact) {
  TickRecord before, row;
  row.t_s = 0.01;
  row.p_WQ = Vec3(0, 3e-4, 4e-4);
  EXPECT_NEAR(shown_speed(before, row), 0.05, 1e-12);
  const auto rows = plane_rub(Vec3::UnitX());
  EXPECT_EQ(shown_speed(rows[0], rows[1]), tangential_speed(rows[0], rows[1]));
  EXPECT_TRUE(std::isnan(shown_speed(row, row))) << "no time has passed";
}

// From tick to tick an encoder of 30 um makes 0 or 30 mm/s of 20 mm/s.
TEST(NetSpeed, LevelsOutTheStepsOfAnEncoder) {
  constexpr double speed_m_per_s = 0.02, encoder_m = 3e-5;
  std::vector<TickRecord> rows;
  for (int i = 0; i < 300; ++i) {
    TickRecord row;
    row.t_s = 1e-3 * i;
    row.phase = i < 50 ? Phase::free : Phase::slip;
    row.contact_W = Vec3(encoder_m * std::round(speed_m_per_s * row.t_s / encoder_m), 0, 0);
    row.p_WQ = row.contact_W;
    row.normal_W = Vec3::UnitZ();
    rows.push_back(row);
  }
  const std::vector<double> speeds = net_speed(rows, 0.02);
  ASSERT_EQ(speeds.size(), rows.size());
  for (std::size_t i = 0; i < 51; ++i) EXPECT_TRUE(std::isnan(speeds[i])) << i;
  // A step more or less in 20 ms.
  for (std::size_t i = 75; i < speeds.size(); ++i)
    EXPECT_NEAR(speeds[i], speed_m_per_s, encoder_m / 0.02) << i;
  ViewInput input = torus_rub(0);
  input.scene->hand.emplace().encoder_m = encoder_m;
  const Chart chart = touch_chart(rows, Vec3::UnitX(), touch_levels(input));
  EXPECT_EQ(chart.panels[1].curves[0].name, "speed over 20 ms");
  EXPECT_NEAR(chart.panels[1].curves[0].y.back(), 20, 1.5);
  const Chart live = live_chart(rows, TouchLevels{});
  EXPECT_NEAR(live.panels[1].curves[0].y.back(), 20, 1.5) << "whether an encoder is known or not";
}

TEST(TouchSeries, NamesAWorldAxisAndKeepsItsCoordinate) {
  const auto rows = plane_rub(Vec3::UnitY());
  const TouchSeries series = touch_series(rows, main_direction(rows));
  EXPECT_EQ(series.direction_name, "y");
  EXPECT_NEAR(series.position_m[0], 0.4, 1e-12);
}

TEST(TouchSeries, SlipEndsWhereOneWallHoldsTheFingerAndSticks) {
  std::vector<TickRecord> rows(6);
  const Phase phases[] = {Phase::slip, Phase::stick, Phase::stick, Phase::slip, Phase::stick, Phase::free};
  const int walls[] = {1, 1, 1, 2, 2, 0};  // then the greater of two walls is another one, which sticks
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].t_s = 0.001 * static_cast<double>(i);
    rows[i].phase = phases[i];
    rows[i].walls = walls[i];
  }
  const std::vector<bool> expected{false, true, false, false, false, false};
  EXPECT_EQ(touch_series(rows, Vec3::UnitX()).slip_ends, expected);
}

TEST(TouchSeries, HasNoEndOfSlipWhereASlippingFingerIsLiftedOff) {
  std::vector<TickRecord> rows(9);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].t_s = 1e-3 * static_cast<double>(i);
    rows[i].phase = i < 4 ? Phase::slip : i < 7 ? Phase::stick : Phase::free;
    rows[i].normal_W = Vec3::UnitZ();
    rows[i].walls = 1;
    rows[i].p_WQ = Vec3(1e-4 * std::min<double>(static_cast<double>(i), 3), 0, i < 4 ? 0 : 2e-4 * (i - 3.0));
  }
  const auto ends = [&] {
    const auto marks = touch_series(rows, Vec3::UnitX()).slip_ends;
    return std::count(marks.begin(), marks.end(), true);
  };
  EXPECT_EQ(ends(), 0);
  rows[7].phase = rows[8].phase = Phase::stick;
  EXPECT_EQ(ends(), 1) << "it came to rest, and stays";
  rows[8].phase = Phase::free;
  rows[6].p_WQ.x() += 1e-5;
  EXPECT_EQ(ends(), 1) << "it was dragged on in stick before it was lifted";
}

/// Every 10th row and the last, as `replay --every 10` writes them.
ViewInput thinned_rub() {
  ViewInput input = torus_rub(3.004);
  const std::vector<TickRecord> all = std::exchange(input.rows, {});
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k % 10 == 0 || k + 1 == all.size()) input.rows.push_back(all[k]);
  }
  input.every = 10;
  return input;
}

TEST(TouchChart, OfAThinnedTraceMarksNoEndOfSlip) {
  ViewInput input = thinned_rub();
  const auto rings = [&] {
    int count = 0;
    for (const ChartPanel& panel : touch_chart(input.rows, Vec3::UnitX(), touch_levels(input)).panels) {
      for (const ChartCurve& curve : panel.curves) count += curve.name == "end of slip";
    }
    return count;
  };
  EXPECT_EQ(rings(), 0);
  input.every = 1;
  EXPECT_EQ(rings(), 2) << "of speed and mu, where each row is a tick";
}

TEST(TouchChart, SaysWhereThereAreTooManyEndsOfSlipToMark) {
  std::vector<TickRecord> rows(200);
  const auto curves_of = [&](std::size_t ends) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].t_s = 1e-3 * static_cast<double>(i);
      rows[i].phase = i % 2 == 1 && i < 2 * ends ? Phase::stick : Phase::slip;
      rows[i].walls = 1;
      rows[i].p_WQ.x() = 1e-4 * static_cast<double>(i);
      rows[i].normal_W = Vec3::UnitZ();
      rows[i].mu = 0.2;
    }
    std::map<std::string, long> marked;
    for (const ChartPanel& panel : live_chart(rows, {}).panels) {
      for (const ChartCurve& curve : panel.curves) {
        if (curve.style.marker != Marker::ring) continue;
        marked[curve.name] +=
            std::count_if(curve.y.begin(), curve.y.end(), [](double y) { return std::isfinite(y); });
      }
    }
    return marked;
  };
  using Marked = std::map<std::string, long>;
  EXPECT_EQ(curves_of(0), Marked{});
  EXPECT_EQ(curves_of(60), (Marked{{"end of slip", 2 * 60}})) << "in the panels of speed and mu";
  EXPECT_EQ(curves_of(61), (Marked{{"ends of slip: over 60, not marked", 0}}));
}

/// The panel of the coefficient of friction, by what it draws of a level: values at the rows; empty: a level.
std::vector<double> steps_of(const Chart& chart, const std::string& name) {
  const ChartPanel& mu = chart.panels.back();
  for (const ChartCurve& curve : mu.curves) {
    if (curve.name == name) return curve.y;
  }
  return {};
}

TEST(TouchLevels, OfACoefficientThatIsChangedMeanwhileStepThere) {
  ViewInput input = torus_rub(0.1);
  input.scene->parts.emplace_back();
  input.changes.push_back({0.15, "part.0.mu_static", "0.5"});
  const double before = input.world->surfaces[0].properties.mu_static;
  const TouchLevels levels = touch_levels(input);
  for (const Chart& chart :
       {touch_chart(input.rows, Vec3::UnitX(), levels), live_chart(input.rows, levels)}) {
    const std::vector<double> mu_s = steps_of(chart, "mu_s");
    ASSERT_EQ(mu_s.size(), input.rows.size());
    for (std::size_t i = 0; i < mu_s.size(); ++i) EXPECT_EQ(mu_s[i], input.rows[i].t_s < 0.15 ? before : 0.5);
    ASSERT_EQ(chart.panels.back().levels.size(), 1u) << "what was not changed stays a level";
    EXPECT_EQ(chart.panels.back().levels[0].name, "mu_d");
  }
  // Long after it the window's charts begin when it holds already.
  const std::span<const TickRecord> late = std::span(input.rows).subspan(160);
  EXPECT_EQ(live_chart(late, levels).panels.back().levels[0].y, 0.5);
}

TEST(TouchLevels, AreThoseOfTheSurfaceThatIsTouched) {
  ViewInput input = torus_rub(0.1);
  World two = *input.world;
  two.surfaces.push_back(two.surfaces[0]);
  two.surfaces[1].properties.mu_static = 0.9;
  input.world = std::make_shared<const World>(two);
  for (std::size_t i = 150; i < input.rows.size(); ++i) input.rows[i].surface = 1;
  const std::vector<double> mu_s = steps_of(live_chart(input.rows, touch_levels(input)), "mu_s");
  ASSERT_EQ(mu_s.size(), input.rows.size());
  EXPECT_EQ(mu_s[0], two.surfaces[0].properties.mu_static) << "in the air: of the first that is touched";
  EXPECT_EQ(mu_s[149], two.surfaces[0].properties.mu_static);
  EXPECT_EQ(mu_s[150], 0.9);
}

TEST(TouchLevels, OfAChangeThatTheSceneCannotHaveAreNotKnown) {
  ViewInput input = torus_rub(0.1);
  ASSERT_FALSE(touch_levels(input).mu.empty());
  input.changes.push_back({0.05, "part.7.mu_static", "0.5"});
  EXPECT_TRUE(touch_levels(input).mu.empty());
}

TEST(Spectrum, OfAThinnedTraceGoesByTheDistanceOfItsRowsNotByItsLast) {
  const ViewInput input = thinned_rub();
  ASSERT_LT(input.rows.back().t_s - input.rows[input.rows.size() - 2].t_s, 0.0045);
  const Chart chart = spectrum_chart(touch_series(input.rows, Vec3::UnitX()));
  ASSERT_FALSE(chart.panels.empty());
  EXPECT_NEAR(chart.panels[0].curves[0].x.back(), 50, 1e-9) << "half of 100 rows a second";
}

TEST(TouchSeries, OfNothingIsEmpty) {
  EXPECT_EQ(main_direction({}), Vec3::UnitX());
  EXPECT_TRUE(touch_series({}, Vec3::UnitX()).t_s.empty());
}

TEST(Spectrum, OfNoiseSumsToItsVariance) {
  RandomStream noise(7);
  std::vector<double> samples(20'000);
  double variance = 0;
  for (double& sample : samples) {
    sample = noise.normal();
    variance += sample * sample / static_cast<double>(samples.size());
  }
  const Spectrum spectrum = welch_spectrum(samples, 2000);
  double sum = 0;
  for (const double density : spectrum.density) sum += density * spectrum.frequency_hz[1];
  // Some 8 windows of 4096: the estimate of a sum over 2000 bins scatters by about 2 %.
  EXPECT_NEAR(sum, variance, 0.06 * variance);
  EXPECT_EQ(spectrum.frequency_hz.back(), 1000);
}

TEST(Spectrum, PeaksAtASinesFrequency) {
  std::vector<double> samples;
  for (int i = 0; i < 4000; ++i) samples.push_back(5 + std::sin(2 * pi * 89 * i / 1000.0));
  const Spectrum spectrum = welch_spectrum(samples, 1000);
  const auto peak = std::max_element(spectrum.density.begin() + 1, spectrum.density.end());
  // Bins are 1000/512 Hz apart.
  EXPECT_NEAR(spectrum.frequency_hz[static_cast<std::size_t>(peak - spectrum.density.begin())], 89, 2);
  EXPECT_LT(spectrum.density[0], 1e-3 * *peak);  // the mean is gone
}

TEST(Spectrum, OfTooLittleIsEmpty) {
  EXPECT_TRUE(welch_spectrum(std::vector<double>(31, 1.0), 1000).density.empty());
}

TEST(Playback, StaysWithinItsRows) {
  const ViewInput input = torus_rub(0.2);
  Playback playback(input);
  playback.go_to(-1);
  EXPECT_EQ(playback.row(), 0);
  playback.step(1'000'000);
  EXPECT_EQ(playback.row(), static_cast<long>(input.rows.size()) - 1);
  playback.toggle();  // from the end: again from the start
  EXPECT_TRUE(playback.playing());
  EXPECT_EQ(playback.row(), 0);
  EXPECT_TRUE(playback.advance(0.01));
  EXPECT_EQ(playback.row(), 10);
  playback.change_speed(true);
  playback.advance(0.01);
  EXPECT_EQ(playback.row(), 30);
  EXPECT_TRUE(playback.advance(100));
  EXPECT_FALSE(playback.playing());
  EXPECT_FALSE(playback.advance(1));
}

}  // namespace
}  // namespace fingerpad::test
