#pragma once

#include <string>

#include "study/report.hpp"

namespace fingerpad {

/// Draws a study's chart, PNG or SVG by the path's ending. Errors as write_drawing.
void draw_study_chart(const StudyChart& chart, const std::string& path);

}  // namespace fingerpad
