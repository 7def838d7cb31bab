#pragma once

#include <functional>
#include <string>
#include <vector>

#include "replay/contact_store.hpp"
#include "replay/figures.hpp"
#include "replay/motion_store.hpp"
#include "replay/run_proof.hpp"
#include "scene/scene.hpp"
#include "touch/mesh_store.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_info.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {

/// Where one scene's run goes.
struct JobOutput {
  std::string path;  ///< empty: no trace is written, and the figures are all
  TraceFormat format = TraceFormat::hdf5;
  TraceChoice choice = {};         ///< which columns and rows the trace has
  std::string version;             ///< of the program, kept in the trace
  bool resume = false;             ///< keep a complete trace of the very same run instead of making it again
  std::function<void()> on_begin;  ///< it has begun: the folder may change; may be empty
  std::function<void(double share_done)> on_ticks;  ///< told now and then, 0 .. 1; may be empty
  /// Of the job among those of its scene, in warnings of its own figures; empty: the scene's.
  std::string name;
};

/// What a run came to.
struct JobResult {
  std::vector<double> figures;                  ///< Figures::values()
  std::string contact_method, contact_normals;  ///< see TraceInfo
  std::vector<std::string> contact_reasons;
  std::vector<std::string> motion_notes;  ///< LoadedMotion::notes
  std::vector<std::string> warnings;      ///< of the motion, and of what it touches
  /// What the summary keeps of them, and of a press that is too hard: what its figures do not tell, and what
  /// the machine and the options have no part in.
  std::vector<std::string> kept_warnings;
  bool kept = false;          ///< the trace of an earlier run was kept
  MadeAgain made_again = {};  ///< why a trace that was there to resume was made again, if it was
};

/// Follows a scene's motion through its world, tick by tick, and writes the trace.
/// Throws Error (refused) for inputs, Error (fault) for the disk; an unfinished trace then stays behind,
/// marked so. To resume, an earlier trace is kept if its proof (run_proof.hpp) says that it is this run's; a
/// sealed HDF5 trace whose proof is lost also if what it says about itself is this run, tick for
/// tick, and no remedy could act in it, which a trace does not tell.
/// @param contacts  of jobs whose finger goes the same way; null: it asks its contact method all by itself
JobResult run_job(const Scene& scene, MeshStore& meshes, MotionStore& motions, const JobOutput& output,
                  ContactStore* contacts = nullptr);

}  // namespace fingerpad
