#include "replay/batch_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/job_try.hpp"
#include "replay/missing_inputs.hpp"
#include "replay/planned_ticks.hpp"

namespace fingerpad {
namespace {

/// Jobs that cost alike: the same parts, touched in the same way.
std::string kind_of(const Scene& scene) {
  std::string kind = scene.contact.method + " " + std::to_string(static_cast<int>(scene.hand.has_value()));
  for (const PartEntry& part : scene.parts) kind += "\n" + part.mesh_path;
  return kind;
}

PlannedJob planned(const BatchJob& batch_job, const BatchOptions& options, PlannedTicks& ticks) {
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
    plan.ticks = ticks.of(job.scene);
  } catch (const Error& error) {
    plan.error = error.what();
  }
  return plan;
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

struct Kind {
  const Scene* scene = nullptr;  ///< of its first job
  double mesh_bytes = 0;
  JobCost cost = {};
  bool is_tried = false;
  std::string error = {};  ///< why it cannot be tried: its jobs fail
};

/// Kinds from the smallest mesh to the largest, those first that stand in even steps from end to end.
std::vector<Kind*> in_order_of_trying(std::vector<Kind*> kinds, std::size_t count) {
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const Kind* a, const Kind* b) { return a->mesh_bytes < b->mesh_bytes; });
  if (kinds.size() <= count) return kinds;
  std::vector<Kind*> first, others;
  for (std::size_t i = 0, next = 0; i < kinds.size(); ++i) {
    const bool is_next = i == next * (kinds.size() - 1) / (count - 1);
    (is_next ? first : others).push_back(kinds[i]);
    if (is_next) ++next;
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// What the kinds that were tried cost, as a straight line over their meshes' bytes, at least none.
double on_line(const std::vector<const Kind*>& tried, double JobCost::*what, double mesh_bytes) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (const Kind* kind : tried) {
    mean_x += kind->mesh_bytes / static_cast<double>(tried.size());
    mean_y += kind->cost.*what / static_cast<double>(tried.size());
  }
  for (const Kind* kind : tried) {
    xx += (kind->mesh_bytes - mean_x) * (kind->mesh_bytes - mean_x);
    xy += (kind->mesh_bytes - mean_x) * (kind->cost.*what - mean_y);
  }
  return std::max(0.0, mean_y + (xx > 0 ? xy / xx * (mesh_bytes - mean_x) : 0));
}

/// Tries some of the kinds, and reckons what the others cost: a tick what it does on average, the rest by
/// their meshes.
void measure(const std::vector<Kind*>& kinds, const BatchOptions& options, BatchPlan& plan) {
  constexpr std::size_t most_tried = 8;
  MeshStore meshes(8, options.on_load);
  MotionStore motions(std::size_t{256} << 20);
  std::vector<const Kind*> tried_kinds;
  for (Kind* kind : in_order_of_trying(kinds, most_tried)) {
    if (tried_kinds.size() == most_tried) break;
    const auto start = std::chrono::steady_clock::now();
    try {
      kind->cost = try_job(*kind->scene, meshes, motions, options);
      kind->is_tried = true;
      tried_kinds.push_back(kind);
    } catch (const Error& error) {
      kind->error = error.what();
      // Its mesh is loaded in vain, and a rub's places looked for.
      kind->cost.load_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  }
  plan.kinds = static_cast<int>(kinds.size());
  plan.measured = static_cast<int>(tried_kinds.size());
  for (Kind* kind : kinds) {
    if (kind->is_tried || !kind->error.empty()) continue;
    for (double JobCost::*const what : {&JobCost::load_s, &JobCost::s_a_job, &JobCost::bytes})
      kind->cost.*what = on_line(tried_kinds, what, kind->mesh_bytes);
    for (double JobCost::*const what : {&JobCost::s_per_tick, &JobCost::bytes_per_tick})
      for (const Kind* other : tried_kinds)
        kind->cost.*what += other->cost.*what / static_cast<double>(tried_kinds.size());
  }
}

}  // namespace

BatchPlan plan_batch(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  BatchPlan plan;
  PlannedTicks ticks;
  std::map<std::string, Kind> kinds;
  std::vector<Kind*> in_order, of_jobs;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!is_of_shard(i, options)) continue;
    plan.jobs.push_back(planned(jobs[i], options, ticks));
    of_jobs.push_back(nullptr);
    if (!plan.jobs.back().error.empty()) continue;
    const Scene& scene = jobs[i].job.scene;
    const auto [entry, is_new] = kinds.try_emplace(kind_of(scene), Kind{&scene, mesh_bytes(scene)});
    if (is_new) in_order.push_back(&entry->second);
    of_jobs.back() = &entry->second;
  }
  plan.warnings = ticks.warnings();
  measure(in_order, options, plan);
  double work_s = 0;
  for (const Kind* kind : in_order) work_s += kind->cost.load_s;
  double longest_s = 0;  // of what no second thread shortens
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    if (of_jobs[i] == nullptr) continue;
    PlannedJob& job = plan.jobs[i];
    job.error = of_jobs[i]->error;
    if (!job.error.empty()) continue;
    const JobCost& cost = of_jobs[i]->cost;
    const auto job_ticks = static_cast<double>(job.ticks);
    plan.ticks += job_ticks;
    const double job_s = cost.s_a_job + job_ticks * cost.s_per_tick;
    work_s += job_s;
    longest_s = std::max(longest_s, cost.load_s + job_s);
    plan.bytes += cost.bytes + job_ticks * cost.bytes_per_tick;
  }
  plan.seconds = std::max(longest_s, work_s / options.threads);
  return plan;
}

}  // namespace fingerpad
