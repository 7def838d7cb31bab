#include "replay/run_proof.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <sstream>
#include <utility>

#include "base/build_identity.hpp"
#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "replay/figures.hpp"
#include "replay/run_lock.hpp"
#include "scene/scene_differences.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_columns.hpp"
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

/// As a proof says it, behind the figures.
std::string kind_line(std::string_view name, std::string_view hash) {
  return fmt::format("by {} {}", name, hash);
}

/// A CSV trace that is not finished has another name.
bool is_finished(const std::string& path) {
  try {
    return !is_hdf5(path) || check_seal(path) == Seal::whole;
  } catch (const Error&) {
    return false;
  }
}

/// Whether the proof is of the file as it stands there.
bool proves_file(const std::string& proof, const std::string& trace_path) {
  const auto trace = fingerprint(trace_path);
  return trace && proof.find("\ntrace " + sum_text(*trace) + '\n') != std::string::npos;
}

/// What has changed in the scene that an HDF5 trace keeps, as words to put behind others; empty where that
/// cannot be told (of another file than the proof's, too), is too much to be read, or does not show in words:
/// a comment, a file's folder.
std::string changed_in_scene(const std::string& trace_path, const std::string& proof,
                             const std::string& scene_text) {
  constexpr std::size_t longest = 100;
  try {
    if (!is_hdf5(trace_path) || !proves_file(proof, trace_path)) return {};
    const std::string kept_text = read_hdf5_columns(trace_path, {}).scene_text;
    const std::vector<std::string> words = scene_differences({kept_text, scene_text});
    if (words[0].empty() && words[1].empty()) return ", though none of its keys has another value";
    if (words[0] == words[1] || words[0].size() > longest || words[1].size() > longest) return {};
    return fmt::format(": {}; now {}", words[0], words[1]);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

void write_proof(const std::string& trace_path, const RunDigest& digest, const std::vector<double>& figures) {
  if (const auto trace = fingerprint(trace_path)) write_proof(trace_path, digest, figures, *trace);
}

void write_proof(const std::string& trace_path, const RunDigest& digest, const std::vector<double>& figures,
                 const FileSum& trace) {
  std::error_code ignored;
  if (!fs::is_regular_file(trace_path, ignored)) return;  // of what went into a pipe nothing can be proven
  std::string text = fmt::format("{}\nrun {}\n{}{}\ntrace {}\n", first_line, digest.whole, build_word,
                                 short_build_identity(), sum_text(trace));
  for (std::size_t i = 0; i < figures.size(); ++i)
    text += fmt::format("{} {}\n", Figures::names()[i], number_text(figures[i]));
  for (const auto& [name, hash] : digest.kinds) text += kind_line(name, hash) + '\n';
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

std::optional<std::vector<double>> proven_figures(const std::string& trace_path, const RunDigest& digest) {
  std::istringstream proof(proof_text(trace_path));
  std::string line;
  if (!std::getline(proof, line) || line != first_line) return std::nullopt;
  if (!std::getline(proof, line) || line != "run " + digest.whole) return std::nullopt;
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

bool proves_another_run(const std::string& trace_path, const RunDigest& digest) {
  std::istringstream proof(proof_text(trace_path));
  std::string first, run;
  return std::getline(proof, first) && first == first_line && std::getline(proof, run) &&
         run.starts_with("run ") && run != "run " + digest.whole;
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

std::string other_build_words(const std::string& build) {
  return fmt::format(
      "another build of the program ({}; this one is {}), and results of two builds are not mixed", build,
      short_build_identity());
}

MadeAgain why_not_kept(const std::string& trace_path, const RunDigest& digest, const std::string& scene_text,
                       bool is_countable) {
  std::error_code ignored;
  if (!fs::exists(trace_path, ignored)) return {};
  if (const auto build = other_build_of(trace_path))
    return {"it was made by " + other_build_words(*build), true};
  const std::string proof = proof_text(trace_path);
  if (!proof.starts_with(first_line))
    return {!is_finished(trace_path)              ? "it is not whole"
            : is_countable && is_hdf5(trace_path) ? "it is of another run, by its own word"
                                                  : "nothing beside it says which run made it"};
  if (!proves_another_run(trace_path, digest)) return {"it is not, byte for byte, what was written"};
  for (const auto& [name, hash] : digest.kinds) {
    // What an earlier build did not write down is not told.
    if (proof.find(fmt::format("\nby {} ", name)) == std::string::npos) continue;
    if (proof.find('\n' + kind_line(name, hash) + '\n') != std::string::npos) continue;
    const std::string in_scene = name == "scene" ? changed_in_scene(trace_path, proof, scene_text) : "";
    return {changed_words(name) + in_scene};
  }
  return {"it is of another run"};
}

void remove_unfinished(const std::string& trace_path) {
  std::error_code ignored;
  fs::remove(trace_path + ".part", ignored);
  fs::remove(proof_path(trace_path) + ".part", ignored);
}

}  // namespace fingerpad
