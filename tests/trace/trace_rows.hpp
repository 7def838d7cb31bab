#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "touch/world.hpp"
#include "trace/trace_column.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad::test {

/// Rows as a run would give them: free, slip, stick, free; awkward numbers in them.
inline std::vector<TickRecord> some_rows(long count) {
  std::vector<TickRecord> rows;
  for (long k = 0; k < count; ++k) {
    TickRecord r;
    r.t_s = static_cast<double>(k) / 1000;
    r.p_WQ = Vec3(0.1 * std::sin(0.01 * static_cast<double>(k)), -0.0, 1e-300 * static_cast<double>(k));
    if (k % 4 != 0) {
      r.phase = k % 4 == 1 ? Phase::slip : Phase::stick;
      r.depth_m = 1.0 / static_cast<double>(k + 1);
      r.contact_W = r.p_WQ + Vec3(0, 0, r.depth_m);
      r.normal_W = Vec3::UnitZ();
      r.normal_force_n = 1000 * r.depth_m;
      r.friction_W_n = Vec3(-0.3 * r.normal_force_n, 0, 0);
      r.force_W_n = r.friction_W_n + r.normal_force_n * r.normal_W;
      r.mu = 0.3;
      r.inclination_rad = 0.78;
      r.surface = static_cast<int>(k % 2);
      r.triangle = k % 2 == 0 ? 11 : -1;
      r.walls = 1;
    }
    if (r.phase == Phase::stick) r.stick_centre_W = Vec3(1, 2, 3);
    rows.push_back(r);
  }
  return rows;
}

/// Rows of a hand whose finger turns.
inline std::vector<TickRecord> told_rows(long count) {
  std::vector<TickRecord> rows = some_rows(count);
  for (TickRecord& r : rows) {
    if (r.phase != Phase::free) r.walls = r.surface + 2;
    r.encoded_W = r.p_WQ + Vec3(1e-5, 0, 1.0 / 7);
    r.push_W_n = Vec3(-0.1, 1e-17, r.t_s);
    r.velocity_W = Vec3(1.0 / 3, -0.0, r.t_s);
    r.direction_W = Vec3(0, 0.6, -0.8);
    r.attitude << 0.5, -0.5, 0.5, -0.5;
    r.sent_W_n = Vec3(0.1, -0.0, 1.0 / 3);
    r.residual_W_n = Vec3(-1.0 / 7, 0.0, r.t_s);
  }
  return rows;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline TraceInfo some_info() {
  TraceInfo info;
  info.scene_name = "test";
  info.scene_text = "[[part]]\nmesh = \"box.stl\"\ncrease_deg = 100\n";
  info.seed = 18446744073709551615u;
  info.rate_hz = 1000;
  info.version = "0.1.0";
  info.mesh_files = {"box.stl"};
  info.mesh_hashes = {"0123456789abcdef"};
  info.motion_file = "motions/rüb.csv";
  info.motion_hash = "fedcba9876543210";
  info.profile_text = "lateral_axis_m = 3e-4\n";
  info.contact_method = "proxy";
  info.contact_normals = "smooth";
  info.contact_reasons = {"box.stl: proxy, because walls are 1 mm thick (auto)", "b.stl: proxy"};
  return info;
}

/// Of told_rows.
inline TraceInfo told_info() {
  TraceInfo info = some_info();
  info.several_walls = info.in_hand = info.estimated = info.turning = info.attitudes = info.sent = true;
  info.compared = true;
  return info;
}

inline void write_trace(const std::filesystem::path& path, TraceFormat format,
                        const std::vector<TickRecord>& rows, const World& world = {},
                        const TraceInfo& info = some_info()) {
  const auto writer = TraceWriter::create(path.string(), format, info, world);
  writer->append(rows);
  writer->finish();
}

/// The same bits but for the kind of nan.
inline bool same_number(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

inline bool same_row(const TickRecord& a, const TickRecord& b) {
  return std::ranges::all_of(
      trace_columns(), [&](const TraceColumn& column) { return same_number(column.get(a), column.get(b)); });
}

inline bool same_rows(const std::vector<TickRecord>& a, const std::vector<TickRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_row);
}

/// What read_trace says against a file; empty if it reads it.
inline std::string refusal(const std::filesystem::path& path) {
  try {
    read_trace(path.string());
  } catch (const Error& error) {
    return error.kind() == ErrorKind::refused ? error.what()
                                              : "not refused but failed: " + std::string(error.what());
  }
  return {};
}

}  // namespace fingerpad::test
