#pragma once

#include <string>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// The profile as a file (TOML), which read_profile takes if it has both axes: the numbers, `[interval]`,
/// `[samples]` and `[refused]`; what was done to the samples, outlier trials and how well the law fits stand
/// above as comments.
std::string profile_text(const ProfileFit& fit, const std::string& source);

/// What the fit says besides its numbers, a line each: steps of cleaning (ProfileFit::steps), outlier_notes
/// and fit_remarks.
std::vector<std::string> fit_notes(const ProfileFit& fit);
/// The trials that are unlike their subject's others.
std::vector<std::string> outlier_notes(const ProfileFit& fit);
/// What the numbers rest on: an offset that is left in, the delay that springs tell, numbers without an
/// interval, whether the pad's law fits.
std::vector<std::string> fit_remarks(const ProfileFit& fit);

/// Why no scene takes the profile, what to measure so that one does, and what of it can be used as it is;
/// empty where it has both axes.
std::string missing_axes_words(const ProfileFit& fit);

}  // namespace fingerpad
