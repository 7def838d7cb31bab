#include "fuzz/entries.hpp"

#include <algorithm>
#include <array>

namespace fingerpad::test {

std::span<const FuzzEntry> fuzz_entries() noexcept {
  static constexpr std::array<FuzzEntry, 11> entries{{{"stl", fuzz_stl},
                                                      {"obj", fuzz_obj},
                                                      {"ply", fuzz_ply},
                                                      {"off", fuzz_off},
                                                      {"scene", fuzz_scene},
                                                      {"motion", fuzz_motion},
                                                      {"profile", fuzz_profile},
                                                      {"trace_csv", fuzz_trace_csv},
                                                      {"trace_hdf5", fuzz_trace_hdf5},
                                                      {"trace_hdf5_bytes", fuzz_trace_hdf5_bytes},
                                                      {"trace_told", fuzz_trace_told}}};
  return entries;
}

const FuzzEntry* find_fuzz_entry(std::string_view name) noexcept {
  const auto entries = fuzz_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const FuzzEntry& e) { return e.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace fingerpad::test
