#include "trace/file_seal.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

constexpr std::array<char, 16> mark = {'f', 'i', 'n', 'g', 'e', 'r', 'p', 'a',
                                       'd', ' ', 's', 'e', 'a', 'l', '1', '\n'};

struct SealBytes {
  std::array<char, 16> mark;
  std::uint64_t size;
  std::uint64_t checksum;
};
static_assert(sizeof(SealBytes) == 32);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The seal that the first `size` bytes deserve; nothing is said of what lies behind them. None where the
/// file cannot be read.
/// @param checksum  afterwards that of those bytes
std::optional<SealBytes> seal_of(std::FILE* file, std::uint64_t size, Checksum& checksum) {
  std::vector<char> block(std::size_t{1} << 18);
  std::rewind(file);
  for (std::uint64_t left = size; left > 0;) {
    const std::size_t count = std::fread(
        block.data(), 1, static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size())), file);
    if (count == 0) return std::nullopt;
    checksum.add(block.data(), count);
    left -= count;
  }
  return SealBytes{mark, size, checksum.value(size)};
}

/// None where that cannot be told.
std::optional<std::uint64_t> size_of(std::FILE* file) {
  const long end = std::fseek(file, 0, SEEK_END) == 0 ? std::ftell(file) : -1;
  if (end < 0) return std::nullopt;
  return static_cast<std::uint64_t>(end);
}

/// All of the seal behind the contents or none of it.
bool append_seal(std::FILE* file, const SealBytes& seal) {
  const bool written = std::fseek(file, 0, SEEK_END) == 0 && std::fwrite(&seal, sizeof(seal), 1, file) == 1 &&
                       std::fflush(file) == 0;
  if (written) return true;
  const int failure = errno;
  if (ftruncate(fileno(file), static_cast<off_t>(seal.size)) == 0) errno = failure;
  return false;
}

/// The last bytes, where they are a seal.
std::optional<SealBytes> last_seal(std::FILE* file, std::uint64_t size) {
  SealBytes found{};
  if (size < sizeof(found)) return std::nullopt;
  std::fseek(file, -static_cast<long>(sizeof(found)), SEEK_END);
  if (std::fread(&found, sizeof(found), 1, file) != 1 || found.mark != mark) return std::nullopt;
  return found;
}

}  // namespace

FileSum seal_file(const std::string& path) {
  const auto fail = [&path] {
    return Error(ErrorKind::fault, path, "cannot be written: " + path_words(path, errno));
  };
  File file(std::fopen(path.c_str(), "r+b"));
  if (!file) throw fail();
  const auto size = size_of(file.get());
  Checksum whole;
  const auto seal = size ? seal_of(file.get(), *size, whole) : std::nullopt;
  if (!seal || !append_seal(file.get(), *seal) || std::fclose(file.release()) != 0) throw fail();
  whole.add(reinterpret_cast<const char*>(&*seal), sizeof(*seal));
  return {*size + sizeof(*seal), whole.value(*size + sizeof(*seal))};
}

Seal check_seal(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  const auto size = file ? size_of(file.get()) : std::nullopt;
  if (!size) throw refused(path, "cannot be read: " + path_words(path, errno));
  const auto found = last_seal(file.get(), *size);
  if (!found) return Seal::none;
  Checksum contents;
  const auto due = seal_of(file.get(), *size - sizeof(*found), contents);
  return due && found->size == due->size && found->checksum == due->checksum ? Seal::whole : Seal::broken;
}

bool ends_with_seal(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  const auto size = file ? size_of(file.get()) : std::nullopt;
  const auto found = size ? last_seal(file.get(), *size) : std::nullopt;
  return found && found->size == *size - sizeof(*found);
}

}  // namespace fingerpad
