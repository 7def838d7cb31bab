#pragma once

#include <functional>
#include <string>

#include "study/contact_surfaces.hpp"
#include "study/report.hpp"

namespace fingerpad {

/// Told what a study does next.
using StudyProgress = std::function<void(const std::string&)>;

/// The largest stable stiffness of the closed loop, the load at which each law's stick buzzes, the energy
/// that friction gives, restick rules, velocity estimators, and the undamped stick (SCIENCE 3 and 4).
/// Some ten seconds; the same result at every run.
StudyReport study_stability(const StudyProgress& progress);

/// Every law's error against its own limit of short ticks and against exact stick-slip, by rate, beside its
/// cost. Some twenty seconds; tables and charts named "_measured" hold times.
StudyReport study_friction(const StudyProgress& progress);

/// How much study_contact looks at.
struct ContactExtent {
  /// Samples of a CAD part's exact surface (a program without a CAD kernel has not got more) with its
  /// tessellations, as in scenes/exact; "": go without, and leave its tables out.
  std::string exact_folder;
  /// Folders on which `auto` is judged too, "": none: of scene files, with a folder `gallery` of more, and of
  /// meshes, their unit a millimetre.
  std::string scenes, parts;
  int most_levels = all_levels;  ///< of tessellation of each surface that is known exactly: at least 2
};

/// Every contact method with every kind of normals, on tessellations of surfaces that are known exactly:
/// position, normal, force and force steps against the exact ones, beside the time of a tick; and how many
/// strikes pop through thin walls; and what `auto` promises, keeps and costs. Two minutes, half of it with
/// two levels; tables and charts named "_measured" hold times. Throws Error (refused) where the exact
/// folder cannot be used.
StudyReport study_contact(const StudyProgress& progress, const ContactExtent& extent);

}  // namespace fingerpad
