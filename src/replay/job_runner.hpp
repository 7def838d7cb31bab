#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "replay/batch.hpp"
#include "replay/contact_store.hpp"
#include "replay/motion_store.hpp"
#include "touch/mesh_store.hpp"

namespace fingerpad {

/// Carries out jobs on a batch's threads, with the meshes and motions that they share.
class JobRunner {
 public:
  /// What a thread (by its number, from 0) is to do next; nothing when there is nothing more.
  using NextJob = std::function<std::optional<std::size_t>(std::size_t thread)>;
  /// Told of each job that has ended, one call at a time.
  using OnEnd = std::function<void(std::size_t job)>;

  JobRunner(std::vector<BatchJob>& jobs, const BatchOptions& options);

  /// The meshes of these jobs are kept until the last of them.
  void expect(const std::vector<std::size_t>& jobs);
  /// The meshes of the last job so announced are kept until another's are, or none.
  void hold(std::optional<std::size_t> job);
  /// Whether BatchOptions::memory_bytes has room for one more mesh beside those in use.
  bool has_room_for_a_mesh() { return meshes_.has_room_for_another(); }
  /// How many jobs have played where another touched.
  long played_contacts() const { return contacts_.played_count(); }
  /// Runs jobs until there are none. Those that fail say so in their status; what the two functions throw is
  /// thrown.
  void run(const NextJob& next, const OnEnd& on_end);

 private:
  void run_one(std::size_t job);

  std::vector<BatchJob>& jobs_;
  const BatchOptions& options_;
  MeshStore meshes_;
  MotionStore motions_;
  ContactStore contacts_;
  std::unordered_set<std::uint64_t> shared_contacts_;  ///< contact_number of more than one job
  std::optional<std::size_t> held_;
};

}  // namespace fingerpad
