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
// says in its first note why. None has its name: that stands in fit_figure_rows.

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

/// What one is called, its file too, and what draws it.
struct FitFigure {
  std::string_view name;
  Chart (*draw)(const FitPictureSource&);
};

/// All of them, in the paper's order: 5 and 6 are one.
inline constexpr std::array<FitFigure, 9> fit_figure_rows{{{"figure3", force_loop_figure},
                                                           {"figure4", stick_ellipse_figure},
                                                           {"figure5_6", normalised_axes_figure},
                                                           {"figure7", normalised_ellipses_figure},
                                                           {"figure8", force_displacement_figure},
                                                           {"figure9", phase_change_figure},
                                                           {"figure10", slip_oscillation_figure},
                                                           {"figure11", slip_spectrum_figure},
                                                           {"stick_and_slip", phase_boundaries_figure}}};

/// Draws them, each with its name.
std::vector<Chart> fit_figures(const FitPictureSource& source);

/// Where each phase of every trial begins and why: "boundaries", a row each.
StudyTable boundaries_table(const FitPictureSource& source);

}  // namespace fingerpad
