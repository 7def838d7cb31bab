#pragma once

#include <atomic>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>

#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "part/load_progress.hpp"
#include "part/verdict.hpp"
#include "scene/scene.hpp"
#include "touch/choice_memory.hpp"

namespace fingerpad {

/// A mesh file, loaded and ready to be searched.
struct LoadedMesh {
  std::shared_ptr<const Part> part;
  std::shared_ptr<const TriangleTree> tree;
  Verdict verdict;
  std::string hash;
  std::size_t bytes = 0;  ///< of memory, about
};

/// Loads each mesh once, however many jobs ask for it at the same time, and keeps those used last: a few, or
/// as many as a bound on memory has room for. Those that are announced go after their last use. Thread-safe.
class MeshStore {
 public:
  /// @param keep      how many meshes stay loaded when nobody uses them, >= 1
  /// @param progress  told of each mesh as it is loaded and measured, as "FILE: STAGE" with the share of that
  ///                  mesh's own load; by whichever thread loads, so perhaps by several at a time
  explicit MeshStore(std::size_t keep, LoadProgress progress = {})
      : keep_(keep), progress_(std::move(progress)) {}

  /// From now on as many meshes are kept as fit into so many bytes, beside those that are in use.
  void bound_memory(std::size_t most_bytes);
  /// Whether a mesh as large as the largest so far would stay within that bound beside those that are kept or
  /// being loaded. No while none is known.
  bool has_room_for_another();
  /// Announces one use of a mesh, which ends with `done`: after the last its place is given up.
  void expect(const PartEntry& entry);
  void done(const PartEntry& entry);
  /// How many bytes a mesh takes that is larger than the bound all by itself; 0 where it is not.
  std::size_t oversize(const PartEntry& entry);

  /// Throws Error (refused) for a mesh that cannot be touched, to everyone who asks.
  std::shared_ptr<const LoadedMesh> load(const PartEntry& entry);

  /// What `mesh`, as loaded for `entry`, measures: made once for each content of a file (with its unit,
  /// crease and repair), when first asked for, and kept for as long as the store.
  PartMeasures measure(const PartEntry& entry, const LoadedMesh& mesh);
  /// How many parts were measured so far.
  long measured_count() const noexcept { return measured_count_; }

  /// How the parts were to be touched, kept for as long as the store.
  ChoiceMemory& choices() noexcept { return choices_; }

  /// How many meshes are loaded and kept.
  std::size_t kept_count();

 private:
  using Key =
      std::tuple<std::string, double, double, bool>;  // path, metres per unit, crease in degrees, repair
  using Pending = std::shared_future<std::shared_ptr<const LoadedMesh>>;
  /// Measured once by whoever comes first; the others wait at the flag.
  struct Measured {
    std::once_flag once;
    PartMeasures measures;
  };

  static Key key_of(const PartEntry& entry);
  // With the lock held:
  void drop(const Key& key);
  void drop_beyond_bounds();

  std::size_t keep_, most_bytes_ = 0, bytes_ = 0;  // no bound where most_bytes_ is 0
  std::size_t largest_bytes_ = 0, loading_ = 0;  // of a mesh so far (0: none is known); how many are loading
  std::map<Key, std::size_t> sizes_;             // of those that are loaded and kept
  std::map<Key, std::size_t> large_;             // by themselves beyond the bound
  std::map<Key, long> uses_left_;
  LoadProgress progress_;
  std::mutex mutex_;
  std::map<Key, Pending> meshes_;
  std::deque<Key> last_used_;                          // newest in front
  std::map<Key, std::shared_ptr<Measured>> measured_;  // by the file's hash in place of its path
  std::atomic<long> measured_count_{0};
  ChoiceMemory choices_;
};

}  // namespace fingerpad
