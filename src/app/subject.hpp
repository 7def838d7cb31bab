#pragma once

#include <string>

#include "scene/scene.hpp"

namespace fingerpad {

struct World;

/// What a path on the command line names, told by ending and content: *.toml is a scene, and so is `-`; HDF5,
/// or CSV with a trace's columns, is a trace; all else is a mesh.
enum class SubjectKind { scene, mesh, trace };
SubjectKind subject_kind(const std::string& path);

/// Throws Error (refused) where there is no such file, where a profile is named in a scene's place, and where
/// a scene has a fault: told before what is missing to show or to move it, such as a display.
void refuse_unfit_subject(const std::string& path);

/// A scene file's scene; of a set, its first job's. Throws Error (refused).
Scene single_scene(const std::string& path);

/// Prints the verdicts' warnings to standard error, as `fingerpad: warning: FILE: WHAT`.
void tell_warnings(const World& world);

/// Prints a line to standard error for each part that was read in an unlikely unit.
void tell_unit_hints(const World& world, const Scene& scene);

/// Prints what was chosen where the scene left its contact open, and why, a line a part, to standard error;
/// but for tolerances that the forces of a live finger are not taken for.
void tell_choice(const World& world);

}  // namespace fingerpad
