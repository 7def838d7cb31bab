#include "base/large_pages.hpp"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace fingerpad {
namespace {

/// Gives the system an advice on the large pages that lie whole within memory. Whether it is followed is of
/// no account.
void advise([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes,
            [[maybe_unused]] int advice) noexcept {
#if defined(__linux__)
  constexpr std::uintptr_t page = 4096, large_page = std::uintptr_t{1} << 21;
  // An allocation of its own begins a few bytes behind a page's beginning.
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(begin) / page * page,
                       end = (reinterpret_cast<std::uintptr_t>(begin) + bytes + page - 1) / page * page,
                       from = (first + large_page - 1) / large_page * large_page,
                       to = end / large_page * large_page;
  if (bytes >= large_page && to > from) madvise(reinterpret_cast<void*>(from), to - from, advice);
#endif
}

#if defined(__linux__)
constexpr int prefer = MADV_HUGEPAGE, collapse = 25;  // Linux 6.1's MADV_COLLAPSE, which older headers lack
#else
constexpr int prefer = 0, collapse = 0;
#endif

}  // namespace

void prefer_large_pages(const void* begin, std::size_t bytes) noexcept {
  advise(begin, bytes, prefer);
}

void keep_in_large_pages(const void* begin, std::size_t bytes) noexcept {
  advise(begin, bytes, prefer);
  advise(begin, bytes, collapse);
}

}  // namespace fingerpad
