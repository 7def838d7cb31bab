#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {

/// What the value of a key is.
enum class KeyType { number, whole, flag, text, choice, vector, table };

/// One key of a scene file: all that is known of it. The reader, the lists of known keys and their near
/// misses, sets, `--help` and the README go by these rows. A key's unit stands in its name.
struct SceneKey {
  std::string_view key{};
  KeyType type = KeyType::number;
  std::string_view doc{};  ///< what follows its value in the documentation; may be empty
  std::string shown{};  ///< the value there, as TOML: the default, or an example where there is none; empty
                        ///< for a table (its keys stand there) and for what is documented elsewhere
  NumberRange range{};  ///< of a number
  std::int64_t least_whole = 0, most_whole = 0;  ///< of a whole number
  std::vector<std::string> words{};              ///< of a choice
  std::string default_word{};                    ///< of a choice; empty: none
  bool required = false;
  /// The words of the table's deciding key under which this one is read ("sine" and "circle", names of laws);
  /// empty: always.
  std::vector<std::string_view> only_with{};
  /// The key of the table that it says more of, and goes with alone ("file"); empty: none.
  std::string_view beside{};
  /// Reads it into the newest part, plane, ... of the scene; called where the table has it. Null: its table
  /// is read as one value.
  void (*read)(const SceneKey& row, const TomlTable& table, Scene& scene) = nullptr;
};

/// One table of a scene file.
struct SceneTable {
  std::string_view name;     ///< "part", "friction.vibration"; "" for the file itself
  std::string_view heading;  ///< as messages and the documentation write it: "[[part]]"
  std::string_view doc;
  std::vector<SceneKey> keys;
  std::vector<std::string_view> decided_by{};  ///< the choices of which SceneKey::only_with speaks
  /// Keys of other tables, dotted, whose word counts among them where it is written ("motion.rate_hz").
  std::vector<std::string_view> also_by{};
};

/// All tables with their keys, in the order in which they are read and documented.
const std::vector<SceneTable>& scene_tables();

/// @pre there is such a table, or such a key in it
const SceneTable& scene_table(std::string_view name) noexcept;
const SceneKey& scene_key(const SceneTable& table, std::string_view key) noexcept;

/// The key of a table; null if it has none of that name.
const SceneKey* find_scene_key(const SceneTable& table, std::string_view key) noexcept;

/// What may stand in the table: its keys, and in the file itself the other tables too.
std::vector<std::string> known_keys(const SceneTable& table);

/// Whether `row` is read where the deciding key says `word`.
bool goes_with(const SceneKey& row, std::string_view word) noexcept;

/// A table of the file made ready to be read. Throws Error (refused) for a key that is not known.
TomlTable open_table(const TomlNode& node, const std::string& file, const SceneTable& table);

/// Reads every key that stands there. Throws Error (refused), also for a required key that is not there.
/// @param word  what the deciding key says: keys that do not go with it are not required
void read_keys(const SceneTable& table, const TomlTable& from, Scene& scene, std::string_view word = {});

/// The full dotted name of a key of a set: "part.mesh" for `mesh`, "motion.file" for `motion`, the key itself
/// for any other that a scene has ("seed", "part.mu_static", "friction.vibration.amplitude"); nothing for one
/// that it has not.
std::optional<std::string> set_key_target(std::string_view key);

/// All keys that a set may have, for messages.
std::vector<std::string> set_keys();

/// True where the key's value is a list of three numbers ("finger.direction").
bool is_vector_key(std::string_view dotted_key);

/// The key whose value is a whole number ("seed", "motion.place"); null for any other.
const SceneKey* find_whole_key(std::string_view dotted_key);

/// The key whose value is one of a few words ("friction.law"); null for any other.
const SceneKey* find_choice_key(std::string_view dotted_key);

/// A scene file with every key, its default or an example and what it is: what the README and `--help` show.
/// Numbers of laws other than the default one are left to the table of laws.
std::string scene_keys_text();

}  // namespace fingerpad
