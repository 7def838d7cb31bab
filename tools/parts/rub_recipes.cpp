#include "rub.hpp"

namespace fingerpad::parts {
namespace {

using Eigen::Vector2d;

constexpr auto straight = Stroke::Kind::straight;
constexpr auto around = Stroke::Kind::around;

Stroke at(double x, double y, double depth, double inclination, double heading) {
  return {straight, 0, {x, y}, 0, depth, inclination, heading};
}
Stroke to(double seconds, double x, double y, double depth, double inclination, double heading) {
  return {straight, seconds, {x, y}, 0, depth, inclination, heading};
}
Stroke circle(double seconds, double x, double y, double turns, double depth, double inclination,
              double heading) {
  return {around, seconds, {x, y}, turns, depth, inclination, heading};
}

/// Along the pad and back, down the brow, over a vent's slats, round the knob's grips, round both bezels,
/// over a dial.
Recipe dashboard_tour() {
  return {"dashboard_tour",
          "dashboard_fine.stl",
          at(150, 180, -15, 40, 10),
          {
              to(0.7, 150, 178, 1.2, 45, 12),
              to(1.3, -50, 180, 1.3, 48, -12),
              to(0.9, 32, 172, 1.0, 42, 5),
              to(0.3, 32, 172, 1.1, 42, 5),
              to(0.9, 32, 100, 1.2, 60, 4),
              to(0.35, 32, 125, 1.0, 55, 4),
              to(0.35, 31, 99, 1.0, 50, 4),
              to(0.45, 33, 124, 1.2, 52, 4),
              to(0.3, 33, 124, 1.0, 52, 4),
              to(0.8, 12, 46, 0.9, 40, -5),
              circle(2.0, -6, 46, 1.25, 1.1, 35, -15),
              to(0.8, -58.5, 68, 1.0, 45, -10),
              circle(1.7, -98, 68, 1.0, 1.2, 45, -14),
              to(0.8, -158.5, 76, 1.0, 50, -18),
              circle(0.9, -212, 76, 0.4, 1.2, 55, -20),
              to(0.7, -240, 60, 0.9, 58, -22),
              to(0.5, -232, 82, 1.3, 62, -22),
              to(0.5, -232, 84, -15, 45, -22),
          }};
}

/// Into the pocket and about, over its edge, the chamfer, a counterbore, up a gusset, along the upright's
/// back.
Recipe bracket_tour() {
  return {"bracket_tour",
          "bracket_fine.stl",
          at(20, 30, -15, 45, 10),
          {
              to(0.6, 20, 30, 1.2, 45, 10),
              to(0.8, 62, 29, 1.2, 50, 10),
              to(0.3, 78, 20, 1.0, 50, 5),
              to(0.35, 52, 36, 1.4, 55, 0),
              to(0.3, 76, 36, 1.0, 55, 0),
              to(0.7, 66, 4, 1.2, 40, 5),
              to(0.4, 66, -1, 1.0, 30, 5),
              to(0.3, 66, -1, 1.3, 30, 5),
              to(0.8, 14, 8, 1.1, 45, -10),
              to(0.9, 14, 52, 1.2, 55, -5),
              to(0.8, 32, 22, 1.0, 50, 5),
              to(1.1, 32, 62, 1.3, 35, 5),
              to(0.5, 45, 74, 1.0, 45, 10),
              to(0.5, 85, 73, 1.4, 50, 15),
              to(0.5, 50, 74, 1.0, 50, 5),
              to(0.8, 112, 73, 1.2, 60, 20),
              to(0.5, 112, 73, -15, 45, 20),
          }};
}

/// Along the thin rim and round its corner, down on a boss, over ribs and slots in the floor.
Recipe housing_tour() {
  return {"housing_tour",
          "housing_fine.stl",
          at(-40, -46.9, -15, 45, 20),
          {
              to(0.6, -40, -46.9, 0.9, 45, 20),
              to(0.8, 30, -46.9, 1.1, 50, 5),
              to(0.6, -10, -46.9, 0.9, 50, 10),
              to(0.9, 63, -46.9, 1.2, 45, -10),
              circle(0.5, 63, -35.5, 0.25, 1.0, 50, -40),
              to(0.6, 74.4, 10, 1.1, 55, -60),
              to(0.9, 62, 34.5, 1.0, 60, -50),
              to(0.4, 62, 34.5, 1.4, 60, -50),
              to(1.0, 45, 2, 1.0, 60, -20),
              to(0.9, -40, 1, 1.2, 50, -10),
              to(0.7, 22, -2, 1.2, 50, 0),
              to(0.6, -12, 2, 1.0, 45, 5),
              to(0.8, -30, 28, 1.2, 50, 10),
              to(0.5, -30, 28, -20, 45, 10),
          }};
}

/// A second and a half over the pocket's edge and back.
Recipe bracket_pocket() {
  return {"bracket_pocket",
          "bracket_fine.stl",
          at(32, 16, -3, 45, 0),
          {to(0.3, 36, 20, 1.2, 45, 0), to(0.5, 66, 30, 1.2, 50, 5), to(0.5, 34, 22, 1.0, 55, 0),
           to(0.2, 34, 22, -3, 45, 0)}};
}

/// A second and a half along the upright's back and round its corner.
Recipe bracket_ridge() {
  return {"bracket_ridge",
          "bracket_fine.stl",
          at(50, 73, -3, 45, 0),
          {to(0.3, 52, 73, 1.0, 45, 0), to(0.5, 110, 73, 1.2, 60, 20), to(0.5, 60, 73, 1.1, 40, 5),
           to(0.2, 60, 73, -3, 45, 0)}};
}

}  // namespace

std::vector<Recipe> rub_recipes() {
  return {dashboard_tour(), bracket_tour(), housing_tour(), bracket_pocket(), bracket_ridge()};
}

}  // namespace fingerpad::parts
