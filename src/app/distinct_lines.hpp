#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/standard_streams.hpp"

namespace fingerpad {

/// Lines that many jobs share: each is told once on standard error, and no more than a screen can hold.
class DistinctLines {
 public:
  explicit DistinctLines(std::string_view start) : start_(start) {}

  /// @param lines  outlive this
  void add(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      if (seen_.insert(line).second && seen_.size() <= most_lines) print_err("{}{}\n", start_, line);
    }
  }
  std::size_t left_out() const noexcept { return seen_.size() - std::min(seen_.size(), most_lines); }

 private:
  static constexpr std::size_t most_lines = 12;  // a set has one for every mesh and every place
  std::string_view start_;
  std::set<std::string_view> seen_;
};

}  // namespace fingerpad
