#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "view/draw_space.hpp"
#include "view/small_shape.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

class Thumbnails;
struct Trace;

/// How much of each job a page holds, so that the whole stays within 10 MB.
struct ReportBudget {
  std::size_t path_points = 240, samples = 240;
  int triangles_a_shape = 2400;
};

/// @param shapes  different ones, as far as is known
ReportBudget report_budget(std::size_t shapes);

/// What a page shows of runs, as JSON: numbers as base64 of 16 bits each, shapes that several runs share
/// once.
class ReportRuns {
 public:
  /// Throws Error as Thumbnails do.
  explicit ReportRuns(const ReportBudget& budget);
  ~ReportRuns();
  ReportRuns(const ReportRuns&) = delete;
  ReportRuns& operator=(const ReportRuns&) = delete;

  /// The run of a trace: thumbnail, path, curves, and which shape it was on. Throws Error (refused) for a
  /// trace that cannot be read.
  nlohmann::ordered_json run(const std::string& trace_path);
  /// In the order of the runs' numbers for them.
  const nlohmann::ordered_json& shapes() const { return shapes_; }

 private:
  struct ShownShape {
    SmallShape shape;
    int number = -1;     ///< in shapes(); -1: there is nothing to show
    std::string notice;  ///< why
  };
  ShownShape shape_of(const std::string& trace_path, const ViewExtent& extent);
  int number_of(const SmallShape& shape);

  ReportBudget budget_;
  std::unique_ptr<Thumbnails> thumbnails_;
  std::map<std::string, ShownShape> by_key_;  ///< of parts that runs share
  std::map<std::string, int> numbers_;        ///< by what the shape says of itself
  nlohmann::ordered_json shapes_ = nlohmann::ordered_json::array();
};

}  // namespace fingerpad
