#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/recorded_trial.hpp"

namespace fingerpad {

/// What tells the contact point of a row beside its force.
struct RecordedWrench {
  ContactSensor sensor;
  Vec3 torque_W_n_m, tracked_W;  ///< as in RecordedTrial
};

/// What one row of a recording says. A vector with a component that is not finite was not recorded there.
struct RecordedRow {
  double t_s = 0;
  Vec3 position_W = Vec3::Zero();             ///< fingertip [m]
  Vec3 force_W = Vec3::Zero();                ///< on the finger [N]
  Vec3 normal_W = Vec3::UnitZ();              ///< unit
  Vec3 direction_W = Vec3::Zero();            ///< unit; zero: not known
  std::optional<RecordedWrench> wrench = {};  ///< of a six-axis sensor that tells the contact point
};

/// The rows of one trial, gathered one by one on their way to a RecordedTrial: what every reader of
/// measurements fills.
class TrialRows {
 public:
  /// @param is_numbered  the recording says where trials begin; else a long one is cut into pieces of 20 s,
  /// so
  ///                     that intervals have blocks to draw
  /// @param lacks        RecordedTrial's
  TrialRows(std::string file, int subject, int number, bool is_numbered, std::string lacks = {});

  int subject() const noexcept { return subject_; }
  int number() const noexcept { return number_; }
  std::size_t size() const noexcept { return t_s_.size(); }
  double last_s() const noexcept { return t_s_.back(); }
  /// @pre row.t_s comes after the last
  void add(const RecordedRow& row);

  /// Puts the trial at even steps into `into`, as several where samples are missing for over a second. Each
  /// sample is the nearest row within half a step, whose position and force belong together, or where there
  /// is none a gap's straight line. Throws Error (refused) where it has fewer than 16 rows.
  /// Of a normal force alone, a trial that tells nothing is told in `without_force` instead: of so few rows,
  /// or with a plate whose normal is not along that force.
  void finish(RecordedMeasurement& into) const;

 private:
  /// Whether all that tells the row's sample is there: its torque too, where there is a sensor of it.
  bool is_recorded(std::size_t row) const;
  void finish_piece(std::size_t begin, std::size_t end, RecordedMeasurement& into) const;
  void leave_out(const std::string& words, RecordedMeasurement& into) const;
  void add_pose(std::size_t row, RecordedTrial& trial, Vec3& normal, Vec3& direction) const;

  std::string file_;
  int subject_, number_;
  bool is_numbered_;
  std::string lacks_;
  std::vector<double> t_s_;
  std::vector<Vec3> position_, force_, torque_, tracked_;  // the last two where there is a sensor
  std::optional<ContactSensor> sensor_;
  std::vector<Vec3> normal_, direction_;  // one where they have been the same all along
};

}  // namespace fingerpad
