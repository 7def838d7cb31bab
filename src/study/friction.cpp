#include "study/study.hpp"
namespace fingerpad {
StudyReport study_friction(const StudyProgress& progress) {
  progress("x");
  return {};
}
}  // namespace fingerpad
