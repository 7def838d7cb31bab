#pragma once

#include <string>
#include <vector>

#include "study/stretch_run.hpp"

namespace fingerpad {

struct ContactSettings;

/// What a choice has promised to keep, from a scene's [contact].
struct Promises {
  double force_tolerance = 0.03;
  double mu_tolerance = 0.1;
  double least_force_n = 1;  ///< a tenth of the greatest force: smaller forces are errors of this one

  explicit Promises(const ContactSettings& contact);
};

/// How far one way to touch is off another, the model.
///
/// Two forces are told apart. The contact's, without friction, can be held against the model's tick by tick.
/// The whole force cannot where the pad saws: two runs whose teeth differ by half a tooth are equally right
/// and everywhere different, by up to (mu_s - mu_d) n. So what a choice must keep of friction is its mean
/// coefficient, and `force_*` beside it are told, not judged.
struct ForceFigures {
  long ticks = 0;
  double force_rms_share = 0;      ///< RMS of |force - model's| over the RMS of the model's
  double force_largest_share = 0;  ///< largest of it, over the larger of the model's and least_force_n
  double contact_rms_share = 0, contact_largest_share = 0;  ///< the same without friction
  double contact_99_share = 0;  ///< at most so much on 99 % of the ticks, as contact_largest_share
  double step_beyond_n = 0;     ///< largest step of the contact's force from tick to tick, less the model's
  double mean_mu = 0, model_mean_mu = 0;  ///< sum of friction over sum of normal force, each at its own ticks
  double mu_error_share = 0;              ///< of the model's mean coefficient; 0 where it has none
  long ruptures_missed = 0;               ///< the model's less this choice's: less than 0 where it has more
  long pop_throughs = 0;
};

/// Holds the runs of one choice against the model's, stretch by stretch.
class ForceComparison {
 public:
  explicit ForceComparison(const Promises& promises) : least_force_n_(promises.least_force_n) {}

  /// @pre the model's rate is a whole multiple of the run's, both over the same stretch
  void add(const StretchRun& run, const StretchRun& model);
  ForceFigures figures() const;

 private:
  double least_force_n_;
  ForceFigures sums_;  ///< sums of squares and largest values, until figures() makes shares of them
  double model_square_ = 0, model_contact_square_ = 0;
  double friction_n_ = 0, normal_n_ = 0, model_friction_n_ = 0, model_normal_n_ = 0;
  std::vector<double> contact_shares_;
};

/// What a choice does not keep, each in words ("its force is off by more than 3 % on 5.2 % of the ticks");
/// none where it keeps all: the contact's force within force_tolerance on 99 % of the ticks, the mean
/// coefficient within mu_tolerance, and no pop-through.
std::vector<std::string> broken_promises(const ForceFigures& figures, const Promises& promises);

}  // namespace fingerpad
