#include "replay/run_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "replay/disk_room.hpp"
#include "replay/hard_press.hpp"
#include "replay/missing_inputs.hpp"
#include "replay/never_touches.hpp"
#include "replay/residual_warnings.hpp"
#include "replay/run_proof.hpp"
#include "touch/closed_loop.hpp"
#include "touch/unit_hints.hpp"
#include "trace/file_seal.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

bool same_run(const TraceInfo& a, const TraceInfo& b) {
  return run_digest(a, TraceFormat::hdf5).whole == run_digest(b, TraceFormat::hdf5).whole;
}

/// Of a block that begins at tick `first` the rows that are written.
const std::vector<TickRecord>& thinned(const std::vector<TickRecord>& block, long first,
                                       const ClosedLoop& loop, std::uint64_t every,
                                       std::vector<TickRecord>& kept) {
  const long last = loop.has_diverged() ? first + static_cast<long>(block.size()) - 1 : loop.tick_count() - 1;
  kept.clear();
  for (long i = 0; i < static_cast<long>(block.size()); ++i) {
    if (is_kept(first + i, last, every)) kept.push_back(block[static_cast<std::size_t>(i)]);
  }
  return kept;
}

/// What a run came to.
struct RunEnd {
  std::vector<double> figures;
  FileSum trace;  ///< where one was written
};

/// Runs it and writes its trace.
RunEnd run(const Scene& scene, const std::shared_ptr<const World>& world, const FingerPath& path,
           const TraceInfo& info, const JobOutput& output, ContactStore* contacts) {
  Figures figures(world, scene.finger.radius_m);
  const bool may_share = contacts != nullptr && info.changes.empty();
  ContactStore::Share share = may_share ? contacts->share(scene, *world, path) : ContactStore::Share();
  ClosedLoop loop(world, scene, path, info.changes, share.wrap());
  std::unique_ptr<TraceWriter> writer;
  const std::uint64_t rows = kept_rows(loop.tick_count(), info.every);
  if (!output.path.empty()) refuse_full_disk(output.path, output.format, info, rows);
  if (output.on_begin) output.on_begin();
  if (!output.path.empty()) writer = TraceWriter::create(output.path, output.format, info, *world, rows);
  constexpr long block_ticks = 64;   // that stay in the processor's nearest memory until they are written
  constexpr long told_ticks = 4096;  // between words on how far it is
  std::vector<TickRecord> block, kept;
  block.reserve(block_ticks);
  for (long first = 0; first < loop.tick_count(); first += block_ticks) {
    block.clear();
    for (long k = first; k < std::min(first + block_ticks, loop.tick_count()) && !loop.has_diverged(); ++k) {
      block.push_back(loop.next());
      figures.observe(block.back());
    }
    if (writer) writer->append(info.every == 1 ? block : thinned(block, first, loop, info.every, kept));
    const long done = first + static_cast<long>(block.size());
    if (output.on_ticks && (done % told_ticks == 0 || done == loop.tick_count()))
      output.on_ticks(static_cast<double>(done) / static_cast<double>(loop.tick_count()));
    if (!loop.has_diverged()) continue;
    if (writer) writer->flush();  // what there was until then stays behind
    throw refused(scene.path, loop.divergence());
  }
  share.finish();
  return {figures.values(), writer ? writer->finish() : FileSum()};
}

/// Whether a whole trace of a run may be kept for what it says of itself: its rows are all there, and nothing
/// acted that no trace tells.
bool is_countable(const TraceInfo& info, const Scene& scene) {
  return info.columns.empty() && info.every == 1 && scene.friction.settings.remedy == Remedy::none;
}

/// Whether the rows tell all figures: no trace has where a proxy lagged, and what a turning finger's torque
/// was.
bool tell_all(const TraceInfo& info, const FingerPath& motion) {
  const ContactMethodEntry* method = find_contact_method(info.contact_method);
  return info.changes.empty() && (method == nullptr || !method->may_lag) && !motion.turns();
}

/// The figures of a whole HDF5 trace of this very run, counted again from its rows; where these do not tell
/// all, of a run that writes nothing. @pre it is countable
std::optional<std::vector<double>> recounted(const std::string& path, const TraceInfo& info,
                                             const Scene& scene, const std::shared_ptr<const World>& world,
                                             const FingerPath& motion, ContactStore* contacts) {
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
  Trace trace;
  try {
    if (check_seal(path) != Seal::whole) return std::nullopt;
    trace = read_trace(path);
  } catch (const Error&) {
    return std::nullopt;  // whatever stands there is no trace of ours: it is made again
  }
  if (!trace.complete || static_cast<long>(trace.rows.size()) != motion.tick_count() ||
      !same_run(trace.info, info))
    return std::nullopt;
  if (!tell_all(info, motion)) return run(scene, world, motion, info, {}, contacts).figures;
  if (!trace.rows.empty())
    trace.rows.front().started_inside = ClosedLoop(world, scene, motion).next().started_inside;
  Figures figures(world, scene.finger.radius_m);
  for (const TickRecord& row : trace.rows) figures.observe(row);
  return figures.values();
}

/// What is told, and kept in the summary.
void warn(JobResult& result, std::string words) {
  result.kept_warnings.push_back(words);
  result.warnings.push_back(std::move(words));
}

/// A recording whose unit was forgotten touches nothing, or presses far deeper than a finger can.
void warn_of_odd_depth(const Scene& scene, const World& world, const FingerPath& path, JobResult& result) {
  const std::string deep = pressed_too_deep(scene, Figures::of(result.figures, "max_depth_m"));
  if (!deep.empty()) warn(result, fmt::format("{}: {}", scene.name, deep));
  if (Figures::of(result.figures, "contact_ticks") > 0) return;
  const std::string words =
      never_touches(world, path, scene.finger.radius_m, !scene.motion.placement.is_world());
  if (!words.empty()) warn(result, fmt::format("{}: {}", scene.name, words));
}

/// What a finished run's figures tell of its recording.
void warn_of_run(const Scene& scene, const World& world, const FingerPath& path, const std::string& job_name,
                 JobResult& result) {
  warn_of_odd_depth(scene, world, path, result);
  if (const auto press = hard_press(scene, result.figures))  // told once for the batch
    result.kept_warnings.push_back(fmt::format("the normal force is up to {} N where {} N is asked for",
                                               rounded_text(press->felt_n, 3),
                                               rounded_text(press->asked_n, 3)));
  for (const std::string& words : residual_warnings(result.figures))
    result.warnings.push_back(fmt::format("{}: {}", job_name.empty() ? scene.name : job_name, words));
}

/// Told of each mesh that is larger than what meshes may take.
void warn_of_large_meshes(const Scene& scene, MeshStore& meshes, JobResult& result) {
  for (const PartEntry& part : scene.parts) {
    const std::size_t bytes = meshes.oversize(part);
    if (bytes == 0) continue;
    const int whole = bytes >> 20 > 0 ? 20 : 10;  // MiB, KiB
    result.warnings.push_back(
        fmt::format("{}: takes about {} in memory, more than --memory by itself; it is loaded all the same",
                    part.mesh, bytes_text(bytes >> whole << whole)));
  }
}

}  // namespace

JobResult run_job(const Scene& scene_as_written, MeshStore& meshes, MotionStore& motions,
                  const JobOutput& output, ContactStore* contacts) {
  refuse_missing_inputs(scene_as_written);
  const std::shared_ptr<const StoredMotion> stored = motions.load(scene_as_written, meshes);
  const LoadedMotion& motion = stored->motion;
  const FingerPath& path = motion.path;
  const Scene scene = at_rate(scene_as_written, path);
  const auto world = load_world(scene, meshes);
  TraceInfo info = trace_info(scene, *world, path, stored->hash, output.version);
  info.motion_notes = motion.notes;
  info.changes = motion.changes;
  choose(output.choice, info);
  JobResult result{{},           info.contact_method, info.contact_normals, info.contact_reasons,
                   motion.notes, motion.warnings,     motion.warnings};
  warn_of_large_meshes(scene, meshes, result);
  for (std::string& line : unit_hints(*world, scene)) warn(result, std::move(line));
  if (output.path.empty()) {
    result.figures = run(scene, world, path, info, output, contacts).figures;
    warn_of_run(scene, *world, path, output.name, result);
    return result;
  }
  const RunDigest digest = run_digest(info, output.format);
  if (output.resume) {
    auto figures = proven_figures(output.path, digest);
    // What a trace says of itself tells the program by its version alone; a proof knows better.
    const bool is_others = proves_another_run(output.path, digest);
    const bool counts = output.format == TraceFormat::hdf5 && is_countable(info, scene);
    if (!figures && !is_others && counts) {
      figures = recounted(output.path, info, scene, world, path, contacts);
      if (figures) write_proof(output.path, digest, *figures);
    }
    if (figures) {
      remove_unfinished(output.path);
      result.figures = *figures;
      result.kept = true;
      warn_of_run(scene, *world, path, output.name, result);
      return result;
    }
    result.made_again = why_not_kept(output.path, digest, info.scene_text, counts);
  }

  const RunEnd end = run(scene, world, path, info, output, contacts);
  result.figures = end.figures;
  warn_of_run(scene, *world, path, output.name, result);
  write_proof(output.path, digest, result.figures, end.trace);
  return result;
}

}  // namespace fingerpad
