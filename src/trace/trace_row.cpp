#include "trace/trace_row.hpp"

#include <cmath>

namespace fingerpad {
namespace {

constexpr std::array<TraceColumn, trace_column_count> columns = {{
    {"t_s", "s"},   {"x_m", "m"},      {"y_m", "m"},  {"z_m", "m"},  {"phase", "1"}, {"depth_m", "m"},
    {"px_m", "m"},  {"py_m", "m"},     {"pz_m", "m"}, {"nx", "1"},   {"ny", "1"},    {"nz", "1"},
    {"fn_n", "N"},  {"fx_n", "N"},     {"fy_n", "N"}, {"fz_n", "N"}, {"ffx_n", "N"}, {"ffy_n", "N"},
    {"ffz_n", "N"}, {"mu", "1"},       {"cx_m", "m"}, {"cy_m", "m"}, {"cz_m", "m"},  {"angle_rad", "rad"},
    {"part", "1"},  {"triangle", "1"},
}};

bool is_index(double value) noexcept {
  return value >= -1 && value <= 2147483647.0 && value == std::floor(value);
}

}  // namespace

std::span<const TraceColumn> trace_columns() noexcept {
  return columns;
}

TraceRow to_row(const TickRecord& r) noexcept {
  return {r.t_s,
          r.p_WQ.x(),
          r.p_WQ.y(),
          r.p_WQ.z(),
          static_cast<double>(r.phase),
          r.depth_m,
          r.contact_W.x(),
          r.contact_W.y(),
          r.contact_W.z(),
          r.normal_W.x(),
          r.normal_W.y(),
          r.normal_W.z(),
          r.normal_force_n,
          r.force_W_n.x(),
          r.force_W_n.y(),
          r.force_W_n.z(),
          r.friction_W_n.x(),
          r.friction_W_n.y(),
          r.friction_W_n.z(),
          r.mu,
          r.stick_centre_W.x(),
          r.stick_centre_W.y(),
          r.stick_centre_W.z(),
          r.inclination_rad,
          static_cast<double>(r.surface),
          static_cast<double>(r.triangle)};
}

std::string_view row_damage(const TraceRow& row) noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!std::isfinite(row[i])) return "a time or position is not finite";
  }
  const double phase = row[phase_column];
  if (phase != 0 && phase != 1 && phase != 2) return "the phase is none of 0 (free), 1 (stick), 2 (slip)";
  if (!is_index(row[part_column]) || !is_index(row[triangle_column])) {
    return "a part or triangle is no whole number from -1";
  }
  return {};
}

TickRecord to_record(const TraceRow& row) noexcept {
  const auto vector = [&row](std::size_t i) { return Vec3(row[i], row[i + 1], row[i + 2]); };
  TickRecord r;
  r.t_s = row[0];
  r.p_WQ = vector(1);
  r.phase = static_cast<Phase>(static_cast<unsigned char>(row[phase_column]));
  r.depth_m = row[5];
  r.contact_W = vector(6);
  r.normal_W = vector(9);
  r.normal_force_n = row[12];
  r.force_W_n = vector(13);
  r.friction_W_n = vector(16);
  r.mu = row[19];
  r.stick_centre_W = vector(20);
  r.inclination_rad = row[23];
  r.surface = static_cast<int>(row[part_column]);
  r.triangle = static_cast<int>(row[triangle_column]);
  return r;
}

}  // namespace fingerpad
