#include "study/stability_parts.hpp"
#include "study/studies.hpp"

namespace fingerpad {

StudyReport study_stability(const StudyProgress& progress) {
  StudyReport report;
  progress("largest stable stiffness of a wall");
  study_walls(report);
  progress("load above which each law's stick buzzes");
  study_buzz(report);
  progress("remedies for a stick that buzzes");
  study_remedies(report);
  progress("energy that friction gives when load or angle change");
  study_energy(report);
  progress("the two readings of restick");
  study_restick(report);
  progress("velocity from rounded positions");
  study_velocity(report);
  progress("the undamped stick");
  study_undamped_block(report);
  return report;
}

}  // namespace fingerpad
