#include "scene/scene_key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "friction/law_table.hpp"
#include "scene_text.hpp"

namespace fingerpad::scene_key_test {
namespace {

using testing::HasSubstr;

TEST(SceneKeys, EachHasItsRowOnceAndReadsOrIsReadWithItsTable) {
  for (const SceneTable& table : scene_tables()) {
    std::set<std::string_view> keys;
    for (const SceneKey& row : table.keys) {
      EXPECT_TRUE(keys.insert(row.key).second) << table.heading << " " << row.key;
      EXPECT_EQ(row.read == nullptr, table.name.ends_with(".rotation")) << row.key;
      EXPECT_TRUE(row.default_word.empty() ||
                  std::find(row.words.begin(), row.words.end(), row.default_word) != row.words.end())
          << row.key;
    }
    for (const std::string_view deciding : table.decided_by)
      EXPECT_EQ(scene_key(table, deciding).type, KeyType::choice) << deciding;
  }
}

/// The text that the documentation shows, as a scene that needs no file.
std::string shown_scene() {
  std::string text = scene_keys_text();
  text.erase(text.find("\n[[set]]"));
  const std::size_t profile = text.find("profile = ");
  return text.erase(profile, text.find('\n', profile) - profile);
}

TEST(SceneKeys, TheShownFileIsASceneOfTheDefaults) {
  const Scene shown = read_scene_text(shown_scene(), "s.toml").scene;
  const Scene plain =
      test::read_scene("[[part]]\nmesh = \"a\"\n" + test::plane_scene.substr(15) + "[hand]\n");
  EXPECT_EQ(shown.seed, plain.seed);
  EXPECT_EQ(shown.parts[0].crease_deg, plain.parts[0].crease_deg);
  EXPECT_EQ(shown.parts[0].metres_per_unit, plain.parts[0].metres_per_unit);
  EXPECT_EQ(shown.parts[0].rotation, plain.parts[0].rotation);
  EXPECT_EQ(shown.planes[0].surface.mu_dynamic, plain.planes[0].surface.mu_dynamic);
  EXPECT_EQ(shown.contact.method, plain.contact.method);
  EXPECT_EQ(shown.contact.normals, plain.contact.normals);
  EXPECT_EQ(shown.contact.greatest_force_n, plain.contact.greatest_force_n);
  EXPECT_EQ(shown.friction.law, plain.friction.law);
  EXPECT_EQ(shown.friction.settings.restick, plain.friction.settings.restick);
  EXPECT_EQ(shown.friction.settings.remedy, plain.friction.settings.remedy);
  EXPECT_FALSE(shown.friction.vibration);
  EXPECT_LT((shown.finger.direction - plain.finger.direction).norm(), 1e-4);  // four digits are shown
  EXPECT_EQ(shown.device.rotation, plain.device.rotation);
  EXPECT_EQ(shown.device.force_limit_n, plain.device.force_limit_n);
  EXPECT_EQ(shown.device.watchdog_s, plain.device.watchdog_s);
  EXPECT_EQ(shown.motion.rate_hz, plain.motion.rate_hz);
  EXPECT_EQ(shown.hand->mass_kg, plain.hand->mass_kg);
  EXPECT_EQ(shown.hand->encoder_m, plain.hand->encoder_m);
  EXPECT_EQ(shown.hand->delay_ticks, plain.hand->delay_ticks);
  for (const auto& [key, value] : shown.friction.settings.numbers) {
    const auto law = find_law(plain.friction.law)->parameters;
    const auto own = std::find_if(law.begin(), law.end(), [&](const auto& p) { return p.key == key; });
    ASSERT_NE(own, law.end()) << key;
    EXPECT_EQ(value, own->default_value) << key;
  }
}

TEST(SceneKeys, EveryKeyIsShown) {
  const std::string text = scene_keys_text();
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& row : table.keys) {
      if (table.name == "friction" && row.shown.empty()) continue;  // of another law than the default one
      EXPECT_THAT(text, HasSubstr(std::string(row.key))) << table.heading;
    }
  }
  EXPECT_THAT(text, HasSubstr("\n# or kind = \"line\", with from_m, to_m, speed_m_per_s\n"));
}

}  // namespace
}  // namespace fingerpad::scene_key_test
