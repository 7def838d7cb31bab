#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/chart.hpp"

namespace fingerpad {

/// A table that a study writes as CSV: names with units, rows of words and numbers (nan where there is none).
struct StudyTable {
  using Cell = std::variant<std::string, double>;
  std::string name;  ///< of the file, without .csv
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;

  std::string csv() const;
};

/// One style a law, on every chart: 14 laws, told apart by colour, dash and marker together.
CurveStyle law_style(const std::string& law);

/// What a study found. Tables and charts whose name ends in "_measured" hold times of this machine; all
/// others are the same bytes at every run.
struct StudyReport {
  std::vector<StudyTable> tables;
  std::vector<Chart> charts;
};

/// The points of `points` that no other beats in both numbers, by the first. Points that are not finite or
/// not positive are passed over.
std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points);

}  // namespace fingerpad
