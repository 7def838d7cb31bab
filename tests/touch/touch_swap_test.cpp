#include "touch/touch_swap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/closed_loop.hpp"
#include "touch/servo_loop.hpp"

namespace fingerpad::touch_swap_test {
namespace {

constexpr double rate_hz = 1000;

Scene torus_scene() {
  Scene scene = test::plane_scene("finger-pad");
  scene.parts.emplace_back();
  scene.contact.method = "proxy";
  scene.motion.rate_hz = rate_hz;
  scene.finger.radius_m = 0.004;
  return scene;
}

/// Pressed on the torus, rubbing to and fro over it.
Vec3 place_at(double t_s) {
  const double across = 1.2 + 0.3 * std::sin(5 * t_s), reach_m = 0.02 + 0.004 - 0.001;
  return {0.05 + reach_m * std::cos(across), 0.01 * std::sin(3 * t_s), reach_m * std::sin(across)};
}

const std::vector<SceneChange>& wanted_changes() {
  static const std::vector<SceneChange> changes = {
      {0.2, "part.0.mu_static", "0.8"},         {0.4, "part.0.mu_dynamic", "0.6"},
      {0.6, "part.0.stiffness_n_per_m", "400"}, {0.8, "friction.law", "dahl"},
      {1.0, "contact.method", "closest-point"}, {1.2, "contact.normals", "facet"},
      {1.4, "friction.law", "stick-slip"},      {1.6, "contact.method", "proxy"},
      {1.8, "part.0.damping_n_s_per_m", "2"}};
  return changes;
}

bool same_bits(const TickRecord& a, const TickRecord& b) {
  return a.t_s == b.t_s && std::memcmp(a.force_W_n.data(), b.force_W_n.data(), 3 * sizeof(double)) == 0 &&
         std::memcmp(a.friction_W_n.data(), b.friction_W_n.data(), 3 * sizeof(double)) == 0 &&
         a.phase == b.phase;
}

struct LiveRun {
  std::vector<TickRecord> rows;
  std::vector<SceneChange> taken;
};

/// Ticks as the servo's, with changes asked for in between.
LiveRun touched(const std::shared_ptr<const World>& world, const Scene& scene, bool changing) {
  Touch touch(world, scene);
  TouchSwap swap(world, scene);
  LiveRun run;
  std::size_t next = 0;
  for (long k = 0; k < 2000; ++k) {
    const double t_s = static_cast<double>(k) / rate_hz;
    const auto& wanted = wanted_changes();
    for (; changing && next < wanted.size() && wanted[next].t_s <= t_s; ++next) swap.change(wanted[next]);
    swap.before_tick(touch, t_s);
    FingerSample sample;
    sample.t_s = t_s;
    sample.p_WQ = place_at(t_s);
    sample.direction_W = scene.finger.direction;
    run.rows.push_back(touch.tick(sample));
  }
  run.taken = swap.taken(0);
  return run;
}

TEST(TouchSwap, ARecordingWithItsChangesGivesTheSameForcesBitForBit) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  const Scene scene = torus_scene();
  const LiveRun live = touched(world, scene, true);
  EXPECT_EQ(live.taken, wanted_changes()) << "each is taken at the tick it was asked before";

  Motion motion;
  motion.p_WQ.resize(3, static_cast<Eigen::Index>(live.rows.size()));
  for (std::size_t i = 0; i < live.rows.size(); ++i) {
    motion.t_s.push_back(live.rows[i].t_s);
    motion.p_WQ.col(static_cast<Eigen::Index>(i)) = live.rows[i].p_WQ;
  }
  const FingerPath path(motion, rate_hz, scene.finger.direction);
  ClosedLoop loop(world, scene, path, live.taken);
  ClosedLoop without(world, scene, path);
  int differ = 0;
  for (const TickRecord& row : live.rows) {
    ASSERT_TRUE(same_bits(loop.next(), row)) << row.t_s;
    differ += same_bits(without.next(), row) ? 0 : 1;
  }
  EXPECT_GT(differ, 1500) << "from the first change on";
}

TEST(TouchSwap, WhatIsNotChangedGoesOn) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  const Scene scene = torus_scene();
  const LiveRun as_it_was = touched(world, scene, false);
  Touch touch(world, scene);
  TouchSwap swap(world, scene);
  for (const TickRecord& row : as_it_was.rows) {
    // To the value that it has: the new touch stands in for the old one, and nothing is felt of it.
    if (std::lround(row.t_s * rate_hz) % 100 == 0) swap.change({0, "part.0.mu_static", "0.3"});
    swap.before_tick(touch, row.t_s);
    FingerSample sample;
    sample.t_s = row.t_s;
    sample.p_WQ = row.p_WQ;
    sample.direction_W = scene.finger.direction;
    ASSERT_TRUE(same_bits(touch.tick(sample), row)) << row.t_s;
  }
  EXPECT_EQ(swap.taken(0).size(), 20u);
}

TEST(TouchSwap, RefusesWhatTheSceneCannotHaveAndStaysAsItWas) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  TouchSwap swap(world, torus_scene());
  for (const auto& [key, value] :
       {std::pair("part.0.mu_static", "0.1"), std::pair("part.0.mu_dynamic", "0.4"),
        std::pair("part.0.stiffness_n_per_m", "0"), std::pair("part.1.mu_static", "0.4"),
        std::pair("part.0.colour", "1"), std::pair("part.0.mu_static", "nan"),
        std::pair("part.x.mu_static", "1"), std::pair("friction.law", "glue"),
        std::pair("contact.method", "auto"), std::pair("contact.normals", "furry"), std::pair("seed", "2")})
    EXPECT_THROW(swap.change({0, key, value}), Error) << key << " = " << value;
  EXPECT_EQ(swap.scene().parts[0].surface.mu_static, 0.3);
  Touch touch(world, torus_scene());
  swap.before_tick(touch, 0);
  EXPECT_TRUE(swap.taken(0).empty());
}

/// Counts what is put in, and knows by what it was made.
struct CountedChange final : ChangeBeside {
  CountedChange(int& its_count, double its_mu) : count(its_count), mu(its_mu) {}
  void put_in() noexcept override { ++count; }
  int& count;
  double mu;
};

TEST(TouchSwap, PutsInWhatChangesBesideTheTouchAtTheSameTickAndOnlyWhatIsTaken) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  TouchSwap swap(world, torus_scene());
  int put_in = 0;
  std::vector<double> made;
  swap.change_too([&](const World& changed, const Scene& scene) {
    EXPECT_EQ(changed.surfaces[0].properties.mu_static, scene.parts[0].surface.mu_static);
    made.push_back(scene.parts[0].surface.mu_static);
    return std::make_unique<CountedChange>(put_in, made.back());
  });
  Touch touch(world, torus_scene());
  swap.before_tick(touch, 0);
  EXPECT_EQ(put_in, 0);
  swap.change({0, "part.0.mu_static", "0.5"});
  swap.change({0, "part.0.mu_static", "0.6"});  // before the first was taken: together with it
  EXPECT_EQ(put_in, 0);
  swap.before_tick(touch, 0.001);
  EXPECT_EQ(put_in, 1);
  EXPECT_EQ(made, (std::vector<double>{0.5, 0.6}));
}

TEST(TouchSwap, ChangesFromAnotherThreadAreTakenInOrderWhileTheServoTicks) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  const Scene scene = torus_scene();
  TouchSwap swap(world, scene);
  ServoLoop loop(
      Touch(world, scene), rate_hz,
      [](double t_s) {
        FingerSample sample;
        sample.p_WQ = place_at(t_s);
        sample.direction_W = Vec3(0, 0.6, -0.8);
        return sample;
      },
      [](const TickRecord&) {}, 1, false, &swap);
  for (int i = 0; i < 200; ++i) swap.change({0, "part.0.stiffness_n_per_m", std::to_string(500 + i)});
  while (loop.latest().t_s < 0.05) {
  }
  for (int i = 0; i < 1000 && swap.taken(0).size() < 200; ++i) {
    const double t_s = loop.latest().t_s;
    while (loop.latest().t_s == t_s) {
    }
  }
  loop.stop();
  const auto taken = swap.taken(0);
  ASSERT_EQ(taken.size(), 200u);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(taken[i].value, std::to_string(500 + i));
    EXPECT_GE(taken[i].t_s, taken[i - (i > 0 ? 1 : 0)].t_s);
  }
}

TEST(SceneChanges, AreReadBackAsTheyWereWritten) {
  EXPECT_EQ(read_scene_changes(scene_changes_text(wanted_changes()), "x"), wanted_changes());
  EXPECT_TRUE(read_scene_changes("", "x").empty());
  const std::string cut = scene_changes_text(wanted_changes());
  EXPECT_EQ(read_scene_changes(cut.substr(0, cut.size() - 3), "x").size(), wanted_changes().size() - 1);
  for (const char* wrong :
       {"a,b,c\n", "t_s,key,value\n1,2\n", "t_s,key,value\nnan,a,b\n", "t_s,key,value\n2,a,b\n1,a,b\n"})
    EXPECT_THROW(read_scene_changes(wrong, "x"), Error) << wrong;
}

}  // namespace
}  // namespace fingerpad::touch_swap_test
