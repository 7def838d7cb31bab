#include "study/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/csv_cell.hpp"
#include "base/number_text.hpp"
#include "friction/law_table.hpp"

namespace fingerpad {
std::string StudyTable::csv() const {
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + column;
  text += '\n';
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      if (const auto* number = std::get_if<double>(&row[i])) {
        append_number(text, *number);
      } else {
        text += csv_cell(std::get<std::string>(row[i]));
      }
    }
    text += '\n';
  }
  return text;
}

CurveStyle law_style(const std::string& law) {
  constexpr std::array markers{Marker::disc,    Marker::square, Marker::triangle,
                               Marker::diamond, Marker::ring,   Marker::cross};
  const auto table = law_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const LawEntry& e) { return e.name == law; });
  const auto index = static_cast<std::size_t>(found - table.begin());
  // Seven colours that show on white, gone through twice: the second time dashed, with the markers shifted.
  // Later laws are drawn thinner and over the others, so that coinciding curves all show.
  return {static_cast<int>(index % 7), index < 7 ? Dash::solid : Dash::dashed,
          markers[(index + index / 7 * 2) % markers.size()], 1.7 - 0.07 * static_cast<double>(index)};
}

std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points) {
  std::erase_if(points, [](const auto& p) {
    return !std::isfinite(p.first) || !std::isfinite(p.second) || !(p.first > 0) || !(p.second > 0);
  });
  std::sort(points.begin(), points.end());
  std::vector<std::pair<double, double>> front;
  for (const auto& point : points) {
    if (front.empty() || point.second < front.back().second) front.push_back(point);
  }
  return front;
}

}  // namespace fingerpad
