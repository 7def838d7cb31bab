#include "app/report_run.hpp"

#include <fmt/format.h>

#include <array>

#include "app/packed_numbers.hpp"
#include "base/base64.hpp"
#include "base/error.hpp"
#include "scene/scene_file.hpp"
#include "trace/trace.hpp"
#include "view/small_run.hpp"
#include "view/thumbnail.hpp"

namespace fingerpad {
namespace {

using Json = nlohmann::ordered_json;

constexpr int thumbnail_width_px = 176, thumbnail_height_px = 132;

std::array<PackedRange, 3> box_of(const std::vector<Vec3>& points) {
  std::array<PackedRange, 3> box;
  for (const Vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) box[static_cast<std::size_t>(axis)].take(point[axis]);
  }
  return box;
}

Json box_json(const std::array<PackedRange, 3>& box) {
  return {{"low", {box[0].low, box[1].low, box[2].low}}, {"span", {box[0].span, box[1].span, box[2].span}}};
}

void pack_points(const std::vector<Vec3>& points, const std::array<PackedRange, 3>& box, std::string& bytes) {
  for (const Vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) box[static_cast<std::size_t>(axis)].pack(point[axis], bytes);
  }
}

Json shape_json(const SmallShape& shape) {
  const auto box = box_of(shape.points_W);
  std::string bytes;
  pack_points(shape.points_W, box, bytes);
  for (const auto& triangle : shape.triangles) {
    for (const int corner : triangle) PackedRange::add_code(static_cast<std::uint16_t>(corner), bytes);
  }
  Json json = box_json(box);
  json["points"] = shape.points_W.size();
  json["triangles"] = shape.triangles.size();
  json["data"] = base64(bytes);
  return json;
}

/// What a page is told of each stretch of time in a byte, under which name; in this order, which the page
/// reads.
struct BytesOfStretches {
  const char* name;
  std::vector<std::uint8_t> SmallSeries::*bytes;
};
constexpr BytesOfStretches bytes_of_stretches[] = {{"slip", &SmallSeries::slip_share},
                                                   {"stick", &SmallSeries::stick_share},
                                                   {"ruptures", &SmallSeries::ruptures}};

/// The curves' bounds; their samples go to `words`, what is told of each stretch to `bytes`.
Json series_json(const SmallSeries& series, std::string& words, std::string& bytes) {
  Json json = {{"begin", series.begin_s},
               {"step", series.step_s},
               {"count", series.curves.empty() ? 0 : series.curves.front().values.size()},
               {"shares", series.slip_share.size()}};
  for (const StripCurve& curve : series.curves) {
    PackedRange range;
    for (const double value : curve.values) range.take(value);
    for (const double value : curve.values) range.pack(value, words);
    json["curves"].push_back({{"name", std::string(curve.name)},
                              {"unit", std::string(curve.unit)},
                              {"low", range.low},
                              {"span", range.span}});
  }
  for (const BytesOfStretches& row : bytes_of_stretches) {
    json["bytes"].push_back(row.name);
    for (const std::uint8_t number : series.*row.bytes) bytes += static_cast<char>(number);
  }
  if (series.bucket_s > 0) json["bucket"] = series.bucket_s;
  for (const StripCurve& curve : series.curves) {
    for (const std::uint8_t place : curve.places) bytes += static_cast<char>(place);
  }
  return json;
}

/// Points go to `words`; of each its force, a share of the greatest in 255ths, and its phase to `bytes`.
Json path_json(const SmallPath& path, double max_force_n, std::string& words, std::string& bytes) {
  const auto box = box_of(path.points_W);
  pack_points(path.points_W, box, words);
  for (const double force_n : path.force_n) {
    const double share = max_force_n > 0 ? std::clamp(force_n / max_force_n, 0.0, 1.0) : 0;
    bytes += static_cast<char>(std::lround(share * 255));
  }
  for (const Phase phase : path.phases) bytes += static_cast<char>(phase);
  Json json = box_json(box);
  json["count"] = path.points_W.size();
  return json;
}

/// What the shape of a trace goes by: meshes, and where they stand. Empty where that is not known, or where
/// planes are drawn about the path.
std::string shape_key(const TraceInfo& info, const std::string& path) {
  if (info.mesh_hashes.empty()) return "";
  try {
    const Scene scene = read_recorded_scene(info.scene_text, info.profile_text, path);
    if (!scene.planes.empty()) return "";
    std::string key = fmt::format("{}", fmt::join(info.mesh_hashes, " "));
    for (const PartEntry& part : scene.parts) {
      key += fmt::format(" {} {} {}", part.metres_per_unit, fmt::join(part.position_m, ","),
                         fmt::join(part.rotation.reshaped(), ","));
    }
    return key;
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

ReportBudget report_budget(std::size_t shapes) {
  // A triangle takes some 12 bytes of a page, and all shapes are to take less than two million.
  constexpr std::size_t all_triangles = 150'000;
  ReportBudget budget;
  const auto each = static_cast<int>(all_triangles / std::max<std::size_t>(shapes, 1));
  budget.triangles_a_shape = std::clamp(each, 200, budget.triangles_a_shape);
  return budget;
}

ReportRuns::ReportRuns(const ReportBudget& budget)
    : budget_(budget), thumbnails_(std::make_unique<Thumbnails>(thumbnail_width_px, thumbnail_height_px)) {}

ReportRuns::~ReportRuns() = default;

int ReportRuns::number_of(const SmallShape& shape) {
  constexpr std::size_t most_points = 65'535;  // a corner's number takes 16 bits
  if (shape.triangles.empty() || shape.points_W.size() > most_points) return -1;
  Json json = shape_json(shape);
  const auto [at, is_new] = numbers_.emplace(json.dump(), static_cast<int>(shapes_.size()));
  if (is_new) shapes_.push_back(std::move(json));
  return at->second;
}

ReportRuns::ShownShape ReportRuns::shape_of(const std::string& trace_path, const ViewExtent& extent) {
  const ViewInput input = view_of_trace(read_trace(trace_path), trace_path);
  ShownShape shown;
  shown.notice = input.notice;
  if (!input.world) return shown;
  shown.shape = small_shape(input.world->surfaces, budget_.triangles_a_shape, extent.path.value_or(Ball{}));
  shown.number = number_of(shown.shape);
  return shown;
}

nlohmann::ordered_json ReportRuns::run(const std::string& trace_path) {
  Trace trace = read_trace(trace_path, TraceContents::rows);
  const std::string ends_early = early_end_words(trace);
  const std::string key = shape_key(trace.info, trace_path);
  ViewInput rows;
  rows.rows = std::move(trace.rows);
  const ViewExtent extent = extent_of(rows);
  auto known = by_key_.find(key);
  ShownShape of_this_run;
  if (key.empty()) {
    of_this_run = shape_of(trace_path, extent);
  } else if (known == by_key_.end()) {
    known = by_key_.emplace(key, shape_of(trace_path, extent)).first;
  }
  const ShownShape& shown = key.empty() ? of_this_run : known->second;

  const LookFrom look = telling_look(extent.facing_W);
  const SmallPath path = small_path(rows.rows, budget_.path_points);
  std::string words, bytes;
  Json json = {{"shape", shown.number}, {"maxForce", extent.max_force_n}};
  json["look"] = {{"eye", {look.towards_eye_W.x(), look.towards_eye_W.y(), look.towards_eye_W.z()}},
                  {"up", {look.up_W.x(), look.up_W.y(), look.up_W.z()}}};
  if (!shown.notice.empty()) json["notice"] = shown.notice;
  if (!ends_early.empty()) {
    json["notice"] = fmt::format("The trace {}.", ends_early);
    json["cut"] = ends_early;
  }
  json["path"] = path_json(path, extent.max_force_n, words, bytes);
  json["series"] = series_json(small_series(rows.rows, budget_.samples), words, bytes);
  json["data"] = base64(words + bytes);
  json["thumbnail"] = base64(thumbnails_->jpeg(shown.shape, path, extent.max_force_n, look));
  return json;
}

}  // namespace fingerpad
