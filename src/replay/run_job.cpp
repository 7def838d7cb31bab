#include "replay/run_job.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "replay/run_proof.hpp"
#include "touch/closed_loop.hpp"
#include "trace/file_seal.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

bool same_run(const TraceInfo& a, const TraceInfo& b) {
  return run_digest(a, TraceFormat::hdf5) == run_digest(b, TraceFormat::hdf5);
}

/// The figures of a whole HDF5 trace of this very run, counted again from its rows.
std::optional<std::vector<double>> recounted(const std::string& path, const TraceInfo& info,
                                             const Scene& scene, const std::shared_ptr<const World>& world,
                                             const FingerPath& motion) {
  if (!std::filesystem::is_regular_file(path) || scene.friction.settings.remedy != Remedy::none)
    return std::nullopt;
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
  if (!trace.rows.empty())
    trace.rows.front().started_inside = ClosedLoop(world, scene, motion).next().started_inside;
  Figures figures(world);
  for (const TickRecord& row : trace.rows) figures.observe(row);
  return figures.values();
}

}  // namespace

JobResult run_job(const Scene& scene, MeshStore& meshes, const JobOutput& output) {
  FingerPath path = load_finger_path(scene);
  const auto world = load_world(scene, meshes);
  const TraceInfo info = trace_info(scene, *world, path, output.version);
  JobResult result{{}, info.contact_method, info.contact_normals, info.contact_reasons};
  const std::string digest = run_digest(info, output.format);
  if (output.resume) {
    auto figures = proven_figures(output.path, digest);
    // What a trace says of itself tells the program by its version alone; a proof knows better.
    const bool is_others = proves_another_run(output.path, digest);
    if (!figures && !is_others && output.format == TraceFormat::hdf5) {
      figures = recounted(output.path, info, scene, world, path);
      if (figures) write_proof(output.path, digest, *figures);
    }
    if (figures) {
      remove_unfinished(output.path);
      result.figures = *figures;
      result.kept = true;
      return result;
    }
  }

  Figures figures(world);
  ClosedLoop loop(world, scene, std::move(path));
  const auto writer = TraceWriter::create(output.path, output.format, info, *world);
  constexpr long block_ticks = 4096;
  std::vector<TickRecord> block;
  block.reserve(block_ticks);
  for (long first = 0; first < loop.tick_count(); first += block_ticks) {
    block.clear();
    for (long k = first; k < std::min(first + block_ticks, loop.tick_count()) && !loop.has_diverged(); ++k) {
      block.push_back(loop.next());
      figures.observe(block.back());
    }
    writer->append(block);
    if (output.on_ticks)
      output.on_ticks(static_cast<double>(first + static_cast<long>(block.size())) /
                      static_cast<double>(loop.tick_count()));
    if (!loop.has_diverged()) continue;
    writer->flush();  // what there was until then stays behind
    throw refused(scene.path, loop.divergence());
  }
  writer->finish();
  result.figures = figures.values();
  write_proof(output.path, digest, result.figures);
  return result;
}

}  // namespace fingerpad
