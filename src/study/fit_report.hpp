#pragma once

#include <string>
#include <vector>

#include "study/cross_validation.hpp"
#include "study/fit_told.hpp"
#include "study/report.hpp"

namespace fingerpad {

/// What `fit --report` shows: the numbers, how they were come by, and pictures.
struct FitReport {
  /// numbers.csv, cross_validation.csv, boundaries.csv and the figures: those with panels.
  StudyReport study;
  std::vector<std::string> without_picture;  ///< "figure 4: why", of those that the data cannot support
  CrossValidation checked;
};

/// Makes the report of a fit.
/// @param settings  as the fit had them
FitReport fit_report(const Measurement& measurement, const ProfileFit& fit, const FitSettings& settings);

/// The report as one HTML page that shows the pictures beside it (SVG) and fetches nothing.
/// @param told    what was told on the way here: the page tells it too
/// @param source  where the numbers come from, a sentence
std::string fit_page(const FitReport& report, const ProfileFit& fit, const FitTold& told,
                     const std::string& source);

}  // namespace fingerpad
