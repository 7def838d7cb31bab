#include "motion/field_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace fingerpad {
namespace {

// A table of the program's own kind has positions in itself.
constexpr std::array<std::string_view, 9> own_table_keys{
    "columns", "unit", "time_unit", "force_unit", "separator", "decimal", "force_on", "subject", "trial"};

std::span<const std::string_view> keys_of(std::string_view name) noexcept {
  const FieldFormat* row = find_field_format(name);
  return row != nullptr ? row->keys : own_table_keys;
}

/// The keys by which a format says something.
std::vector<std::string_view> said_keys(const RecordingFormat& format) {
  const bool names = std::any_of(format.headers.begin(), format.headers.end(),
                                 [](const std::string& header) { return !header.empty(); });
  const CsvDialect plain = RecordingFormat{}.dialect;
  std::vector<std::string_view> said;
  const auto say = [&said](std::string_view key, bool is_said) {
    if (is_said) said.push_back(key);
  };
  say("columns", names);
  say("unit", format.says_unit);
  say("time_unit", format.says_time_unit);
  say("force_unit", format.says_force_unit);
  say("separator", format.dialect.separator != plain.separator);
  say("decimal", format.dialect.decimal != plain.decimal);
  say("positions", !format.positions_path.empty());
  say("force_on", format.forces_on_surface);
  say("subject", format.subject.has_value());
  say("trial", format.trial.has_value());
  return said;
}

}  // namespace

bool asks_for_key(std::string_view name, std::string_view key) noexcept {
  const auto keys = keys_of(name);
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void refuse_unasked_keys(const std::string& path, const RecordingFormat& format) {
  for (const std::string_view key : said_keys(format)) {
    if (asks_for_key(format.name, key)) continue;
    const auto keys = keys_of(format.name);
    throw refused(path, fmt::format("'{}' is said of it, which {} does not ask for (it asks for: {}): leave "
                                    "it out",
                                    key,
                                    format.name.empty() ? "a table without a format"
                                                        : fmt::format("format = \"{}\"", format.name),
                                    keys.empty() ? "nothing" : fmt::format("{}", fmt::join(keys, ", "))));
  }
}

const FieldFormat* find_field_format(std::string_view name) noexcept {
  for (const FieldFormat& row : field_formats()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

FieldRecording read_field_recording(const std::string& path, const RecordingFormat& format) {
  refuse_unasked_keys(path, format);
  if (const FieldFormat* row = find_field_format(format.name)) {
    FieldRecording recording = row->read(path, format);
    recording.read_as = format;
    recording.read_as.dialect.separator = ',';
    return recording;
  }
  FieldRecording recording;
  recording.read_as = format;
  recording.motion = read_motion_csv(path, recording.read_as);
  return recording;
}

std::vector<std::string> field_files(const std::string& path, const RecordingFormat& format) {
  if (const FieldFormat* row = find_field_format(format.name)) return row->files(path, format);
  return {path};
}

std::string field_formats_text() {
  std::string text = "| format | what it is | touched with |\n|---|---|---|\n";
  for (const FieldFormat& row : field_formats())
    text += fmt::format("| `{}` | {} | {} |\n", row.name, row.summary, row.touched_with);
  return text;
}

}  // namespace fingerpad
