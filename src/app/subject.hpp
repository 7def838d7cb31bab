#pragma once

#include <string>

#include "app/progress_bar.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// What a path on the command line names, told by ending and content: *.toml is a scene, and so is `-`; HDF5,
/// or CSV with a trace's columns, is a trace; all else is a mesh.
enum class SubjectKind { scene, mesh, trace };
SubjectKind subject_kind(const std::string& path);

/// A scene, mesh or trace made ready to be shown. A scene with a motion is replayed first; one without shows
/// its parts.
/// @param metres_per_unit  for a mesh
/// @param bar  shows how the meshes' loading goes; finished before anything is told
/// Throws Error (refused) as loading and replaying do.
ViewInput load_subject(const std::string& path, double metres_per_unit, LoadBar& bar);

/// A scene file's scene; of a set, its first job's. Throws Error (refused).
Scene single_scene(const std::string& path);

/// The files that showing a subject reads: itself, and what a scene names.
std::vector<std::string> subject_files(const std::string& path);

/// Prints the verdicts' warnings to standard error, as `fingerpad: warning: FILE: WHAT`.
void tell_warnings(const World& world);

/// Prints a line to standard error for each part that was read in an unlikely unit.
void tell_unit_hints(const World& world, const Scene& scene);

/// Prints what was chosen where the scene left its contact open, and why, a line a part, to standard error;
/// but for tolerances that the forces of a window's finger are not taken for.
void tell_choice(const World& world);

}  // namespace fingerpad
