#pragma once

#include <fmt/format.h>

#include <type_traits>

#include "base/number_text.hpp"
#include "scene/scene_key.hpp"

// Rows of keys whose value goes straight into a member. `into` gives the struct of the scene that has it: the
// newest part, the hand. The default is what the member begins with.

namespace fingerpad {

template <typename Member>
struct MemberOf;
template <typename T, typename Value>
struct MemberOf<Value T::*> {
  using Owner = T;
};

/// The value with which a member begins.
template <auto member>
auto default_of() {
  return typename MemberOf<decltype(member)>::Owner().*member;
}

inline std::string vector_text(const Vec3& v) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x(), v.y(), v.z());
}

template <auto into, auto member>
SceneKey number_key(std::string_view key, double min, double max, std::string_view doc) {
  SceneKey row{key, KeyType::number, doc, number_text(default_of<member>())};
  row.range = {min, max, false};
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    into(scene).*member = table.number(self.key, 0, self.range);
  };
  return row;
}

template <auto into, auto member>
SceneKey whole_key(std::string_view key, std::int64_t min, std::int64_t max, std::string_view doc) {
  SceneKey row{key, KeyType::whole, doc, std::to_string(default_of<member>())};
  row.least_whole = min;
  row.most_whole = max;
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    auto& value = into(scene).*member;
    value = static_cast<std::remove_reference_t<decltype(value)>>(
        table.whole(self.key, 0, self.least_whole, self.most_whole));
  };
  return row;
}

template <auto into, auto member>
SceneKey flag_key(std::string_view key, std::string_view doc) {
  SceneKey row{key, KeyType::flag, doc, default_of<member>() ? "true" : "false"};
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    into(scene).*member = table.flag(self.key, false);
  };
  return row;
}

template <auto into, auto member>
SceneKey vector_key(std::string_view key, std::string_view doc) {
  SceneKey row{key, KeyType::vector, doc, vector_text(default_of<member>())};
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    into(scene).*member = table.vector(self.key, Vec3::Zero());
  };
  return row;
}

/// A vector that is made unit.
template <auto into, auto member>
SceneKey direction_key(std::string_view key, std::string_view doc) {
  SceneKey row{key, KeyType::vector, doc, vector_text(default_of<member>())};
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    into(scene).*member = table.direction(self.key, Vec3::UnitZ());
  };
  return row;
}

/// A text for which `read` does the reading.
/// @param example  as TOML
inline SceneKey text_key(std::string_view key, std::string example, std::string_view doc,
                         decltype(SceneKey::read) read) {
  SceneKey row{key, KeyType::text, doc, std::move(example)};
  row.read = read;
  return row;
}

/// A table that is read as one value; its own keys are the table of that name.
/// @param otherwise  what stands for none, as TOML; empty: nothing does
inline SceneKey table_key(std::string_view key, std::string otherwise, decltype(SceneKey::read) read) {
  SceneKey row{key, KeyType::table, "", std::move(otherwise)};
  row.read = read;
  return row;
}

/// One of several words. `take` is given the word where it takes one, else its number among them.
template <auto take>
SceneKey choice_key(std::string_view key, std::vector<std::string> words, const std::string& default_word,
                    std::string_view doc) {
  SceneKey row{key, KeyType::choice, doc, '"' + default_word + '"'};
  row.words = std::move(words);
  row.default_word = default_word;
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    const std::size_t chosen = table.choice(self.key, 0, self.words);
    if constexpr (std::is_invocable_v<decltype(take), Scene&, std::string_view>) {
      take(scene, self.words[chosen]);
    } else {
      take(scene, chosen);
    }
  };
  return row;
}

/// The row of a key that must be there. The value shown is an example.
inline SceneKey required(SceneKey row) {
  row.required = true;
  return row;
}

/// The row of a key that is read with these words of the table's deciding key alone.
inline SceneKey only_with(std::vector<std::string_view> words, SceneKey row) {
  row.only_with = std::move(words);
  return row;
}

/// The row of a key that says more of another, `file`.
inline SceneKey beside(std::string_view other, SceneKey row) {
  row.beside = other;
  return row;
}

}  // namespace fingerpad
