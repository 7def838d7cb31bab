#include "motion/field_format.hpp"

#include <fmt/format.h>

namespace fingerpad {

const FieldFormat* find_field_format(std::string_view name) noexcept {
  for (const FieldFormat& row : field_formats()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

FieldRecording read_field_recording(const std::string& path, const RecordingFormat& format) {
  if (const FieldFormat* row = find_field_format(format.name)) return row->read(path, format);
  FieldRecording recording;
  recording.motion = read_motion_csv(path, format, recording.separator);
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
