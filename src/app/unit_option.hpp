#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/word_option.hpp"
#include "base/unit.hpp"

namespace fingerpad {

/// Adds `--unit`, what one unit of a mesh file is; default mm, as most CAD exports are.
inline void add_unit_option(CLI::App& command, std::string& unit) {
  command.add_option("--unit", unit, "What one unit of the mesh file is")
      ->check(one_of(length_unit_names()))
      ->capture_default_str();
}

/// @pre unit passed add_unit_option's check
inline double metres_of(const std::string& unit) {
  return metres_per_unit(unit).value();
}

}  // namespace fingerpad
