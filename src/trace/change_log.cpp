#include "trace/change_log.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace fingerpad {
namespace {

constexpr const char* column_name = "changes";
constexpr std::uint64_t most_bytes = std::uint64_t{4} << 20;
constexpr InputKind change_file{"the changes of a trace", most_bytes, true};

/// The lines of these changes; the first ones come behind the header.
std::string lines_of(std::span<const SceneChange> changes, bool first) {
  const std::string text = scene_changes_text(changes);
  return first ? text : text.substr(text.find('\n') + 1);
}

}  // namespace

void Hdf5ChangeLog::add(const hdf5::Handle& file, std::span<const SceneChange> changes) {
  if (changes.empty()) return;
  if (!column_) column_ = hdf5::create_column(file, column_name, hdf5::NumberType::uint8, "UTF-8 text");
  const std::string text = lines_of(changes, bytes_ == 0);
  const std::vector<double> bytes(text.begin(), text.end());
  hdf5::append(*column_, bytes_, bytes);
  bytes_ += bytes.size();
}

std::string read_change_log(const hdf5::Handle& file) {
  if (!hdf5::has_link(file, column_name)) return {};
  const hdf5::Handle column = hdf5::open_dataset(file, column_name, "column");
  const auto size = hdf5::extents(column);
  if (size.size() != 1 || size[0] > most_bytes)
    throw refused(file.path(), "is damaged: its changes are no text");
  std::vector<double> bytes(std::min<std::uint64_t>(size[0], hdf5::stored_values(column)));
  if (!bytes.empty() && !hdf5::read_rows(column, 0, bytes))
    throw refused(file.path(), "is damaged: its changes cannot be read");
  std::string text;
  for (const double byte : bytes) text += static_cast<char>(static_cast<unsigned char>(byte));
  return text;
}

std::string change_file_name(const std::string& csv_path) {
  std::filesystem::path path(csv_path);
  if (path.extension() == ".part") path.replace_extension();
  return path.replace_extension(".changes.csv").string();
}

std::string read_change_file(const std::string& csv_path) {
  if (stream_descriptor(csv_path)) return {};
  const std::string path = change_file_name(csv_path);
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return read_whole_file(path, change_file);
  const std::string unfinished = path + ".part";  // of a recording that was cut short
  const bool cut_short = csv_path.ends_with(".part") && std::filesystem::exists(unfinished, ignored);
  return cut_short ? read_whole_file(unfinished, change_file) : std::string();
}

ChangeFile::ChangeFile(std::string csv_path) : csv_path_(std::move(csv_path)) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(csv_path_, ignored) || !std::filesystem::exists(csv_path_, ignored))
    std::filesystem::remove(change_file_name(csv_path_), ignored);
}

void ChangeFile::add(std::span<const SceneChange> changes) {
  if (changes.empty()) return;
  const bool first = file_ == nullptr;
  if (first) file_ = std::make_unique<OutputFile>(change_file_name(csv_path_), OutputFile::Unfinished::kept);
  file_->write(lines_of(changes, first));
}

void ChangeFile::flush() {
  if (file_) file_->flush();
}

void ChangeFile::commit() {
  if (file_) file_->commit();
}

}  // namespace fingerpad
