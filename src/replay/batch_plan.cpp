#include "replay/batch_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <unordered_set>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/contact_store.hpp"
#include "replay/job_order.hpp"
#include "replay/job_try.hpp"
#include "replay/missing_inputs.hpp"
#include "replay/planned_ticks.hpp"
#include "replay/timed_meshes.hpp"

namespace fingerpad {
namespace {

/// Jobs that cost alike: the same parts, touched in the same way.
std::string kind_of(const Scene& scene) {
  return scene.contact.method + " " + std::to_string(static_cast<int>(scene.hand.has_value())) + "\n" +
         meshes_of(scene);
}

PlannedJob planned(const BatchJob& batch_job, const BatchOptions& options, TimedMeshes& meshes,
                   PlannedTicks& ticks) {
  const SceneJob& job = batch_job.job;
  PlannedJob plan{trace_name(job, options.format), "", job.scene.motion.file, "", 0, job.error};
  if (!job.scene.parts.empty()) plan.mesh = job.scene.parts.front().mesh;
  for (const auto& [key, value] : job.set_keys) {
    if (key == "mesh" || key == "motion") continue;
    plan.values += (plan.values.empty() ? "" : ", ") + key.substr(key.rfind('.') + 1) + " " + value;
  }
  if (!plan.error.empty()) return plan;
  try {
    refuse_missing_inputs(job.scene);
    if (job.scene.motion.laid && job.scene.motion.automatic_rate) meshes.load(job.scene);
    plan.ticks = ticks.of(job.scene, meshes.store());
  } catch (const Error& error) {
    plan.error = error.what();
  }
  return plan;
}

/// Places in `ours` from one mesh to the next, so that each is loaded once.
std::vector<std::size_t> by_meshes(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < ours.size(); ++k) groups[meshes_of(jobs[ours[k]].job.scene)].push_back(k);
  std::vector<std::size_t> order;
  for (const auto& [meshes, group] : groups) order.insert(order.end(), group.begin(), group.end());
  return order;
}

/// Of the files of a scene's meshes: by these loading takes longer and traces grow.
double mesh_bytes(const Scene& scene) {
  double bytes = 0;
  for (const PartEntry& part : scene.parts) {
    std::error_code none;
    const auto size = std::filesystem::file_size(part.mesh_path, none);
    if (!none) bytes += static_cast<double>(size);
  }
  return bytes;
}

struct KindsJob {
  const Scene* scene = nullptr;
  PlannedJob* plan = nullptr;
  std::uint64_t contact = 0;  ///< contact_number
};

struct JobKind {
  std::vector<KindsJob> jobs;
  double mesh_bytes = 0;
  JobCost cost = {};
  bool is_loaded = false, is_tried = false;
};

/// Kinds from the smallest mesh to the largest, those first that stand in even steps from end to end.
std::vector<JobKind*> in_order_of_trying(std::vector<JobKind*> kinds, std::size_t count) {
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const JobKind* a, const JobKind* b) { return a->mesh_bytes < b->mesh_bytes; });
  if (kinds.size() <= count) return kinds;
  std::vector<JobKind*> first, others;
  for (std::size_t i = 0, next = 0; i < kinds.size(); ++i) {
    const bool is_next = i == next * (kinds.size() - 1) / (count - 1);
    (is_next ? first : others).push_back(kinds[i]);
    if (is_next) ++next;
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// What the kinds that were tried cost, as a straight line over their meshes' bytes, at least none.
double on_line(const std::vector<const JobKind*>& tried, double JobCost::*what, double mesh_bytes) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (const JobKind* kind : tried) {
    mean_x += kind->mesh_bytes / static_cast<double>(tried.size());
    mean_y += kind->cost.*what / static_cast<double>(tried.size());
  }
  for (const JobKind* kind : tried) {
    xx += (kind->mesh_bytes - mean_x) * (kind->mesh_bytes - mean_x);
    xy += (kind->mesh_bytes - mean_x) * (kind->cost.*what - mean_y);
  }
  return std::max(0.0, mean_y + (xx > 0 ? xy / xx * (mesh_bytes - mean_x) : 0));
}

/// Loads a kind's meshes; where that fails all its jobs would fail.
bool load(JobKind& kind, TimedMeshes& meshes) {
  const Scene& scene = *kind.jobs.front().scene;
  try {
    meshes.load(scene);
    kind.is_loaded = true;
  } catch (const Error& error) {
    for (const KindsJob& job : kind.jobs) job.plan->error = error.what();
  }
  kind.cost.load_s = meshes.take_load_s(scene);
  return kind.is_loaded;
}

/// Sees which of a kind's jobs have a motion that cannot be laid.
void lay(const JobKind& kind, MeshStore& meshes, PlannedTicks& ticks, BatchPlan& plan) {
  for (const KindsJob& job : kind.jobs) {
    if (!job.plan->error.empty() || !PlannedTicks::is_reckoned(*job.scene)) continue;
    try {
      const std::optional<long> laid = kind.is_loaded ? ticks.laid(*job.scene, meshes) : std::nullopt;
      if (laid) job.plan->ticks = *laid;
      if (!laid) ++plan.not_laid;
    } catch (const Error& error) {
      job.plan->error = error.what();
    }
  }
}

/// Tries a kind's jobs until one does not fail.
void try_jobs(JobKind& kind, MeshStore& meshes, MotionStore& motions, const BatchOptions& options) {
  std::unordered_set<std::uint64_t> contacts;
  for (const KindsJob& job : kind.jobs) contacts.insert(job.contact);
  const bool is_shared = contacts.size() < kind.jobs.size();
  int most_failing = 64;
  for (const KindsJob& job : kind.jobs) {
    if (!job.plan->error.empty()) continue;
    try {
      const double load_s = kind.cost.load_s;
      kind.cost = try_job(*job.scene, meshes, motions, options, is_shared);
      kind.cost.load_s += load_s;
      kind.is_tried = true;
      return;
    } catch (const Error& error) {
      job.plan->error = error.what();
    }
    if (--most_failing == 0) return;
  }
}

/// Tries some of the kinds, and reckons what the others cost: a tick what it does on average, the rest by
/// their meshes.
void measure(const std::vector<JobKind*>& kinds, const BatchOptions& options, TimedMeshes& meshes,
             PlannedTicks& ticks, BatchPlan& plan) {
  constexpr std::size_t most_tried = 8;
  MotionStore motions(std::size_t{256} << 20);
  std::vector<const JobKind*> tried_kinds;
  for (JobKind* kind : in_order_of_trying(kinds, most_tried)) {
    const bool is_next = tried_kinds.size() < most_tried;
    if (is_next && !load(*kind, meshes)) continue;
    lay(*kind, meshes.store(), ticks, plan);
    if (is_next) try_jobs(*kind, meshes.store(), motions, options);
    if (kind->is_tried) tried_kinds.push_back(kind);
    if (plan.bytes_unknown.empty()) plan.bytes_unknown = kind->cost.unwritten;
  }
  plan.kinds = static_cast<int>(kinds.size());
  plan.measured = static_cast<int>(tried_kinds.size());
  for (JobKind* kind : kinds) {
    const bool has_jobs =
        std::ranges::any_of(kind->jobs, [](const KindsJob& job) { return job.plan->error.empty(); });
    if (kind->is_tried || !has_jobs) continue;
    for (double JobCost::*const what : {&JobCost::load_s, &JobCost::s_a_job, &JobCost::bytes})
      kind->cost.*what = on_line(tried_kinds, what, kind->mesh_bytes);
    for (double JobCost::*const what :
         {&JobCost::s_per_tick, &JobCost::s_per_played_tick, &JobCost::bytes_per_tick})
      for (const JobKind* other : tried_kinds)
        kind->cost.*what += other->cost.*what / static_cast<double>(tried_kinds.size());
  }
}

}  // namespace

BatchPlan plan_batch(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  BatchPlan plan;
  PlannedTicks ticks;
  TimedMeshes meshes(8, options.on_load);
  const std::vector<std::size_t> ours = jobs_of_shard(jobs.size(), options);
  plan.jobs.resize(ours.size());
  for (const std::size_t k : by_meshes(jobs, ours))
    plan.jobs[k] = planned(jobs[ours[k]], options, meshes, ticks);
  std::map<std::string, JobKind> kinds;
  std::vector<JobKind*> in_order;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    if (!plan.jobs[k].error.empty()) continue;
    const Scene& scene = jobs[ours[k]].job.scene;
    const auto [entry, is_new] = kinds.try_emplace(kind_of(scene), JobKind{{}, mesh_bytes(scene)});
    if (is_new) in_order.push_back(&entry->second);
    entry->second.jobs.push_back({&scene, &plan.jobs[k], contact_number(jobs[ours[k]].job)});
  }
  plan.warnings = ticks.warnings();
  measure(in_order, options, meshes, ticks, plan);
  double work_s = 0;
  double longest_s = 0;  // of what no second thread shortens
  for (const JobKind* kind : in_order) {
    const JobCost& cost = kind->cost;
    work_s += cost.load_s;
    std::unordered_set<std::uint64_t> touched;  // by the jobs before
    for (const KindsJob& job : kind->jobs) {
      if (!job.plan->error.empty()) continue;
      const auto job_ticks = static_cast<double>(job.plan->ticks);
      plan.ticks += job_ticks;
      const bool plays = cost.may_play && !touched.insert(job.contact).second &&
                         job_ticks * contact_bytes_a_tick < static_cast<double>(most_contact_bytes);
      const double job_s = cost.s_a_job + job_ticks * (plays ? cost.s_per_played_tick : cost.s_per_tick);
      work_s += job_s;
      longest_s = std::max(longest_s, cost.load_s + job_s);
      plan.bytes += cost.bytes + job_ticks * cost.bytes_per_tick;
    }
  }
  plan.seconds = std::max(longest_s, work_s / options.threads);
  return plan;
}

}  // namespace fingerpad
