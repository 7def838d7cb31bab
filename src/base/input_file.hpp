#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fingerpad {

/// What a reader takes.
struct InputKind {
  std::string_view what;         ///< "a mesh", for the words of a refusal
  std::uint64_t most_bytes = 0;  ///< more are refused
  bool stream = false;           ///< read once from front to back, so that `-` and /dev/fd/N will do
};

/// The descriptor that a path stands for: 0 for `-` and /dev/stdin, N for /dev/fd/N and /proc/self/fd/N;
/// nothing for a path in the file system.
std::optional<int> stream_descriptor(std::string_view path) noexcept;

/// How a path is named in messages: "standard input" for `-`.
std::string input_name(const std::string& path);

/// The one way by which input files are opened: regular files alone, and streams where the reader takes them.
/// A pipe or a device in the file system is refused, since nothing may hang or go on for ever.
class InputFile {
 public:
  /// @param where  what a refusal names
  /// Throws Error (refused, at `where`) with the reason and the mend: no such file, a folder, a pipe, a
  /// device, no permission, a loop of links, a file in the place of a folder, too many bytes.
  InputFile(const std::string& path, const InputKind& kind, std::string where);
  InputFile(const std::string& path, const InputKind& kind) : InputFile(path, kind, input_name(path)) {}
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  /// Reads up to `count` bytes; fewer only at the end. Throws Error (refused) beyond most_bytes.
  std::size_t read(char* to, std::size_t count);
  /// Of a regular file, when it was opened; 0 for a stream.
  std::uint64_t size() const noexcept { return size_; }
  const std::string& where() const noexcept { return where_; }

 private:
  void open_stream(int descriptor);
  void open_regular(const std::string& path);

  InputKind kind_;
  std::string where_;
  int file_ = -1;
  bool waits_ = false;  ///< a stream: what is not there yet may come
  std::uint64_t size_ = 0, taken_ = 0;
};

/// All bytes of a file. Throws as InputFile does.
std::string read_whole_file(const std::string& path, const InputKind& kind, const std::string& where);
std::string read_whole_file(const std::string& path, const InputKind& kind);

/// Why a file cannot be opened, for readers that open it by its name themselves; nothing if it can.
std::optional<std::string> why_unreadable(const std::string& path, const InputKind& kind);

/// "4 MiB", for limits that are whole.
std::string bytes_text(std::uint64_t bytes);

}  // namespace fingerpad
