#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace fingerpad::test {

/// What is done with the bytes of one kind of input: read through the public entry, then used as the program
/// would use it. Bytes that are refused with an Error are a good end; whatever else comes out (another
/// exception, a broken promise as std::logic_error, a crash, a sanitizer's report) is a finding.
struct FuzzEntry {
  std::string name;  ///< also the folder of its corpus and of its found cases
  std::function<void(std::string_view bytes)> run;
};

/// All of them, a mesh format each among them: the fuzz targets (tools/fuzz) and the test of the kept cases
/// run the same functions. Their names are the folders of tests/fuzz/corpus.
std::span<const FuzzEntry> fuzz_entries();

/// By name, or null.
const FuzzEntry* find_fuzz_entry(std::string_view name);

/// @param ending  of the mesh format: ".stl"
void fuzz_mesh(std::string_view bytes, std::string_view ending);
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
/// The bytes are packets of a device on the network, one behind the other.
void fuzz_device_packets(std::string_view bytes);
/// The bytes are a frame of Haply's Inverse Service.
void fuzz_haply_frame(std::string_view bytes);

}  // namespace fingerpad::test
