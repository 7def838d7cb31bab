#include "trace/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/error.hpp"

namespace fingerpad {

OutputFile::OutputFile(const std::string& path) : path_(path), written_path_(path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) written_path_ += ".part";
  file_ = std::fopen(written_path_.c_str(), "wb");
  if (file_ == nullptr) fail("cannot be created");
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void OutputFile::fail(const std::string& doing) const {
  throw Error(ErrorKind::fault, path_, doing + ": " + std::strerror(errno));
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("cannot be written");
}

void OutputFile::flush() {
  if (std::fflush(file_) != 0) fail("cannot be written");
}

void OutputFile::commit() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0) fail("cannot be written");
  if (written_path_ != path_ && std::rename(written_path_.c_str(), path_.c_str()) != 0)
    fail("cannot be renamed");
}

}  // namespace fingerpad
