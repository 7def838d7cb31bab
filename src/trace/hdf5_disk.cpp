// How HDF5 reaches the disk while a trace is written.
//
// HDF5 1.10 cannot close a file whose last writes failed: it leaves the file half closed and crashes when the
// library ends, at exit or in MPI_Finalize. So a trace is written through a driver that never refuses: it
// keeps the first errno, drops what comes after, and the writer asks for that errno after each flush
// (`write_failure`). What a flush writes it holds back, and writes in an order of its own (HeldWrites).
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "trace/hdf5_internal.hpp"
#include "trace/held_writes.hpp"

namespace fingerpad::hdf5 {
namespace {

struct Disk {
  H5FD_t base{};  // first: HDF5 knows a Disk by it
  int file = -1;
  int failure = 0;       // errno of the first write that failed
  haddr_t eoa = 0;       // end of what HDF5 has allotted
  haddr_t eof = 0;       // end of the file
  haddr_t length = 0;    // of the file as it is, without what is held
  haddr_t new_from = 0;  // all before it was there when what was held last had been written
  bool holds = false;
  HeldWrites held;  // while it holds
  struct stat identity {};
};

// errno of the last open and of the last close; read and written in turns.
int open_failure = 0, close_failure = 0;

Disk& disk_of(H5FD_t* file) {
  return *reinterpret_cast<Disk*>(file);
}
const Disk& disk_of(const H5FD_t* file) {
  return *reinterpret_cast<const Disk*>(file);
}

/// Null where the file is not open.
Disk* disk_of(const Handle& file) noexcept {
  void* disk = nullptr;
  return H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &disk) < 0 ? nullptr : static_cast<Disk*>(disk);
}

H5FD_t* disk_open(const char* name, unsigned flags, hid_t, haddr_t) {
  int how = (flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY;
  if ((flags & H5F_ACC_TRUNC) != 0) how |= O_TRUNC;
  if ((flags & H5F_ACC_CREAT) != 0) how |= O_CREAT;
  if ((flags & H5F_ACC_EXCL) != 0) how |= O_EXCL;
  const int file = ::open(name, how | O_CLOEXEC, 0666);
  if (file < 0) {
    open_failure = errno;
    return nullptr;
  }
  auto* disk = new Disk;
  disk->file = file;
  if (fstat(file, &disk->identity) == 0)
    disk->eof = disk->length = static_cast<haddr_t>(disk->identity.st_size);
  return &disk->base;
}

herr_t disk_close(H5FD_t* file) {
  const Disk& disk = disk_of(file);
  const bool closed = ::close(disk.file) == 0;  // some file systems tell only here that there was no room
  close_failure = disk.failure != 0 || closed ? disk.failure : errno;
  delete &disk;
  return 0;
}

int disk_compare(const H5FD_t* a, const H5FD_t* b) {
  const struct stat& x = disk_of(a).identity;
  const struct stat& y = disk_of(b).identity;
  if (x.st_dev != y.st_dev) return x.st_dev < y.st_dev ? -1 : 1;
  if (x.st_ino != y.st_ino) return x.st_ino < y.st_ino ? -1 : 1;
  return 0;
}

herr_t disk_query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t disk_eoa(const H5FD_t* file, H5FD_mem_t) {
  return disk_of(file).eoa;
}

herr_t disk_set_eoa(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  disk_of(file).eoa = end;
  return 0;
}

haddr_t disk_eof(const H5FD_t* file, H5FD_mem_t) {
  return disk_of(file).eof;
}

herr_t disk_itself(H5FD_t* file, hid_t, void** out) {
  *out = &disk_of(file);
  return 0;
}

void write_now(Disk& disk, haddr_t at, std::size_t size, const void* from) noexcept {
  const auto* bytes = static_cast<const char*>(from);
  while (size > 0 && disk.failure == 0) {
    const ssize_t count = pwrite(disk.file, bytes, size, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      disk.failure = count < 0 ? errno : ENOSPC;
      break;
    }
    bytes += count;
    at += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  disk.length = std::max(disk.length, at);
}

void set_length(Disk& disk, haddr_t length) noexcept {
  if (disk.failure == 0 && ftruncate(disk.file, static_cast<off_t>(length)) != 0) disk.failure = errno;
  disk.length = length;
}

void release(Disk& disk) noexcept {
  // The file is to be as long as it will say that it is.
  if (disk.length < disk.eof) set_length(disk, disk.eof);
  disk.held.release(disk.new_from, [&disk](std::uint64_t at, std::span<const std::byte> bytes) {
    write_now(disk, at, bytes.size(), bytes.data());
  });
}

herr_t disk_read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* out) {
  if (disk_of(file).holds) release(disk_of(file));
  auto* bytes = static_cast<char*>(out);
  while (size > 0) {
    const ssize_t count = pread(disk_of(file).file, bytes, size, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;  // beyond the end of the file all is zero
    bytes += count;
    at += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  std::memset(bytes, 0, size);
  return 0;
}

thread_local LateBytes* late_bytes = nullptr;

/// Whether that could be done.
bool holds_back(Disk& disk, haddr_t at, std::span<const std::byte> bytes) noexcept {
  if (disk.held.hold(at, bytes)) return true;
  release(disk);
  return disk.held.hold(at, bytes);
}

herr_t disk_write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* from) {
  Disk& disk = disk_of(file);
  const bool is_late = late_bytes != nullptr && late_bytes->notes(file, at, size, from);
  if (!is_late && !(disk.holds && holds_back(disk, at, {static_cast<const std::byte*>(from), size})))
    write_now(disk, at, size, from);
  disk.eof = std::max(disk.eof, at + size);
  return 0;
}

herr_t disk_truncate(H5FD_t* file, hid_t, hbool_t) {
  Disk& disk = disk_of(file);
  if (disk.eoa == disk.eof) return 0;
  set_length(disk, disk.eoa);
  disk.eof = disk.eoa;
  return 0;
}

H5FD_class_t disk_class() {
  H5FD_class_t driver{};
  driver.name = "fingerpad";
  driver.maxaddr = (haddr_t{1} << 62) - 1;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.open = disk_open;
  driver.close = disk_close;
  driver.cmp = disk_compare;
  driver.query = disk_query;
  driver.get_eoa = disk_eoa;
  driver.set_eoa = disk_set_eoa;
  driver.get_eof = disk_eof;
  driver.get_handle = disk_itself;
  driver.read = disk_read;
  driver.write = disk_write;
  driver.truncate = disk_truncate;
  const H5FD_mem_t places[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(places), std::end(places), driver.fl_map);
  return driver;
}

}  // namespace

void LateBytes::expect(std::span<const std::byte> bytes) {
  places_.reserve(places_.size() + 1);  // so that nothing throws amid HDF5
  expected_ = bytes;
  late_bytes = this;
}

void LateBytes::settle() noexcept {
  expected_ = {};
  if (late_bytes == this) late_bytes = nullptr;
}

void LateBytes::write() noexcept {
  for (const Place& place : places_)
    write_now(disk_of(place.file), place.at, place.bytes.size(), place.bytes.data());
  places_.clear();
}

bool LateBytes::notes(H5FD_t* file, haddr_t at, std::size_t size, const void* from) noexcept {
  if (from != expected_.data() || size != expected_.size()) return false;
  places_.push_back({file, at, expected_});
  return true;
}

bool write_through_disk(const Handle& access) {
  static const H5FD_class_t driver = disk_class();
  static const hid_t id = H5FDregister(&driver);
  return H5Pset_driver(access.id(), id, nullptr) >= 0;
}

int last_open_failure() {
  return std::exchange(open_failure, 0);
}

int last_close_failure() {
  return std::exchange(close_failure, 0);
}

int write_failure(const Handle& file) {
  const Disk* const disk = disk_of(file);
  return disk == nullptr ? 0 : disk->failure;
}

bool flush_in_order(const Handle& file) {
  Disk* const disk = disk_of(file);
  if (disk != nullptr) disk->holds = true;
  const bool flushed = H5Fflush(file.id(), H5F_SCOPE_LOCAL) >= 0;
  if (disk == nullptr) return flushed;
  disk->holds = false;
  release(*disk);
  disk->new_from = disk->eof;
  return flushed;
}

}  // namespace fingerpad::hdf5
