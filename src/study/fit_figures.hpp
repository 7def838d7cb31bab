#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/chart.hpp"
#include "study/report.hpp"
#include "study/stick_paths.hpp"

namespace fingerpad {

/// What the pictures of a fit are made from.
struct FitPictureSource {
  const Measurement& measurement;
  const ProfileFit& fit;
  const StickPicture& stick;
};

// The paper's figures 3 to 11 from a user's own data. A figure that the data cannot support has no panel, and
// says in its first note why.

/// With the set-up of fig. 3: the way of the fingertip and the tangential force on it, of the sliding trial
/// whose force goes round most (a cycloid).
Chart force_loop_figure(const FitPictureSource& source);
/// Fig. 4: stick about its centre, raw, averaged over bearings, and the fitted ellipse, per subject.
Chart stick_ellipse_figure(const FitPictureSource& source);
/// Figs. 5 and 6: each trial's axes over those of its subject at 45 degrees, with both lines and their
/// intervals.
Chart normalised_axes_figure(const FitPictureSource& source);
/// Fig. 7: the normalised ellipse at angles of the finger.
Chart normalised_ellipses_figure(const FitPictureSource& source);
/// Fig. 8: tangential force against displacement in stick, lateral and longitudinal, with the fitted spring.
Chart force_displacement_figure(const FitPictureSource& source);
/// Fig. 9: velocity, normal force, tangential force and their ratio where slip gives way to stick, with
/// v_min, mu_s and mu_d. Where v_min is refused, so is the figure.
Chart phase_change_figure(const FitPictureSource& source);
/// Fig. 10: position (less a parabola over 50 ms, the stroke itself) and force of a slipping fingertip, along
/// the motion and along the normal.
Chart slip_oscillation_figure(const FitPictureSource& source);
/// Fig. 11: power spectral densities of tangential and normal force in slip.
Chart slip_spectrum_figure(const FitPictureSource& source);

/// Where the phases of a trial begin and why, with the local stiffness that parts them, of two seconds of the
/// trial with most such places.
Chart phase_boundaries_figure(const FitPictureSource& source);

/// What they are called, in that order: 5 and 6 are one.
inline constexpr std::array<std::string_view, 9> fit_figure_names{"figure3",  "figure4",  "figure5_6",
                                                                  "figure7",  "figure8",  "figure9",
                                                                  "figure10", "figure11", "stick_and_slip"};

/// All of them.
std::vector<Chart> fit_figures(const FitPictureSource& source);

/// Where each phase of every trial begins and why: "boundaries", a row each.
StudyTable boundaries_table(const FitPictureSource& source);

}  // namespace fingerpad
