#include "motion/motion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Which column of the file holds each wanted number: t, x, y, z, dx, dy, dz; -1 for none.
using ColumnPlaces = std::array<int, 7>;
constexpr std::array<std::string_view, 7> wanted = {"t_s", "x_m", "y_m", "z_m", "dx", "dy", "dz"};

ColumnPlaces find_columns(const std::string& where, std::string_view header) {
  if (header.starts_with("\xef\xbb\xbf")) header.remove_prefix(3);
  ColumnPlaces places;
  places.fill(-1);
  const auto names = cells_of(header);
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (trimmed(names[i]) == wanted[k]) places[k] = static_cast<int>(i);
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (places[k] < 0) {
      throw refused(where, fmt::format("no column '{}'; a motion table starts with the line t_s,x_m,y_m,z_m "
                                       "(and optionally dx,dy,dz)",
                                       wanted[k]));
    }
  }
  const int directions = (places[4] >= 0) + (places[5] >= 0) + (places[6] >= 0);
  if (directions != 0 && directions != 3)
    throw refused(where, "the finger's direction needs all of dx, dy and dz");
  return places;
}

/// The wanted numbers of one line; `where` is its file:line.
std::array<double, 7> read_row(const std::string& where, std::string_view line, const ColumnPlaces& places) {
  const auto cells = cells_of(line);
  std::array<double, 7> row{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (places[k] < 0) continue;
    const auto column = static_cast<std::size_t>(places[k]);
    if (column >= cells.size()) {
      throw refused(
          where, fmt::format("{} cells, but column '{}' is number {}", cells.size(), wanted[k], column + 1));
    }
    const auto value = parse_number(cells[column]);
    if (!value)
      throw refused(where, fmt::format("'{}' in column '{}' is no number", cells[column], wanted[k]));
    if (!std::isfinite(*value)) throw refused(where, fmt::format("column '{}' is not finite", wanted[k]));
    row[k] = *value;
  }
  return row;
}

}  // namespace

Motion read_motion_csv(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refused(path, "cannot be read");
  std::string line;
  if (!std::getline(file, line)) throw refused(path, "is empty");
  const ColumnPlaces places = find_columns(path + ":1", line);
  const bool has_direction = places[4] >= 0;

  Motion motion;
  std::vector<Vec3> positions, directions;
  for (long number = 2; std::getline(file, line); ++number) {
    if (trimmed(line).empty()) continue;
    const std::string where = fmt::format("{}:{}", path, number);
    const auto row = read_row(where, line, places);
    if (!motion.t_s.empty() && !(row[0] > motion.t_s.back())) {
      throw refused(where, fmt::format("time {} s does not come after {} s", row[0], motion.t_s.back()));
    }
    motion.t_s.push_back(row[0]);
    positions.emplace_back(row[1], row[2], row[3]);
    if (!has_direction) continue;
    const Vec3 direction(row[4], row[5], row[6]);
    const double length = direction.norm();
    if (!(length > 1e-6) || !std::isfinite(length)) throw refused(where, "dx,dy,dz name no direction");
    directions.emplace_back(direction / length);
  }
  if (motion.t_s.empty()) throw refused(path, "has a header but no rows");

  motion.p_WQ.resize(3, static_cast<Eigen::Index>(positions.size()));
  motion.direction_W.resize(3, static_cast<Eigen::Index>(directions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    motion.p_WQ.col(static_cast<Eigen::Index>(i)) = positions[i];
  for (std::size_t i = 0; i < directions.size(); ++i) {
    motion.direction_W.col(static_cast<Eigen::Index>(i)) = directions[i];
  }
  return motion;
}

}  // namespace fingerpad
