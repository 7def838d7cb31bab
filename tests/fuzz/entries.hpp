#pragma once

#include <span>
#include <string_view>

namespace fingerpad::test {

/// What is done with the bytes of one kind of input: read through the public entry, then used as the program
/// would use it. Bytes that are refused with an Error are a good end; whatever else comes out (another
/// exception, a broken promise as std::logic_error, a crash, a sanitizer's report) is a finding.
struct FuzzEntry {
  std::string_view name;  ///< also the folder of its corpus and of its found cases
  void (*run)(std::string_view bytes);
};

/// All of them: the fuzz targets (tools/fuzz) and the test of the kept cases run the same functions.
std::span<const FuzzEntry> fuzz_entries() noexcept;

/// By name, or null.
const FuzzEntry* find_fuzz_entry(std::string_view name) noexcept;

void fuzz_stl(std::string_view bytes);
void fuzz_obj(std::string_view bytes);
void fuzz_ply(std::string_view bytes);
void fuzz_off(std::string_view bytes);
void fuzz_scene(std::string_view bytes);
void fuzz_motion(std::string_view bytes);
void fuzz_profile(std::string_view bytes);
void fuzz_trace_csv(std::string_view bytes);
/// The bytes are choices: what stands in the attributes and datasets of a well-formed HDF5 file, which is
/// read in this process: what stumbles there is ours.
void fuzz_trace_hdf5(std::string_view bytes);
/// The bytes are changes to the bytes of a whole trace, under a right seal. HDF5 itself stumbles over such
/// files: that must end in a refusal.
void fuzz_trace_hdf5_bytes(std::string_view bytes);
/// The bytes are what the child that reads an HDF5 trace tells its parent; it may have lost its mind.
void fuzz_trace_told(std::string_view bytes);

}  // namespace fingerpad::test
