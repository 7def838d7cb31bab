// The block as a program that embeds fingerpad would have it: a finger of the block's mass, integrated here
// (semi-implicit Euler), under the force of the library's tick.

#include <map>
#include <string>

#include "creep_block.hpp"
#include "fingerpad/finger.hpp"

namespace fingerpad::bench {
namespace {

/// The block sinks in by a millimetre and bounces no more after some hundredths of a second.
constexpr SurfaceProperties ground{.stiffness_n_per_m = 1e4, .damping_n_s_per_m = 100};

FingerOptions options_of(const BlockSetup& setup, const std::string& law) {
  const std::map<std::string, double> numbers{{"v_min_m_per_s", setup.v_min_m_per_s},
                                              {"zero_band_m_per_s", setup.zero_band_m_per_s},
                                              {"stick_stiffness_per_m", setup.stick_stiffness_per_m}};
  FingerOptions options{.rate_hz = setup.rate_hz, .friction = {.law = law}};
  for (const FrictionLawInfo& info : friction_laws()) {
    if (info.name != law) continue;
    for (const FrictionParameter& parameter : info.parameters) {
      const auto number = numbers.find(parameter.key);
      if (number != numbers.end()) options.friction.parameters.insert(*number);
    }
  }
  return options;
}

TouchWorld world_of(const BlockSetup& setup, bool one_coefficient) {
  SurfaceProperties surface = ground;
  surface.mu_static = setup.mu_static;
  surface.mu_dynamic = one_coefficient ? setup.mu_static : setup.mu_dynamic;
  TouchWorld world;
  world.add_plane(Vec3::Zero(), Vec3::UnitZ(), surface);
  return world;
}

class FingerBlock : public Block {
 public:
  FingerBlock(const BlockSetup& setup, const std::string& law, bool one_coefficient)
      : setup_(setup), finger_(world_of(setup, one_coefficient), options_of(setup, law)) {
    sample_.p_WQ.z() = -setup.mass_kg * setup.gravity_m_per_s2 / ground.stiffness_n_per_m;
  }

  void step(double push_n) override {
    const double dt_s = 1 / setup_.rate_hz;
    sample_.push_W_n = Vec3(push_n, 0, -setup_.mass_kg * setup_.gravity_m_per_s2);
    const Vec3 force_n = finger_.tick(sample_).force_W_n + sample_.push_W_n;
    velocity_m_per_s_ += dt_s / setup_.mass_kg * force_n;
    sample_.p_WQ += dt_s * velocity_m_per_s_;
    sample_.t_s += dt_s;
  }

  double x_m() const override { return sample_.p_WQ.x(); }
  double speed_m_per_s() const override { return velocity_m_per_s_.x(); }

 private:
  BlockSetup setup_;
  Finger finger_;
  FingerSample sample_;
  Vec3 velocity_m_per_s_ = Vec3::Zero();
};

Program program(const std::string& law, const CurveStyle& style, bool one_coefficient = false) {
  return {"fingerpad, " + law, style, [=](const BlockSetup& setup) {
            return std::make_unique<FingerBlock>(setup, law, one_coefficient);
          }};
}

}  // namespace

std::vector<Program> fingerpad_programs() {
  return {program("finger-pad", {palette::blue, Dash::solid, Marker::disc, 1.6}),
          program("stick-slip", {palette::sky_blue, Dash::dashed, Marker::triangle, 0.8}),
          program("karnopp", {palette::bluish_green, Dash::dash_dot, Marker::ring, 2}),
          program("coulomb", {palette::ink, Dash::dotted, Marker::cross}, true)};
}

}  // namespace fingerpad::bench
