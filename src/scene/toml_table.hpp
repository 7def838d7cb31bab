#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "base/types.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {

/// What a number may be; both ends belong to it unless `above_min`.
struct NumberRange {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
  bool above_min = false;  ///< must be larger than min
};

/// One table of a scene file, read key by key. Every reading throws Error (refused, `file:line:column`) where
/// the value is not what was asked for; a key that is absent gives the fallback.
class TomlTable {
 public:
  /// Refuses every key that is not in `known`, with the nearest known one as the mend.
  /// @param table  outlives this
  /// @param label  as the file writes it, for messages: "[friction]"
  TomlTable(const TomlNode& table, std::string file, std::string label,
            const std::vector<std::string>& known);

  bool has(std::string_view key) const noexcept { return find_entry(table_, key) != nullptr; }
  const TomlNode* value(std::string_view key) const noexcept;

  double number(std::string_view key, double fallback, const NumberRange& range) const;
  std::int64_t whole(std::string_view key, std::int64_t fallback, std::int64_t min, std::int64_t max) const;
  bool flag(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  /// Three finite numbers within +-farthest_m.
  Vec3 vector(std::string_view key, const Vec3& fallback) const;
  /// A vector that has a direction, made unit.
  Vec3 direction(std::string_view key, const Vec3& fallback) const;
  /// A text that is one of `words`; its number among them.
  std::size_t choice(std::string_view key, std::size_t fallback, const std::vector<std::string>& words) const;

  /// Throws if the key is absent.
  void require(std::string_view key) const;
  /// The error that `what` is wrong with the value of `key` (with the table, if it has no such key).
  Error error(std::string_view key, const std::string& what) const;
  /// "'mu_static' in [[part]]".
  std::string name(std::string_view key) const;
  const std::string& file() const noexcept { return file_; }

 private:
  const TomlNode& typed(std::string_view key, const TomlNode& value, bool good,
                        std::string_view wanted) const;

  const TomlNode& table_;
  std::string file_;
  std::string label_;
};

}  // namespace fingerpad
