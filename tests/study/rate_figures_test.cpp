#include "study/rate_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.hpp"
#include "study/battery.hpp"
#include "support/worlds.hpp"
#include "touch/rate_choice.hpp"

// What `rate_hz = "auto"` reckons against what the laws do.

namespace fingerpad::rate_figures_test {
namespace {

FingerPath drag_at(double speed_m_per_s) {
  ScriptedMotion line;
  line.kind = ScriptedMotion::Kind::line;
  line.from_m = Vec3(0, 0, -1e-3);
  line.to_m = Vec3(2 * speed_m_per_s, 0, -1e-3);
  line.speed_m_per_s = speed_m_per_s;
  line.duration_s = 2;
  return {line, 1000, Vec3(0, 0.6, -0.8)};
}

TEST(RateFigures, OfADragAreThoseThatAutoReckons) {
  const auto world = test::plane_world();
  Scene scene = test::plane_scene("stick-slip");
  scene.planes.emplace_back();
  for (const double speed : {0.0117, 0.0317, 0.0717}) {
    const FingerPath path = drag_at(speed);
    const std::vector<StretchRun> model{run_stretch(world, scene, path, model_choice(), {0, 0.2, 2})};
    for (const double rate_hz : {250.0, 1000.0, 4000.0}) {
      const RateFigures measured = rate_figures(model, rate_hz);
      const ShownFriction reckoned = shown_friction(teeth_of(scene), &path, rate_hz);
      // 40 kHz samples the teeth themselves, of 17 ticks at the fastest: a fifteenth of what is small.
      EXPECT_NEAR(measured.held_mu_share, reckoned.held_share, 0.07 * reckoned.held_share)
          << speed << " " << rate_hz;
      EXPECT_NEAR(measured.unseen_teeth_share, reckoned.unseen_share, 0.01) << speed << " " << rate_hz;
    }
  }
}

TEST(RateFigures, OfTurnsAreOfTheSizeThatAutoReckons) {
  Scene scene = test::plane_scene("coulomb");
  scene.planes.emplace_back();
  for (const std::size_t which : {2, 3}) {  // to and fro at 0.15 m/s, and round a circle
    const BatteryCase& c = battery()[which];
    Motion motion;
    motion.p_WQ.resize(3, 16001);
    for (Eigen::Index k = 0; k <= 16000; ++k) {
      motion.t_s.push_back(static_cast<double>(k) / 16000 * c.seconds);
      motion.p_WQ.col(k) = c.position_W(motion.t_s.back());
    }
    const FingerPath path(std::move(motion), 1000, Vec3(0, 0.6, -0.8));
    const BatteryRun fine = run_battery(c, "coulomb", 64000, Events::exact);
    for (const double rate_hz : {250.0, 1000.0}) {
      const BatteryRun coarse = run_battery(c, "coulomb", rate_hz, Events::exact);
      // The battery's shares are of mu_s n, friction is mu_d n.
      const double measured = battery_error(coarse, fine, std::lround(64000 / rate_hz)).rms * 0.3 / 0.2;
      const double reckoned = shown_friction(teeth_of(scene), &path, rate_hz).turn_share;
      EXPECT_GT(reckoned, 0.6 * measured) << c.name << " " << rate_hz;
      EXPECT_LT(reckoned, 1.8 * measured) << c.name << " " << rate_hz;
    }
  }
}

}  // namespace
}  // namespace fingerpad::rate_figures_test
