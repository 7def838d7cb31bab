#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// The processes that share a batch under mpirun; one process alone without MPI, without mpirun, or in a
/// build with FINGERPAD_MPI=OFF. MPI is started on construction only where a launcher has set up ranks, and
/// ended on destruction.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const noexcept { return rank_; }
  int count() const noexcept { return count_; }
  bool is_root() const noexcept { return rank_ == 0; }

  /// Every rank's text, in rank order, on the root; empty elsewhere. All ranks must call it.
  std::vector<std::string> gather(const std::string& text) const;
  /// The root's text, on every rank; the others' own is not read. All ranks must call it.
  std::string broadcast(std::string text) const;

 private:
  int rank_ = 0;
  int count_ = 1;
};

/// What MPI calls itself, as "Open MPI v4.1.4"; empty in a build without it.
std::string mpi_version();

}  // namespace fingerpad
