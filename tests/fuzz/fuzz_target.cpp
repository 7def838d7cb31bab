#include <cstddef>
#include <cstdint>

#include "fuzz/entries.hpp"

// HDF5 files are read by a child, and what the HDF5 library does there with a forged one ends with the child:
// copies that overlap and sizes beyond all memory are its own faults. Those of this program's code stay
// findings, in the child too.
extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1";
}
extern "C" const char* __asan_default_suppressions() {
  return "interceptor_via_lib:libhdf5";
}

// libFuzzer's entry, built once for each FuzzEntry (tests/CMakeLists.txt names it).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto* entry = fingerpad::test::find_fuzz_entry(FINGERPAD_FUZZ_ENTRY);
  entry->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
