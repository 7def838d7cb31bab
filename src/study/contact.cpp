#include <optional>

#include "study/contact_parts.hpp"

namespace fingerpad {

StudyReport study_contact(const StudyProgress& progress, const ContactExtent& extent) {
  std::optional<ExactSet> exact;
  // First, so that what is broken there is told at once.
  if (!extent.exact_folder.empty()) exact = load_exact_set(extent.exact_folder);
  StudyReport report;
  study_contact_accuracy(report, extent.most_levels, progress);
  if (exact) study_contact_exact(report, *exact, progress);
  progress("strikes through thin walls");
  study_contact_strikes(report);
  study_contact_auto(report, extent, progress);
  return report;
}

}  // namespace fingerpad
