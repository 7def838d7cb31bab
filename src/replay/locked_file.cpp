#include "replay/locked_file.hpp"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace fingerpad {

OpenFile::~OpenFile() {
  if (file_ >= 0) close(file_);
}

Locking try_lock(int file, int how) noexcept {
  while (flock(file, how | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    return errno == EWOULDBLOCK ? Locking::busy : Locking::impossible;
  }
  return Locking::got;
}

bool wait_for_lock(int file, int how) noexcept {
  while (flock(file, how) != 0) {
    if (errno != EINTR) return false;
  }
  return true;
}

void unlock(int file) noexcept {
  flock(file, LOCK_UN);
}

bool is_at(int file, const std::string& path) noexcept {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof(name) - 1) == 0 ? name : "?";
}

bool write_all(int file, const char* bytes, std::size_t count) noexcept {
  for (std::size_t done = 0; done < count;) {
    const ssize_t written = write(file, bytes + done, count - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace fingerpad
