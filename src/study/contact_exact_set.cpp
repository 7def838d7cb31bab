#include "study/contact_exact_set.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/path_words.hpp"
#include "part/import.hpp"

namespace fingerpad {
namespace {

constexpr double metres_per_unit = 1e-3, crease_rad = std::numbers::pi / 6;

[[noreturn]] void refuse(const std::string& path, const CsvColumns& csv, std::size_t row,
                         const std::string& what) {
  throw refused(path + ":" + std::to_string(csv.lines[row]), what);
}

/// Three columns from `first` on, row by row.
std::vector<Vec3> vectors(const CsvColumns& csv, std::size_t first) {
  std::vector<Vec3> all;
  all.reserve(csv.lines.size());
  for (std::size_t i = 0; i < csv.lines.size(); ++i)
    all.emplace_back(csv.columns[first][i], csv.columns[first + 1][i], csv.columns[first + 2][i]);
  return all;
}

std::vector<Vec3> unit_vectors(const std::string& path, const CsvColumns& csv, std::size_t first) {
  constexpr double written = 1e-11;  // twelve digits
  std::vector<Vec3> all = vectors(csv, first);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::abs(all[i].norm() - 1) > written) refuse(path, csv, i, "nx,ny,nz is no unit vector");
    all[i].normalize();
  }
  return all;
}

std::vector<ExactMesh> load_meshes(const std::string& folder) {
  const std::string path = folder + "/meshes.csv";
  const CsvColumns csv = read_csv_columns(path, {"level", "facet_m"});
  if (csv.lines.size() < 2) throw refused(path, "orders need two meshes at least");
  std::vector<ExactMesh> meshes;
  for (std::size_t i = 0; i < csv.lines.size(); ++i) {
    const double level = csv.columns[0][i], facet_m = csv.columns[1][i];
    if (!(level >= 0 && level < 1e6)) refuse(path, csv, i, "level is no mesh's number");
    if (!(facet_m > 0) || (i > 0 && facet_m >= meshes.back().facet_m))
      refuse(path, csv, i, "facet_m must be positive and fall from row to row");
    const std::string mesh = folder + "/mesh-" + std::to_string(static_cast<long>(level)) + ".ply";
    meshes.push_back({import_touchable(mesh, metres_per_unit, crease_rad).part, facet_m});
  }
  return meshes;
}

std::vector<ExactSample> load_samples(const std::string& folder) {
  const std::string path = folder + "/samples.csv";
  const CsvColumns csv =
      read_csv_columns(path, {"x_m", "y_m", "z_m", "foot_x_m", "foot_y_m", "foot_z_m", "nx", "ny", "nz",
                              "signed_distance_m", "sharp_edge_m", "on_face"});
  if (csv.lines.empty()) throw refused(path, "holds no sample");
  const std::vector<Vec3> queries = vectors(csv, 0), feet = vectors(csv, 3);
  const std::vector<Vec3> normals = unit_vectors(path, csv, 6);
  std::vector<ExactSample> samples;
  for (std::size_t i = 0; i < csv.lines.size(); ++i)
    samples.push_back(
        {queries[i], feet[i], normals[i], csv.columns[9][i], csv.columns[10][i], csv.columns[11][i] != 0});
  return samples;
}

ExactPath load_path(const std::filesystem::path& file) {
  const CsvColumns csv =
      read_csv_columns(file.string(), {"foot_x_m", "foot_y_m", "foot_z_m", "nx", "ny", "nz"});
  if (csv.lines.size() < 2) throw refused(file.string(), "a path needs two feet at least");
  return {file.stem().string().substr(5), vectors(csv, 0), unit_vectors(file.string(), csv, 3)};
}

}  // namespace

ExactSet load_exact_set(const std::string& folder) {
  ExactSet set{load_meshes(folder), load_samples(folder), {}};
  std::vector<std::filesystem::path> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("path-") && name.ends_with(".csv")) files.push_back(entry->path());
  }
  if (error) throw refused(folder, "cannot be listed: " + folder_words(folder, error.value()));
  if (files.empty()) throw refused(folder, "holds no path-*.csv");
  std::sort(files.begin(), files.end());
  for (const auto& file : files) set.paths.push_back(load_path(file));
  return set;
}

Rub rub_along(const ExactPath& path, double under_m, double radius_m) {
  Rub rub;
  rub.approach_ticks = 40;
  rub.radius_m = radius_m;
  const double from_m = -(under_m + 2 * radius_m);  // as far outside as it will be deep
  const auto add = [&](std::size_t i, double below_m) {
    rub.positions.emplace_back(path.feet[i] - below_m * path.normals[i]);
    rub.exact.push_back({-below_m, path.normals[i]});
  };
  for (std::size_t k = 0; k < rub.approach_ticks; ++k) {
    const double done = static_cast<double>(k) / static_cast<double>(rub.approach_ticks);
    add(0, from_m + done * (under_m - from_m));
  }
  for (std::size_t i = 0; i < path.feet.size(); ++i) add(i, under_m);
  return rub;
}

}  // namespace fingerpad
