#include "replay/job_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/content_hash.hpp"

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
  std::size_t job = 0, group = 0, contact = 0;
  double mesh_bytes = 0, motion_bytes = 0;
};

std::vector<PricedJob> priced(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  FileSizes sizes;
  std::map<std::string, std::size_t> groups;  // by first appearance
  std::unordered_map<std::uint64_t, std::size_t> contacts;
  std::vector<PricedJob> all;
  all.reserve(ours.size());
  for (const std::size_t i : ours) {
    const Scene& scene = jobs[i].job.scene;
    PricedJob& job = all.emplace_back();
    job.job = i;
    job.group = groups.try_emplace(meshes_of(scene), groups.size()).first->second;
    job.contact = contacts.try_emplace(contact_number(jobs[i].job), contacts.size()).first->second;
    for (const PartEntry& part : scene.parts) job.mesh_bytes += sizes.of(part.mesh_path);
    job.motion_bytes = sizes.of(scene.motion.file_path);
  }
  return all;
}

/// Puts so many rows of jobs of one contact side by side, each job as long as the others: while the first of
/// a row is under way no other thread begins the second.
void lay_side_by_side(std::span<PricedJob> jobs, std::size_t rows) {
  std::vector<std::size_t> begins;
  for (std::size_t k = 0; k < jobs.size(); ++k)
    if (k == 0 || jobs[k].contact != jobs[k - 1].contact) begins.push_back(k);
  begins.push_back(jobs.size());
  std::vector<PricedJob> laid;
  laid.reserve(jobs.size());
  for (std::size_t first = 0; first + 1 < begins.size(); first += rows) {
    const std::size_t end = std::min(first + rows, begins.size() - 1);
    for (std::size_t k = 0, before = SIZE_MAX; laid.size() != before; ++k) {
      before = laid.size();
      for (std::size_t row = first; row < end; ++row)
        if (begins[row] + k < begins[row + 1]) laid.push_back(jobs[begins[row] + k]);
    }
  }
  std::ranges::copy(laid, jobs.begin());
}

}  // namespace

std::uint64_t contact_number(const SceneJob& job) {
  const auto has_no_part = [](std::string_view key) {
    constexpr std::array<std::string_view, 4> of_surfaces{"mu_static", "mu_dynamic", "stiffness_n_per_m",
                                                          "damping_n_s_per_m"};
    return key == "seed" || key.starts_with("friction.") ||
           std::ranges::find(of_surfaces, key.substr(key.rfind('.') + 1)) != of_surfaces.end();
  };
  const auto mixed = [](const std::string& word, std::uint64_t hash) {
    return content_hash(std::as_bytes(std::span(word.c_str(), word.size() + 1)), hash);
  };
  std::uint64_t hash = mixed(job.scene.path, content_hash({}));
  for (const auto& [key, value] : job.set_keys) {
    if (has_no_part(key)) continue;
    hash = mixed(value, mixed(key, hash));
  }
  return hash;
}

std::unordered_set<std::uint64_t> contacts_of_several(const std::vector<BatchJob>& jobs) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(jobs.size());
  for (const BatchJob& job : jobs) numbers.push_back(contact_number(job.job));
  std::ranges::sort(numbers);
  std::unordered_set<std::uint64_t> several;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (numbers[i] == numbers[i - 1]) several.insert(numbers[i]);
  return several;
}

std::string meshes_of(const Scene& scene) {
  std::string text;
  for (const PartEntry& part : scene.parts) {
    text += fmt::format("{}\n{} {} {}\n", part.mesh_path, part.metres_per_unit, part.crease_deg,
                        static_cast<int>(part.repair));
  }
  return text;
}

JobOrder order_by_cost(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours,
                       std::size_t at_a_time) {
  std::vector<PricedJob> all = priced(jobs, ours);
  std::stable_sort(all.begin(), all.end(), [](const PricedJob& a, const PricedJob& b) {
    if (a.mesh_bytes != b.mesh_bytes) return a.mesh_bytes > b.mesh_bytes;
    if (a.group != b.group) return a.group < b.group;
    if (a.motion_bytes != b.motion_bytes) return a.motion_bytes > b.motion_bytes;
    return a.contact < b.contact;
  });
  for (auto first = all.begin(); first != all.end();) {
    const auto end = std::find_if(first, all.end(), [&](const PricedJob& job) {
      return job.group != first->group || job.motion_bytes != first->motion_bytes;
    });
    lay_side_by_side({first, end}, at_a_time);
    first = end;
  }
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
