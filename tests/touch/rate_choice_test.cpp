#include "touch/rate_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"

namespace fingerpad::rate_choice_test {
namespace {

using testing::HasSubstr;

/// A plane touched by a law whose coefficient rises by 1 a millimetre: teeth of 0.1 mm, 0.2 to 0.3.
Scene scene_of(const std::string& law = "stick-slip") {
  Scene scene;
  scene.name = "test";
  scene.planes.emplace_back();
  scene.friction.law = law;
  return scene;
}

FingerPath line_at(double speed_m_per_s) {
  ScriptedMotion line;
  line.kind = ScriptedMotion::Kind::line;
  line.to_m = Vec3(0.1, 0, 0);
  line.speed_m_per_s = speed_m_per_s;
  line.duration_s = 0.1 / speed_m_per_s;
  return {line, 1000, Vec3(0, 0.6, -0.8)};
}

double chosen_hz(const Scene& scene, double speed_m_per_s) {
  const FingerPath path = line_at(speed_m_per_s);
  return choose_rate(scene, &path).rate_hz;
}

/// By brute force: a sawtooth of height h, from any phase, held for any share of a tick.
double held_square_by_force(double height, double rise) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const double phase = (i + 0.5) / steps * height, later = phase + (k + 0.5) / steps * rise;
      const double off = std::fmod(later, height) - phase;
      sum += off * off / (steps * steps);
    }
  }
  return sum;
}

TEST(HeldTeeth, AreOffByWhatASawtoothLosesWhileItIsHeld) {
  for (const double rise : {0.01, 0.05, 0.09})
    EXPECT_NEAR(held_teeth_square(0.1, rise), held_square_by_force(0.1, rise), 1e-7) << rise;
  // Of many teeth a tick the ends' phases have nothing to do with each other.
  EXPECT_NEAR(held_teeth_square(0.1, 2), held_square_by_force(0.1, 2), 1e-5);
}

TEST(RateChoice, ShowsTheTeethOfASlowRub) {
  // 10 % of 0.25, squared, is 6.25e-4 = 0.1 d/2 - d^2/3: d = 0.0138 a tick. At 0.01 m/s 10 a second are 727
  // Hz.
  EXPECT_EQ(chosen_hz(scene_of(), 0.01), 1000);
  EXPECT_EQ(chosen_hz(scene_of(), 0.03), 4000);  // 2180 Hz
  EXPECT_EQ(chosen_hz(scene_of(), 0.09), 10000);
  const FingerPath path = line_at(0.01);
  EXPECT_NEAR(shown_friction(teeth_of(scene_of()), &path, 727).held_share, 0.1, 5e-4);
}

TEST(RateChoice, TakesTheLowestWhereNothingSaws) {
  EXPECT_EQ(chosen_hz(scene_of(), 0.2), 250);  // above v_min it slips
  EXPECT_EQ(chosen_hz(scene_of("none"), 0.01), 250);
  Scene even = scene_of();
  even.planes[0].surface.mu_dynamic = even.planes[0].surface.mu_static;
  EXPECT_EQ(chosen_hz(even, 0.01), 250);
  Scene crossing = scene_of();
  crossing.friction.settings.restick = Restick::crossing;
  EXPECT_EQ(chosen_hz(crossing, 0.01), 250);
}

TEST(RateChoice, GivesAToothTwoTicks) {
  // Teeth of 0.1 mm at 0.03 m/s: 300 a second, 600 Hz at least, however loose the tolerance of what is held.
  Scene loose = scene_of();
  loose.contact.mu_tolerance = 0.99;
  EXPECT_EQ(chosen_hz(loose, 0.03), 1000);
  const FingerPath path = line_at(0.03);
  EXPECT_EQ(shown_friction(teeth_of(loose), &path, 590).unseen_share, 1);
  EXPECT_EQ(shown_friction(teeth_of(loose), &path, 610).unseen_share, 0);
  EXPECT_THAT(choose_rate(loose, &path).reason,
              HasSubstr("at 500 Hz 100 % of the stick-slip teeth last under"));
}

TEST(RateChoice, FollowsSharpTurnsOfAFastFinger) {
  // Round a circle of 10 mm at 3 Hz, 0.19 m/s: the direction turns by 0.075 a tick of 4 ms, by 0.0188 at 1
  // kHz.
  ScriptedMotion circle;
  circle.kind = ScriptedMotion::Kind::circle;
  circle.amplitude_m = 0.01;
  circle.direction = Vec3::UnitX();
  circle.frequency_hz = 3;
  circle.duration_s = 1;
  const FingerPath round(circle, 1000, Vec3(0, 0.6, -0.8));
  for (const double rate_hz : {250.0, 1000.0}) {
    const double turn = 2 * std::numbers::pi * 3 / rate_hz;  // its chord is 2e-4 shorter
    EXPECT_NEAR(shown_friction(teeth_of(scene_of()), &round, rate_hz).turn_share, turn / std::sqrt(3),
                1e-3 * turn);
  }
  Scene strict = scene_of();
  strict.contact.mu_tolerance = 0.02;
  EXPECT_THAT(choose_rate(strict, &round).reason, HasSubstr("the motion turns so sharply that at 500 Hz"));
  EXPECT_EQ(choose_rate(strict, &round).rate_hz, 1000);
  strict.friction.law = "none";
  EXPECT_EQ(choose_rate(strict, &round).rate_hz, 250);
  // Slower than v_min the pad sticks, and its spring takes the turns; a law without v_min does not.
  circle.frequency_hz = 1;
  const FingerPath slow(circle, 1000, Vec3(0, 0.6, -0.8));
  EXPECT_EQ(shown_friction(teeth_of(scene_of()), &slow, 250).turn_share, 0);
  EXPECT_GT(shown_friction(teeth_of(scene_of("coulomb")), &slow, 250).turn_share, 0.01);
}

TEST(RateChoice, FollowsTheTolerance) {
  Scene loose = scene_of();
  loose.contact.mu_tolerance = 0.2;
  EXPECT_EQ(chosen_hz(loose, 0.03), 1000);
}

TEST(RateChoice, TakesAPadsShortAxis) {
  Scene pad = scene_of("finger-pad");
  EXPECT_NEAR(teeth_of(pad).rise_per_m, 1250, 1e-9);  // k_f over 0.8
  pad.friction.settings.profile = assumed_profile(0.3, 500);
  EXPECT_NEAR(teeth_of(pad).rise_per_m, 625, 1e-9);
}

TEST(RateChoice, HoldsTheHandsLoopStable) {
  // Half of what 0.072 kg and 0.5 N s/m hold: 1001 N/m at 1 kHz, 10001 at 10 kHz.
  Scene scene = scene_of("none");
  scene.hand.emplace();
  scene.hand->mass_kg = 0.072;
  scene.planes[0].surface.stiffness_n_per_m = 500;
  EXPECT_EQ(chosen_hz(scene, 0.01), 1000);
  scene.planes[0].surface.stiffness_n_per_m = 505;
  EXPECT_EQ(chosen_hz(scene, 0.01), 2000);
  scene.hand->delay_ticks = 1;  // a third of it
  EXPECT_EQ(chosen_hz(scene, 0.01), 4000);
  const FingerPath path = line_at(0.01);
  EXPECT_THAT(choose_rate(scene, &path).reason, HasSubstr("at 2000 Hz holds up to 66"));
}

TEST(RateChoice, HoldsTheStickSpringUnderTheGreatestForce) {
  Scene scene = scene_of();
  scene.hand.emplace();
  scene.hand->mass_kg = 0.072;
  scene.planes[0].surface.stiffness_n_per_m = 100;
  scene.contact.greatest_force_n = 1;
  EXPECT_EQ(chosen_hz(scene, 0.2), 2000);  // k_f n = 1000 N/m, twice that is held
  scene.contact.greatest_force_n = 1.5;
  EXPECT_EQ(chosen_hz(scene, 0.2), 4000);
  scene.friction.settings.remedy = Remedy::damping;
  EXPECT_EQ(chosen_hz(scene, 0.2), 250);
}

TEST(RateChoice, SaysWhereNoRateServes) {
  Scene scene = scene_of();
  scene.contact.mu_tolerance = 0.01;
  const FingerPath path = line_at(0.09);
  const RateChoice choice = choose_rate(scene, &path);
  EXPECT_EQ(choice.rate_hz, 10000);
  EXPECT_THAT(
      choice.reason,
      HasSubstr("rate_hz: 10000 Hz, the highest there is, though held from tick to tick at 10000 Hz"));
}

TEST(RateChoice, OfAFingerHeldLiveTakesAllSlowSpeedsForAsLikely) {
  Scene scene = scene_of();
  EXPECT_EQ(settle_live_rate(scene), "");
  EXPECT_EQ(scene.motion.rate_hz, 1000);
  scene.motion.automatic_rate = true;
  EXPECT_THAT(settle_live_rate(scene), HasSubstr("rate_hz: 4000 Hz"));
  EXPECT_EQ(scene.motion.rate_hz, 4000);
  EXPECT_FALSE(scene.motion.automatic_rate);
}

}  // namespace
}  // namespace fingerpad::rate_choice_test
