#pragma once

#include <vector>

#include "study/contact_runs.hpp"
#include "study/judged_cases.hpp"

namespace fingerpad {

/// What one method and normals answer over all ways of a case, tick by tick.
struct JudgedRun {
  std::vector<Vec3> force_W_n;     ///< on the finger
  double tick_ns = 0;              ///< mean time of a tick, of each the best of several turns
  std::vector<long> pop_throughs;  ///< a way
};

/// @param turns  how often the same is run, for the times alone
JudgedRun judged_run(const JudgedCase& judged, const ContactVariant& variant, int turns);

/// What a case's runs are held against, tick by tick.
struct JudgedReference {
  std::vector<Vec3> force_W_n;  ///< on the finger
  std::vector<bool> slips;  ///< the finger is pressed deeper than 4/5 of a rounding's radius: it slips off
  /// What the most complete way itself answers, untimed; empty where the surface is known exactly.
  JudgedRun complete;
};

/// The forces that a case's runs are held against: those of the surface that is known exactly; else the most
/// complete that can be said of a mesh, at the same rate and along the same ways: a proxy (the last method of
/// the table) finds which wall holds the finger and whereabouts; where one smooth wall does, the force is
/// that of the curved patch there, else the proxy's with curved normals. Where the proxy is clear of all
/// facets it is that of the nearest patch, which stands out over a facet that cuts in.
///
/// At the same rate, since another rate is another motion: a proxy that lets go over an edge at 1 kHz and at
/// 40 kHz does so at other places, and then feels other walls.
JudgedReference judged_reference(const JudgedCase& judged);

}  // namespace fingerpad
