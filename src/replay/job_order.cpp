#include "replay/job_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

namespace fingerpad {
namespace {

/// Sizes of files in bytes, 0 of those that cannot be seen.
class FileSizes {
 public:
  double of(const std::string& path) {
    if (path.empty()) return 0;
    const auto [entry, is_new] = sizes_.try_emplace(path, 0.0);
    std::error_code none;
    const auto size = is_new ? std::filesystem::file_size(path, none) : 0;
    if (is_new && !none) entry->second = static_cast<double>(size);
    return entry->second;
  }

 private:
  std::map<std::string, double> sizes_;
};

struct PricedJob {
  std::size_t job = 0, group = 0;
  double mesh_bytes = 0, motion_bytes = 0;
};

std::vector<PricedJob> priced(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  FileSizes sizes;
  std::map<std::string, std::size_t> groups;  // by first appearance
  std::vector<PricedJob> all;
  all.reserve(ours.size());
  for (const std::size_t i : ours) {
    const Scene& scene = jobs[i].job.scene;
    PricedJob& job = all.emplace_back();
    job.job = i;
    job.group = groups.try_emplace(meshes_of(scene), groups.size()).first->second;
    for (const PartEntry& part : scene.parts) job.mesh_bytes += sizes.of(part.mesh_path);
    job.motion_bytes = sizes.of(scene.motion.file_path);
  }
  return all;
}

}  // namespace

std::string meshes_of(const Scene& scene) {
  std::string text;
  for (const PartEntry& part : scene.parts) {
    text += fmt::format("{}\n{} {} {}\n", part.mesh_path, part.metres_per_unit, part.crease_deg,
                        static_cast<int>(part.repair));
  }
  return text;
}

JobOrder order_by_cost(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  std::vector<PricedJob> all = priced(jobs, ours);
  std::stable_sort(all.begin(), all.end(), [](const PricedJob& a, const PricedJob& b) {
    if (a.mesh_bytes != b.mesh_bytes) return a.mesh_bytes > b.mesh_bytes;
    if (a.group != b.group) return a.group < b.group;
    return a.motion_bytes > b.motion_bytes;
  });
  JobOrder order;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == 0 || all[k].group != all[k - 1].group) order.groups.push_back({k, k, 0});
    JobGroup& group = order.groups.back();
    group.end = k + 1;
    constexpr double least_bytes = 1;  // of a motion without a file
    group.cost_each += std::max(all[k].motion_bytes, least_bytes);
    order.jobs.push_back(static_cast<std::uint32_t>(all[k].job));
  }
  for (JobGroup& group : order.groups) group.cost_each /= static_cast<double>(group.end - group.first);
  return order;
}

}  // namespace fingerpad
