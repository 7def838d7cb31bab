#pragma once

#include <string>

#include "study/report.hpp"

namespace fingerpad {

/// Writes a study's tables (CSV) and, in a program that can draw, its charts (PNG and SVG) into a folder.
/// @returns what was written, for a person: "2 tables and 1 chart (PNG and SVG)"
std::string write_study(const StudyReport& report, const std::string& folder);

}  // namespace fingerpad
