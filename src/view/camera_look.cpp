#include "view/camera_look.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

struct NamedAngles {
  std::string_view name;
  double azimuth_deg, elevation_deg;
};

// At asin(1/sqrt(3)) the three axes look equally long.
constexpr NamedAngles named_angles[] = {{"front", 0, 0},
                                        {"back", 180, 0},
                                        {"left", -90, 0},
                                        {"right", 90, 0},
                                        {"top", 0, 90},
                                        {"bottom", 0, -90},
                                        {"isometric", 45, 35.26438968275465}};

[[noreturn]] void refuse(const std::string& text) {
  throw Error(ErrorKind::usage, "--camera",
              fmt::format("'{}' is neither front, back, left, right, top, bottom, isometric nor "
                          "AZIMUTH,ELEVATION in degrees; a third number zooms, as in 30,45,2",
                          printable(text, 60)));
}

double number_of(const std::string& text, std::string_view cell, double least, double most) {
  const auto number = parse_number(cell);
  if (!number || !(*number >= least && *number <= most)) refuse(text);
  return *number;
}

}  // namespace

LookFrom look_from_angles(double azimuth_deg, double elevation_deg) {
  const double around = azimuth_deg * std::numbers::pi / 180, above = elevation_deg * std::numbers::pi / 180;
  const Vec3 level(std::sin(around), -std::cos(around), 0);
  LookFrom look;
  look.towards_eye_W = std::cos(above) * level + std::sin(above) * Vec3::UnitZ();
  look.up_W = std::cos(above) * Vec3::UnitZ() - std::sin(above) * level;
  return look;
}

std::optional<LookFrom> named_look(std::string_view name) {
  for (const NamedAngles& named : named_angles) {
    if (named.name == name) return look_from_angles(named.azimuth_deg, named.elevation_deg);
  }
  return std::nullopt;
}

LookFrom read_look(const std::string& text) {
  constexpr double turn_deg = 360, steepest_deg = 90, least_zoom = 0.01, most_zoom = 1e4;
  const auto cells = csv_cells(text, ',');
  const std::optional<LookFrom> named = cells.empty() ? std::nullopt : named_look(cells[0]);
  const std::size_t angles = named ? 1 : 2;
  if (cells.size() < angles || cells.size() > angles + 1) refuse(text);
  LookFrom look = named ? *named
                        : look_from_angles(number_of(text, cells[0], -turn_deg, turn_deg),
                                           number_of(text, cells[1], -steepest_deg, steepest_deg));
  if (cells.size() > angles) look.zoom = number_of(text, cells[angles], least_zoom, most_zoom);
  return look;
}

}  // namespace fingerpad
