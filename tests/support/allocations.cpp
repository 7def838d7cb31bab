#include "support/allocations.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

std::atomic<long> of_process{0};
thread_local long of_thread = 0;

void note_allocation() {
  ++of_process;
  ++of_thread;
}

}  // namespace

#ifdef FINGERPAD_SANITIZED
// Of the sanitizer's library; g++ 12 comes without its header.
extern "C" int __sanitizer_install_malloc_and_free_hooks(  // NOLINT
    void (*on_malloc)(const volatile void*, std::size_t), void (*on_free)(const volatile void*));

namespace {
// Its allocators stand in the C library's place already, and tell of each call.
[[maybe_unused]] const int are_told = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { note_allocation(); }, [](const volatile void*) {});
}  // namespace
#else
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT: glibc's names
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT
void* malloc(std::size_t size) {
  note_allocation();
  return __libc_malloc(size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note_allocation();
  return __libc_memalign(alignment, size);
}
void* calloc(std::size_t count, std::size_t size) {
  note_allocation();
  return __libc_calloc(count, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  note_allocation();
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
}
#endif

namespace fingerpad::test {

long allocations_of_process() noexcept {
  return of_process;
}

long allocations_of_thread() noexcept {
  return of_thread;
}

}  // namespace fingerpad::test
