#include <optional>

#include "study/contact_parts.hpp"

namespace fingerpad {

StudyReport study_contact(const StudyProgress& progress, const std::string& exact_folder,
                          const JudgedFolders& judged) {
  std::optional<ExactSet> exact;
  // First, so that what is broken there is told at once.
  if (!exact_folder.empty()) exact = load_exact_set(exact_folder);
  StudyReport report;
  study_contact_accuracy(report, progress);
  if (exact) study_contact_exact(report, *exact, progress);
  progress("strikes through thin walls");
  study_contact_strikes(report);
  study_contact_auto(report, judged, progress);
  return report;
}

}  // namespace fingerpad
