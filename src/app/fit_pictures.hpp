#pragma once

#include <string>

#include "study/fit_report.hpp"

namespace fingerpad {

/// Writes a fit's report into a folder: report.html, its tables (CSV) and, in a program that can draw, its
/// figures (PNG and SVG).
/// @returns what was written, for a person
std::string write_fit_report(const FitReport& report, const std::string& page, const std::string& folder);

}  // namespace fingerpad
