#include "fuzz/input_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace fingerpad::test {
namespace fs = std::filesystem;

InputFile::InputFile(std::string_view bytes, std::string_view ending) {
  const fs::path memory = "/dev/shm";
  std::error_code ignored;
  const fs::path folder = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
  path_ = folder / fmt::format("fingerpad-fuzz-{}{}", getpid(), ending);
  std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

InputFile::~InputFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace fingerpad::test
