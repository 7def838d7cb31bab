#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "study/measurement_format.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad {

/// A column of measurement_columns by its place there.
enum class MeasuredColumn : std::size_t {
  time,
  x,
  fx = 4,
  nx = 7,
  dx = 10,
  marker_1 = 13,
  marker_2 = 16,
  torque = 19,
  subject = 22,
  trial = 23,
  fn = 24,
  speed = 25
};

/// Where a row stands, for messages.
struct RowPlace {
  const std::string& path;
  long line;
  std::string text() const { return path + ":" + std::to_string(line); }
};

/// The header that a file has for a column.
std::string_view header_of(const MeasurementFormat& format, std::size_t column);
/// Whether a file without the column is refused: time and place (of the tip or the markers), and what the
/// format names. Forces are never: a file without them is told.
bool is_required(const MeasurementFormat& format, std::size_t column);

/// Turns the numbers of a table's rows, column by column, into what was recorded: units, the two markers, the
/// six-axis sensor, the sign of forces.
class RowReader {
 public:
  /// @param present  per column of measurement_columns. Throws Error (refused, path) where columns that
  /// belong
  ///                 together are not all there.
  RowReader(const std::string& path, const MeasurementFormat& format, std::vector<bool> present);

  /// "column fx_n missing"; empty where the force is there whole.
  std::string missing_force() const;
  /// What to say where only its name is missing: "where it is called otherwise, say --columns fx=NAME".
  std::string missing_force_mend() const;
  /// Whether of the force that along z alone is there, in the recording's own axes.
  bool has_normal_force_alone() const;
  bool has(MeasuredColumn first) const;

  double time_s(std::span<const double> numbers) const;
  /// Throws Error (refused, `place`) for a normal or a direction without length.
  RecordedRow row(std::span<const double> numbers, const RowPlace& place) const;
  /// The whole number of a column; 0 where there is none. Throws Error (refused, `place`).
  int whole(std::span<const double> numbers, MeasuredColumn column, const RowPlace& place) const;

 private:
  /// Refuses a sensor's place that nothing would be told with.
  void refuse_unused_place(const std::string& path) const;
  Vec3 vector(std::span<const double> numbers, MeasuredColumn first) const;
  Vec3 unit(std::span<const double> numbers, MeasuredColumn first, const char* what,
            const RowPlace& place) const;
  void take_markers(std::span<const double> numbers, RecordedRow& row) const;

  const MeasurementFormat& format_;
  std::vector<bool> present_;
  bool is_force_whole_ = true;
};

/// Warns of a file that has the normal force alone, where any of its trials was read.
/// @param before  trials in `into` before it
void warn_of_normal_force_alone(const std::string& path, const RowReader& rows, std::size_t before,
                                RecordedMeasurement& into);

/// Warns of a trace whose rows are every so manieth tick: what it has a pad do between them, nobody sees.
void warn_of_thinned(const std::string& path, std::uint64_t every, RecordedMeasurement& into);

/// Trials on their way from rows that name subject and trial.
class TrialCollector {
 public:
  /// @param lacks  RecordedTrial's
  TrialCollector(std::string path, const RowReader& rows, std::string lacks, RecordedMeasurement& into);
  /// Throws Error (refused, `place`) where a time does not come after the one before.
  void add(std::span<const double> numbers, const RowPlace& place);
  void finish();

 private:
  std::string path_;
  const RowReader& rows_;
  std::string lacks_;
  RecordedMeasurement& into_;
  std::optional<TrialRows> trial_;
};

}  // namespace fingerpad
