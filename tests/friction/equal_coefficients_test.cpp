#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/plane_contact.hpp"

namespace fingerpad::equal_coefficients_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::settings_of;

struct Law {
  const char* name;
  std::map<std::string, double, std::less<>> numbers;
};
const Law stick_rule_laws[] = {
    {"stick-slip", {}}, {"finger-pad", {}}, {"finger-pad", {{"cubic_share", 0.5}}}, {"contact-area", {}}};

/// What a drag along x answers after its first 0.5 s.
struct Drag {
  int ruptures = 0;
  double least_n = 1e9, most_n = -1e9;
};

Drag dragged(PlaneContact& contact, double speed_m_per_s, double rate_hz, Phase phase) {
  Drag drag;
  for (int k = 0; k <= rate_hz; ++k) {
    const Friction f = contact.move_to({speed_m_per_s * k / rate_hz, 0});
    drag.ruptures += f.ruptures;
    if (k < rate_hz / 2) continue;
    EXPECT_EQ(f.phase, phase);
    drag.least_n = std::min(drag.least_n, -f.force_n.x());
    drag.most_n = std::max(drag.most_n, -f.force_n.x());
    EXPECT_NEAR(f.force_n.y(), 0, 1e-9);
  }
  return drag;
}

TEST(EqualCoefficients, BelowVMinTheSpringIsDraggedAlongAtTheLimitWithoutARupture) {
  for (const double mu : {0.0, 0.3}) {
    for (const double rate_hz : {250.0, 1000.0, 4000.0}) {
      for (const Law& law : stick_rule_laws) {
        const auto made = make_law(law.name, settings_of(law.numbers));
        PlaneContact contact{*made, pressed(1, rate_hz)};
        contact.motion.mu_static = contact.motion.mu_dynamic = mu;
        const Drag drag = dragged(contact, 0.05, rate_hz, Phase::stick);
        EXPECT_EQ(drag.ruptures, 0) << law.name << " " << mu << " " << rate_hz;
        EXPECT_NEAR(drag.least_n, mu, 1e-9) << law.name;  // a few roundings of the spring
        EXPECT_NEAR(drag.most_n, mu, 1e-9) << law.name;
      }
    }
  }
}

TEST(EqualCoefficients, SalisburyAndViscousSlipOfTheLimitAreDraggedAlongToo) {
  for (const double mu : {0.0, 0.3}) {
    const auto salisbury = make_law("salisbury");
    PlaneContact contact{*salisbury, pressed(1, 250)};
    contact.motion.mu_static = contact.motion.mu_dynamic = mu;
    const Drag drag = dragged(contact, 0.2, 250, Phase::slip);
    EXPECT_EQ(drag.ruptures, 0) << mu;
    EXPECT_NEAR(drag.most_n, mu, 1e-9);
  }
  const auto viscous = make_law("salcudean-vlaar");
  PlaneContact contact{*viscous, pressed(1, 250)};
  contact.motion.mu_static = contact.motion.mu_dynamic = 0;
  const Drag drag = dragged(contact, 0.05, 250, Phase::stick);
  EXPECT_EQ(drag.ruptures, 0);
  EXPECT_NEAR(drag.most_n, 0, 1e-9);
}

TEST(EqualCoefficients, RisingThroughVMinRupturesOnceAndTheForceStays) {
  for (const Law& law : stick_rule_laws) {
    const auto made = make_law(law.name, settings_of(law.numbers));
    for (const double rate_hz : {250.0, 1000.0}) {
      PlaneContact contact{*made, pressed(1, rate_hz)};
      contact.motion.mu_dynamic = contact.motion.mu_static;
      int ruptures = 0;
      Friction f;
      for (int k = 0; k <= rate_hz; ++k) {
        const double t = k / rate_hz;
        f = contact.move_to({0.1 * t * t, 0});  // 0.1 m/s at 0.5 s
        ruptures += f.ruptures;
        if (t > 0.1) {
          EXPECT_NEAR(f.force_n.x(), -0.3, 1e-9) << law.name << " " << t;
        }
        if (std::abs(t - 0.5) > 1.5 / rate_hz && t > 0.1) {
          EXPECT_EQ(f.phase, t < 0.5 ? Phase::stick : Phase::slip) << law.name << " " << t;
        }
      }
      EXPECT_EQ(ruptures, 1) << law.name;
    }
  }
}

TEST(EqualCoefficients, ASlowTurnTurnsTheForceAsADraggedPointDoes) {
  const auto law = make_law("stick-slip");
  const auto at_end = [&](double rate_hz) {
    PlaneContact contact{*law, pressed(1, rate_hz)};
    contact.motion.mu_dynamic = contact.motion.mu_static;
    Friction f;
    for (int k = 0; k <= rate_hz / 10; ++k) f = contact.move_to({0.02 * k / rate_hz, 0});
    for (int k = 1; k <= rate_hz / 50; ++k) f = contact.move_to({0.002, 0.02 * k / rate_hz});
    return f.force_n;
  };
  // A tractrix of radius 0.3 mm over 0.4 mm: tan(angle/2) shrinks from 1 by e^(-4/3).
  const double angle = 2 * std::atan(std::exp(-4.0 / 3));
  for (const double rate_hz : {250.0, 1000.0}) {
    EXPECT_NEAR((at_end(rate_hz) - Vec2(-0.3 * std::sin(angle), -0.3 * std::cos(angle))).norm(), 0, 1e-9);
  }
}

TEST(SalcudeanVlaar, AVMinThatLeavesItsDampingWithoutBoundIsRefused) {
  const LawEntry& law = *find_law("salcudean-vlaar");
  const auto v_min = std::find_if(law.parameters.begin(), law.parameters.end(),
                                  [](const LawParameter& row) { return row.key == "v_min_m_per_s"; });
  ASSERT_NE(v_min, law.parameters.end());
  EXPECT_EQ(refusal(*v_min, 0), "must be at least 0.0001");
  EXPECT_EQ(refusal(*v_min, 1e-4), "");
  // Whoever makes it without asking, or from a profile, gets the least: B = 0.2/1e-4.
  PadProfile profile = assumed_profile(0.3, 1000);
  profile.v_min_m_per_s = 0;
  LawSettings by_profile;
  by_profile.profile = profile;
  for (const LawSettings& settings : {settings_of({{"v_min_m_per_s", 0}}), by_profile}) {
    const auto made = make_law("salcudean-vlaar", settings);
    PlaneContact contact{*made, pressed(1, 1000)};
    EXPECT_NEAR(contact.slide_to({0, 0}, {0.2, 0}).force_n.x(), -400, 1e-9);
  }
}

}  // namespace
}  // namespace fingerpad::equal_coefficients_test
