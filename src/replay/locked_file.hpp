#pragma once

#include <string>
#include <utility>

namespace fingerpad {

/// An open file, closed at its end; the kernel's locks on it go with it, or with the last of several
/// processes that have it open together.
class OpenFile {
 public:
  explicit OpenFile(int file = -1) : file_(file) {}
  OpenFile(OpenFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~OpenFile();
  int number() const noexcept { return file_; }

 private:
  int file_;
};

enum class Locking { got, busy, impossible };

/// flock() without waiting. `impossible`: the file system has no locks.
Locking try_lock(int file, int how) noexcept;

/// flock() that waits. False where the file system has no locks.
bool wait_for_lock(int file, int how) noexcept;

void unlock(int file) noexcept;

/// Whether the open file is still the one at that path.
bool is_at(int file, const std::string& path) noexcept;

/// This machine's name, by which others tell who holds a file; "?" where it has none.
std::string host_name();

/// Writes all of it at the file's place, or at its end if it was opened to append. False where the disk
/// refuses.
bool write_all(int file, const char* bytes, std::size_t count) noexcept;

}  // namespace fingerpad
