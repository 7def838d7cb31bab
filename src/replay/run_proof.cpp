#include "replay/run_proof.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <sstream>

#include "base/build_identity.hpp"
#include "base/checksum.hpp"
#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "replay/figures.hpp"
#include "replay/run_lock.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "fingerpad proof 1", build_word = "build ";

std::string proof_path(const std::string& trace_path) {
  const fs::path trace(trace_path);
  return (trace.parent_path() / state_folder / trace.filename()).string() + ".proof";
}

std::string sum_text(const FileSum& sum) {
  return fmt::format("{} {:016x}", sum.size, sum.checksum);
}

/// Size and checksum of a file; nothing if it cannot be read, or is none: a trace may go into a pipe.
std::optional<FileSum> fingerprint(const std::string& path) {
  constexpr InputKind any_trace{"a trace", std::numeric_limits<std::uint64_t>::max()};
  try {
    InputFile file(path, any_trace);
    std::vector<char> block(std::size_t{1} << 18);
    std::uint64_t size = 0;
    Checksum checksum;
    while (const std::size_t count = file.read(block.data(), block.size())) {
      checksum.add(block.data(), count);
      size += count;
    }
    return FileSum{size, checksum.value(size)};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A proof's text; empty where there is none that can be read.
std::string proof_text(const std::string& trace_path) {
  constexpr InputKind proof_file{"a proof", std::uint64_t{1} << 20};
  try {
    return read_whole_file(proof_path(trace_path), proof_file);
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

std::string run_digest(const TraceInfo& info, TraceFormat format) {
  std::string text;
  const auto add = [&text](std::string_view field) { text += fmt::format("{}:{};", field.size(), field); };
  const auto add_all = [&add](const std::vector<std::string>& fields) {
    add(std::to_string(fields.size()));
    for (const std::string& field : fields) add(field);
  };
  add(format == TraceFormat::csv ? "csv" : "h5");
  add(build_identity());
  for (const std::string* field :
       {&info.version, &info.scene_name, &info.scene_text, &info.motion_file, &info.motion_hash,
        &info.profile_text, &info.contact_method, &info.contact_normals})
    add(*field);
  add(std::to_string(info.seed));
  add(number_text(info.rate_hz));
  add_all(info.mesh_files);
  add_all(info.mesh_hashes);
  add_all(info.contact_reasons);
  add_all(info.motion_notes);
  if (!info.columns.empty()) add_all(info.columns);
  if (info.every != 1) add(fmt::format("every {}", info.every));
  if (info.deflated) add("deflated");
  if (!info.changes.empty()) add(scene_changes_text(info.changes));
  return fmt::format("{:016x}", content_hash(std::as_bytes(std::span(text))));
}

void write_proof(const std::string& trace_path, const std::string& digest,
                 const std::vector<double>& figures) {
  if (const auto trace = fingerprint(trace_path)) write_proof(trace_path, digest, figures, *trace);
}

void write_proof(const std::string& trace_path, const std::string& digest, const std::vector<double>& figures,
                 const FileSum& trace) {
  std::error_code ignored;
  if (!fs::is_regular_file(trace_path, ignored)) return;  // of what went into a pipe nothing can be proven
  std::string text = fmt::format("{}\nrun {}\n{}{}\ntrace {}\n", first_line, digest, build_word,
                                 short_build_identity(), sum_text(trace));
  for (std::size_t i = 0; i < figures.size(); ++i)
    text += fmt::format("{} {}\n", Figures::names()[i], number_text(figures[i]));
  const std::string path = proof_path(trace_path);
  // Not the folder above it: where that has just been removed, it must not come back with a proof alone.
  fs::create_directory(fs::path(path).parent_path(), ignored);
  try {
    OutputFile file(path);
    file.write(text);
    file.commit();
  } catch (const Error&) {  // NOLINT(bugprone-empty-catch): a proof that cannot be written is none
  }
}

std::optional<std::vector<double>> proven_figures(const std::string& trace_path, const std::string& digest) {
  std::istringstream proof(proof_text(trace_path));
  std::string line;
  if (!std::getline(proof, line) || line != first_line) return std::nullopt;
  if (!std::getline(proof, line) || line != "run " + digest) return std::nullopt;
  if (!std::getline(proof, line) || !line.starts_with(build_word)) return std::nullopt;
  const auto trace = fingerprint(trace_path);
  if (!trace || !std::getline(proof, line) || line != "trace " + sum_text(*trace)) return std::nullopt;
  std::vector<double> figures;
  for (const std::string_view name : Figures::names()) {
    if (!std::getline(proof, line) || !line.starts_with(fmt::format("{} ", name))) return std::nullopt;
    const auto value = parse_number(std::string_view(line).substr(name.size() + 1));
    if (!value) return std::nullopt;
    figures.push_back(*value);
  }
  return figures;
}

bool proves_another_run(const std::string& trace_path, const std::string& digest) {
  std::istringstream proof(proof_text(trace_path));
  std::string first, run;
  return std::getline(proof, first) && first == first_line && std::getline(proof, run) &&
         run.starts_with("run ") && run != "run " + digest;
}

bool has_proof(const std::string& trace_path) {
  std::error_code ignored;
  return fs::is_regular_file(proof_path(trace_path), ignored);
}

std::optional<std::string> other_build_of(const std::string& trace_path) {
  std::istringstream proof(proof_text(trace_path));
  std::string line;
  if (!std::getline(proof, line) || line != first_line) return std::nullopt;
  std::string run;
  if (!std::getline(proof, run) || !std::getline(proof, line)) return std::nullopt;
  if (!line.starts_with(build_word)) return "an earlier one";
  const std::string build = line.substr(build_word.size());
  if (build == short_build_identity()) return std::nullopt;
  return build;
}

void remove_unfinished(const std::string& trace_path) {
  std::error_code ignored;
  fs::remove(trace_path + ".part", ignored);
  fs::remove(proof_path(trace_path) + ".part", ignored);
}

}  // namespace fingerpad
