#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "replay/job_order.hpp"
#include "replay/locked_file.hpp"

namespace fingerpad {

/// The jobs of a run that ranks share, in a file that they all see: in which order they are begun, and how
/// far each group has been handed out. It is read and changed under a lock of the kernel's, which a rank that
/// dies lets go of.
class JobBoard {
 public:
  /// Throws Error (fault) where it cannot be written.
  /// @param batch  a hash of what the jobs are: ranks that have read another batch are refused
  static void create(const std::string& path, const JobOrder& order, std::uint64_t batch);

  /// Throws Error (refused) where the file is no board of that batch.
  JobBoard(const std::string& path, std::uint64_t batch);

  /// Some jobs that nobody has had yet; none when all are handed out. Those of the group that this rank had
  /// last, else of one that nobody has begun, else of that with most left. Of a group that has many left
  /// several at a time, so that the file is not asked for each.
  /// @param ranks       that share what is left
  /// @param done_since  jobs that this rank has ended since it last asked
  std::vector<std::size_t> claim(int ranks, std::size_t done_since);

  /// Jobs that all ranks have ended, by what they said when they last asked.
  std::size_t done_count() const noexcept { return done_; }

  /// The jobs in the order in which they are begun.
  const std::vector<std::uint32_t>& jobs() const noexcept { return order_.jobs; }

  /// Held while ranks come, and while whoever leaves looks who else is there.
  class Hold {
   public:
    /// Waits for it. Throws Error (fault) where the file cannot be locked.
    explicit Hold(const JobBoard& board);
    /// Without waiting; none where another holds it.
    static std::unique_ptr<Hold> at_once(const JobBoard& board);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    explicit Hold(int file) noexcept : file_(file) {}

    int file_;
  };

 private:
  std::uint64_t read_number(std::uint64_t place) const;
  void write_number(std::uint64_t place, std::uint64_t value) const;
  std::size_t most_left() const;

  std::string path_;
  OpenFile file_;
  JobOrder order_;
  std::size_t group_ = SIZE_MAX;  ///< that this rank had last
  std::size_t done_ = 0;
};

}  // namespace fingerpad
