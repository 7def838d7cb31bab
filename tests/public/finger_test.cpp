#include "fingerpad/finger.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "fingerpad/trace_file.hpp"
#include "scene/scene_file.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "touch/closed_loop.hpp"
#include "touch/world.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad::finger_test {
namespace {

using test::why_not;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string source(const char* path) {
  return (test::source_dir() / path).string();
}

TouchWorld plane() {
  TouchWorld world;
  world.add_plane(Vec3::Zero(), 2 * Vec3::UnitZ());
  return world;
}

FingerSample at(double t_s, const Vec3& p_m) {
  FingerSample sample;
  sample.t_s = t_s;
  sample.p_WQ = p_m;
  return sample;
}

/// The middle of the part's flat underside.
Vec3 underside(const PartSurface& part) {
  Vec3 below = 0.5 * (part.lower_corner_m() + part.upper_corner_m());
  below.z() = part.lower_corner_m().z() - 0.01;
  return part.closest(below).point_m;
}

void expect_same_bits(const Vec3& a, const Vec3& b, long tick) {
  for (int i = 0; i < 3; ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i])) << "tick " << tick;
}

TEST(Finger, OfASceneFeelsWhatAReplayFeels) {
  const std::string path = source("scenes/dashboard.toml");
  Finger finger = Finger::of_scene(path);
  const Scene scene = read_scene_file(path).scene;
  ASSERT_FALSE(scene.hand);
  ClosedLoop loop(load_world(scene), scene, load_finger_path(scene));
  FingerPath motion = load_finger_path(scene);
  ASSERT_EQ(finger.rate_hz(), scene.motion.rate_hz);
  int touched = 0;
  const long ticks = test::sanitized() ? motion.tick_count() / 4 : motion.tick_count();
  for (long k = 0; k < ticks; ++k) {
    const TickRecord expected = loop.next(), felt = finger.tick(motion.at(k));
    expect_same_bits(felt.force_W_n, expected.force_W_n, k);
    touched += felt.phase == Phase::free ? 0 : 1;
  }
  EXPECT_GT(touched, 100);
}

TEST(Finger, OfOptionsFeelsWhatASceneThatSaysTheSameFeels) {
  const std::string mesh = source("scenes/parts/bracket_coarse.stl");
  const Scene scene =
      read_scene_text("[[part]]\nmesh = '" + mesh +
                          "'\nstiffness_n_per_m = 700\nmu_static = 0.5\nposition_m = [0, 0, 1]\n"
                          "[contact]\nnormals = 'curved'\n[finger]\nradius_m = 0.002\n"
                          "[friction]\nlaw = 'lugre'\nstribeck_speed_m_per_s = 0.02\n"
                          "[motion]\nrate_hz = 500\n",
                      "scene.toml")
          .scene;
  const auto same = load_world(scene);
  Touch touch(same, scene);
  TouchWorld world;
  const PartSurface part(mesh);
  world.add(part, {.stiffness_n_per_m = 700, .mu_static = 0.5}, {.position_m = {0, 0, 1}});
  Finger finger(world, {.radius_m = 0.002,
                        .rate_hz = 500,
                        .normals = "curved",
                        .friction = {"lugre", {{"stribeck_speed_m_per_s", 0.02}}}});
  EXPECT_EQ(finger.contact_method(), same->contact->method);
  EXPECT_EQ(finger.reasons(), same->contact->reasons);
  const Vec3 start = underside(part) + Vec3(0, 0, 1);
  for (int k = 0; k < 200; ++k) {
    const FingerSample sample = at(k / 500.0, start + Vec3(1e-4 * k, 0, -1e-3));
    const TickRecord felt = finger.tick(sample);
    expect_same_bits(felt.force_W_n, touch.tick(sample).force_W_n, k);
    EXPECT_NE(felt.phase, Phase::free);
  }
}

TEST(Finger, NamesTheLawsThatItCanBeGiven) {
  const std::vector<FrictionLawInfo> laws = friction_laws();
  EXPECT_THAT(laws, testing::Contains(testing::Field(&FrictionLawInfo::name, "lugre")));
  for (const FrictionLawInfo& law : laws) {
    FingerOptions options;
    options.friction.law = law.name;
    for (const FrictionParameter& parameter : law.parameters) {
      if (parameter.default_value > 0) options.friction.parameters[parameter.key] = parameter.default_value;
    }
    EXPECT_GT(Finger(plane(), options).tick(at(0, {0, 0, -1e-3})).normal_force_n, 0) << law.name;
  }
}

TEST(Finger, RefusesOptionsThatCannotBe) {
  const auto why = [](const FingerOptions& options) { return why_not([&] { Finger(plane(), options); }); };
  EXPECT_THAT(why({.friction = {"coulumb"}}), HasSubstr("coulomb"));
  EXPECT_THAT(why({.friction = {"lugre", {{"stribek_speed_m_per_s", 1}}}}), HasSubstr("stribek"));
  EXPECT_THAT(why({.friction = {"a\"\n[hand]\nb"}}), HasSubstr("law"));
  EXPECT_THAT(why({.friction = {"lugre", {{"x = 1\nlaw", 1}}}}), HasSubstr("x = 1"));
  EXPECT_THAT(why({.rate_hz = 0}), HasSubstr("rate_hz"));
  EXPECT_THAT(why({.rate_hz = nan}), HasSubstr("rate_hz"));
  EXPECT_THAT(why({.radius_m = -1}), HasSubstr("radius_m"));
  EXPECT_THAT(why({.contact_method = "proxi"}), HasSubstr("proxy"));
  EXPECT_THAT(why({.normals = "rough"}), HasSubstr("smooth"));
  EXPECT_THAT(why_not([] { Finger finger(TouchWorld{}); }), HasSubstr("nothing to touch"));
}

TEST(TouchWorld, RefusesWhatCannotStandInIt) {
  TouchWorld world;
  const PartSurface part(source("scenes/parts/bracket_coarse.stl"));
  Mat3 stretched = Mat3::Identity(), mirrored = Mat3::Identity();
  stretched(0, 0) = 1.001;
  mirrored(2, 2) = -1;
  EXPECT_THAT(why_not([&] { world.add(part, {}, {.rotation = stretched}); }), HasSubstr("rotation"));
  EXPECT_THAT(why_not([&] { world.add(part, {}, {.rotation = mirrored}); }), HasSubstr("rotation"));
  EXPECT_THAT(why_not([&] { world.add(part, {}, {.position_m = {nan, 0, 0}}); }), HasSubstr("nan"));
  EXPECT_THAT(why_not([&] { world.add(part, {.stiffness_n_per_m = 0}); }), HasSubstr("stiffness_n_per_m"));
  EXPECT_THAT(why_not([&] { world.add(part, {.mu_static = 0.1, .mu_dynamic = 0.2}); }),
              HasSubstr("mu_static"));
  EXPECT_THAT(why_not([&] { world.add_plane(Vec3::Zero(), Vec3::Zero()); }), HasSubstr("normal"));
  EXPECT_THAT(why_not([&] { world.add_plane(Vec3::Zero(), {nan, 0, 0}); }), HasSubstr("normal"));
}

TEST(TouchWorld, NumbersPartsBeforePlanesAndIsNotChangedByItsCopies) {
  TouchWorld world = plane();
  const TouchWorld before = world;
  const PartSurface part(source("scenes/parts/bracket_coarse.stl"));
  world.add(part, {}, {.position_m = {0, 0, 1}});
  Finger finger(world, {.contact_method = "closest-point"}), earlier(before);
  EXPECT_EQ(finger.tick(at(0, {5, 5, -1e-3})).surface, 1);
  const Vec3 inside = underside(part) + Vec3(0, 0, 1 + 1e-5);
  EXPECT_EQ(finger.tick(at(1e-3, inside)).surface, 0);
  EXPECT_EQ(earlier.tick(at(0, {5, 5, -1e-3})).surface, 0);
  EXPECT_EQ(earlier.tick(at(1e-3, inside)).phase, Phase::free);
}

TEST(TraceRecorder, WritesWhatAFingerFelt) {
  for (const char* name : {"slide.h5", "slide.csv"}) {
    const std::string path = (test::scratch_dir() / name).string();
    Finger finger(plane());
    std::vector<TickRecord> felt;
    TraceRecorder recorder(path, finger);
    for (int k = 0; k < 100; ++k) {
      felt.push_back(finger.tick(at(1e-3 * k, {5e-4 * k, 0, -1e-3})));
      recorder.append(felt.back());
    }
    recorder.finish();
    const TraceFile trace = read_trace_file(path);
    EXPECT_TRUE(trace.complete);
    ASSERT_EQ(trace.rows.size(), felt.size());
    for (std::size_t k = 0; k < felt.size(); ++k)
      expect_same_bits(trace.rows[k].force_W_n, felt[k].force_W_n, static_cast<long>(k));
  }
}

TEST(TraceRecorder, LeavesATraceThatWasCutShort) {
  const std::string path = (test::scratch_dir() / "cut.h5").string();
  Finger finger(plane());
  {
    TraceRecorder recorder(path, finger);
    recorder.append(finger.tick(at(0, {0, 0, -1e-3})));
    recorder.flush();
  }
  const TraceFile trace = read_trace_file(path);
  EXPECT_FALSE(trace.complete);
  EXPECT_EQ(trace.rows.size(), 1u);
  EXPECT_EQ(trace.rate_hz, 1000);
}

TEST(TraceRecorder, RefusesAnEndingThatIsNoTraces) {
  const Finger finger(plane());
  try {
    TraceRecorder recorder((test::scratch_dir() / "slide.mat").string(), finger);
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr(".h5 or .csv"));
  }
}

}  // namespace
}  // namespace fingerpad::finger_test
