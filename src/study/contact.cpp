#include "study/contact_parts.hpp"

namespace fingerpad {

StudyReport study_contact(const StudyProgress& progress) {
  StudyReport report;
  study_contact_accuracy(report, progress);
  progress("strikes through thin walls");
  study_contact_strikes(report);
  return report;
}

}  // namespace fingerpad
