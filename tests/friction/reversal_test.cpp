#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/plane_contact.hpp"

namespace fingerpad::reversal_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::unit_at;

constexpr double mu_s = 0.3, mu_d = 0.2, k_f = 1000;
constexpr double pad_rad = std::numbers::pi / 4;  ///< at which the finger pad's lateral spring is k_f

/// To and fro along a line, at one speed, with corners every 50 ms: a corner's velocity passes v_min.
struct Triangle {
  double speed_m_per_s, first_corner_s;

  static constexpr double leg_s = 0.05;
  double legs(double t) const { return (t - first_corner_s) / leg_s; }
  bool goes_back(double t) const { return std::fmod(std::abs(std::floor(legs(t))), 2) == 1; }
  double since_corner_m(double t) const { return (legs(t) - std::floor(legs(t))) * leg_s * speed_m_per_s; }
  double at_m(double t) const {
    return goes_back(t) ? speed_m_per_s * leg_s - since_corner_m(t) : since_corner_m(t);
  }
  /// Along the leg, with time continuous: it sticks in the corner at the force of slip, and ruptures
  /// (mu_s + mu_d)/k_f later.
  double resistance_n(double t) const {
    const double stretched = -mu_d + k_f * since_corner_m(t);
    return stretched < mu_s ? stretched : mu_d;
  }
};

/// RMS error of the force, as a share of mu_s n, over all legs from the second corner on.
double error_share(const FrictionLaw& law, const Triangle& wave, double rate_hz, double angle_rad = 0) {
  PlaneContact contact{law, pressed(1, rate_hz)};
  contact.motion.inclination_rad = pad_rad;
  const Vec2 along = unit_at(angle_rad);
  double sum = 0;
  int count = 0;
  for (int k = 0; k <= rate_hz / 2; ++k) {
    const double t = k / rate_hz;
    const Friction f = contact.move_to(wave.at_m(t) * along);
    if (t < wave.first_corner_s + Triangle::leg_s) continue;
    const Vec2 truth = (wave.goes_back(t) ? 1 : -1) * wave.resistance_n(t) * along;
    sum += (f.force_n - truth).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count) / mu_s;
}

/// Laws that slip at mu_d n and spring at k_f n under 1 N.
const char* const coulomb_slip_laws[] = {"stick-slip", "finger-pad", "contact-area"};

TEST(Reversal, SticksInTheCornerWhereverItLiesInATickAndConvergesWithTheRate) {
  for (const char* name : coulomb_slip_laws) {
    const auto law = make_law(name);
    for (const double speed : {0.15, 0.3}) {
      for (const double share : {0.0, 0.1, 0.25, 0.5, 0.75, 0.9}) {
        const auto error = [&](double rate_hz) {
          return error_share(*law, {speed, 0.02 + share / rate_hz}, rate_hz);
        };
        // Missed corners leave 0.12 to 0.18 at every rate. A rupture told a tick off costs one tick of a leg
        // the share (mu_s - mu_d)/mu_s: 0.047, 0.024 and 0.012; the stick begins a part of a tick off too.
        EXPECT_LT(error(1000), 0.12) << name << " " << speed << " " << share;
        EXPECT_LT(error(4000), 0.03) << name << " " << speed << " " << share;
        EXPECT_LT(error(16000), 0.014) << name << " " << speed << " " << share;
      }
    }
  }
}

TEST(Reversal, IsTheSameInEveryDirection) {
  const auto law = make_law("stick-slip");
  const Triangle wave{0.3, 0.0204};
  const double along_x = error_share(*law, wave, 2000);
  for (int i = 1; i < 12; ++i) EXPECT_NEAR(error_share(*law, wave, 2000, 0.5 * i), along_x, 1e-9);
}

TEST(Reversal, FastToFastWithinATickRupturesOnceHalfAMillimetreOn) {
  for (const char* name : coulomb_slip_laws) {
    const auto law = make_law(name);
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.motion.inclination_rad = pad_rad;
    contact.slide_to({0, 0}, {0.15, 0});
    int ruptures = 0;
    for (int k = 1; k <= 20; ++k) {
      const Friction f = contact.move_to({-0.00015 * k, 0}, {-0.15, 0});
      // Slip is 0.2 mm of stretch; v_min is a third of a tick (50 um) before the corner: 0.5 mm from there.
      EXPECT_EQ(f.phase, k <= 3 ? Phase::stick : Phase::slip) << name << " " << k;
      ruptures += f.ruptures;
    }
    EXPECT_EQ(ruptures, 1) << name;
  }
}

TEST(Reversal, ASharpBendAtSpeedThatCutsPastVMinSticks) {
  const auto law = make_law("stick-slip");
  // At 0.11 m/s a bend by 80 degrees passes at 0.084 m/s in its middle, by 40 at 0.103.
  for (const auto& [bend_rad, phase] : {std::pair{1.4, Phase::stick}, std::pair{0.7, Phase::slip}}) {
    PlaneContact contact{*law, pressed(1, 4000)};
    contact.slide_to({0, 0}, {0.11, 0});
    const Vec2 velocity = 0.11 * unit_at(bend_rad);
    EXPECT_EQ(contact.move_to(velocity / 4000, velocity).phase, phase) << bend_rad;
  }
}

TEST(Reversal, AnOddVMinOfZeroSticksAtTheStopOnly) {
  const auto law = make_law("stick-slip", test::settings_of({{"v_min_m_per_s", 0}}));
  for (int i = 0; i < 12; ++i) {
    const Vec2 along = unit_at(0.5 * i);
    PlaneContact contact{*law, pressed(1, 1000)};
    EXPECT_EQ(contact.slide_to({0, 0}, 0.1 * along).phase, Phase::slip);
    EXPECT_EQ(contact.move_to(-1e-4 * along, -0.1 * along).phase, Phase::stick) << i;
    contact.slide_to({0, 0}, 0.1 * along);
    EXPECT_EQ(contact.move_to(1e-5 * along, 0.01 * along).phase, Phase::slip) << i;
  }
}

TEST(Reversal, SalcudeanVlaarSticksInTheCornerToo) {
  const auto law = make_law("salcudean-vlaar");
  for (const double share : {0.0, 0.25, 0.5, 0.75}) {
    const double rate_hz = 8000;
    const Triangle wave{0.3, 0.02 + share / rate_hz};
    PlaneContact contact{*law, pressed(1, rate_hz)};
    for (int k = 0; k <= rate_hz / 2; ++k) {
      const double t = k / rate_hz, gone_m = wave.since_corner_m(t);
      const Friction f = contact.move_to({wave.at_m(t), 0});
      // Two ticks either side of corner and rupture are left out: 75 um.
      if (t < wave.first_corner_s + Triangle::leg_s || gone_m < 1e-4 || std::abs(gone_m - 5e-4) < 1e-4)
        continue;
      const double expected = gone_m < 5e-4 ? -mu_d + 1000 * gone_m : mu_d * 0.3 / 0.1;
      // The stick begins up to a tick off: 1000 N/m of 37.5 um.
      ASSERT_NEAR((wave.goes_back(t) ? 1 : -1) * f.force_n.x(), expected, 0.04) << share << " " << t;
    }
  }
}

}  // namespace
}  // namespace fingerpad::reversal_test
