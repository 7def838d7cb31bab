#include <gtest/gtest.h>

#include <cmath>

#include "support/sliding_mass.hpp"

// A spring that hardens buzzes by its stiffness where it stands: SCIENCE 7, "Cubic spring".

namespace fingerpad::tangent_stiffness_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::SlidingMass;

constexpr double mu_s = 0.3, k_f = 1000, damping_n_s_per_m = 0.5, rate_hz = 1000;

LawSettings cubic_pad(double c, Remedy remedy = Remedy::none) {
  LawSettings settings = test::settings_of({{"cubic_share", c}});
  settings.remedy = remedy;
  return settings;
}

/// Whether a finger of 72 g stays quiet in a loop at 1 kHz, pushed up to `share` of mu_s n along the lateral
/// axis (k_f n at 45 degrees) and held there.
bool is_quiet(const LawSettings& settings, double load_n, double share) {
  const auto law = make_law("finger-pad", settings);
  TangentialMotion motion = pressed(load_n, rate_hz);
  motion.inclination_rad = 0.7853981633974483;
  SlidingMass finger{{*law, motion}, 0.072, damping_n_s_per_m, 64};
  const double full_n = share * mu_s * load_n;
  const auto push = [&](double, double t) { return full_n * std::min(1.0, t / 3); };
  double most_m_per_s = 0;
  while (finger.t_s < 12) {
    finger.tick(push);
    if (finger.friction.ruptures > 0) return false;
    if (finger.t_s > 11) most_m_per_s = std::max(most_m_per_s, std::abs(finger.v_m_per_s));
  }
  return most_m_per_s < 1e-5;  // a ringing that grows is by then at millimetres a second
}

/// The spring's tangent stiffness over k_f n where it gives `share` of its limit.
double tangent(double c, double share) {
  double rho = share;
  for (int i = 0; i < 50; ++i) rho -= (rho * (1 - c + c * rho * rho) - share) / (1 - c + 3 * c * rho * rho);
  return 1 - c + 3 * c * rho * rho;
}

TEST(TangentStiffness, ACubicPadBuzzesByTheStiffnessWhereItStands) {
  // K T < 2 b: at 1 kHz and b = 0.5 up to 1000 N/m; the integrator of 64 steps a tick holds 1.6 % more.
  for (const double c : {0.0, 0.5, 1.0}) {
    for (const double share : {0.3, 0.93}) {
      const double load_n = 2 * damping_n_s_per_m * rate_hz / (k_f * tangent(c, share));
      EXPECT_TRUE(is_quiet(cubic_pad(c), 0.93 * load_n, share)) << c << " at " << share;
      EXPECT_FALSE(is_quiet(cubic_pad(c), 1.07 * load_n, share)) << c << " at " << share;
    }
  }
  // At the rim itself, (1 + 2 c) k_f n: 0.33 N for c = 1 (SCIENCE 7).
  EXPECT_NEAR(1 / tangent(1, 1), 0.33, 0.004);
}

TEST(TangentStiffness, EveryRemedyQuietsACubicPadUpToItsRim) {
  for (const double c : {0.0, 0.5, 1.0}) {
    for (const Remedy remedy : {Remedy::damping, Remedy::implicit, Remedy::cap}) {
      for (const double load_n : {0.5, 1.0, 3.0}) {
        EXPECT_TRUE(is_quiet(cubic_pad(c, remedy), load_n, 0.93))
            << "c = " << c << ", " << static_cast<int>(remedy) << " at " << load_n << " N";
      }
    }
  }
}

TEST(TangentStiffness, RemediesOfTheCubicPadAreAsleepWhereItIsSoft) {
  // c = 1 has no stiffness at its centre: 2 N need no remedy there, and do at the rim.
  for (const Remedy remedy : {Remedy::damping, Remedy::implicit}) {
    const auto law = make_law("finger-pad", cubic_pad(1, remedy));
    PlaneContact contact{*law, pressed(2, rate_hz)};
    contact.motion.inclination_rad = 0.7853981633974483;
    contact.move_to({0, 0});
    EXPECT_FALSE(contact.move_to({5e-5, 0}).remedied);
    EXPECT_TRUE(contact.move_to({2.5e-4, 0}).remedied);
  }
}

TEST(TangentStiffness, ACappedSpringNeverSlipsByUnloading) {
  for (const char* name : {"stick-slip", "finger-pad", "contact-area"}) {
    const auto law = make_law(name, cubic_pad(0, Remedy::cap));
    PlaneContact contact{*law, pressed(4, rate_hz)};
    contact.motion.inclination_rad = 0.7853981633974483;
    contact.move_to({0, 0});
    const double at_m = 1.1e-3;  // 950 N/m: nine tenths of the limit at 4 N, and beyond the uncapped one
    for (int k = 1; k <= 1000; ++k) contact.move_to({at_m * k / 1000, 0});
    const double ratio = contact.move_to({at_m, 0}).force_n.norm() / 4;
    for (int k = 0; k <= 3990; ++k) {
      contact.motion.normal_force_n = 4 - k * 1e-3;
      const Friction f = contact.move_to({at_m, 0});
      ASSERT_EQ(f.ruptures, 0) << name << " at " << contact.motion.normal_force_n << " N";
      ASSERT_EQ(f.phase, Phase::stick);
      if (std::string_view(name) == "contact-area") continue;  // its coefficient rises as the load falls
      ASSERT_NEAR(f.force_n.norm() / contact.motion.normal_force_n, ratio, 1e-9) << name;
    }
  }
}

}  // namespace
}  // namespace fingerpad::tangent_stiffness_test
