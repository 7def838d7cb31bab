#pragma once

#include <string>

#include "study/report.hpp"

namespace fingerpad {

/// Draws a study's chart as `path_stem`.png and `path_stem`.svg. Errors as write_drawing.
void draw_study_chart(const StudyChart& chart, const std::string& path_stem);

}  // namespace fingerpad
