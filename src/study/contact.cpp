#include "study/contact_parts.hpp"

namespace fingerpad {

StudyReport study_contact(const StudyProgress& progress, const std::string& exact_folder) {
  StudyReport report;
  study_contact_accuracy(report, progress);
  if (!exact_folder.empty()) study_contact_exact(report, exact_folder, progress);
  progress("strikes through thin walls");
  study_contact_strikes(report);
  return report;
}

}  // namespace fingerpad
