#pragma once

#include <cstddef>

namespace fingerpad {

/// Asks the system to give memory that will be written now, and then read here and there for long, in large
/// pages. As keep_in_large_pages, but for memory that nothing was written to, which need not be moved.
void prefer_large_pages(const void* begin, std::size_t bytes) noexcept;

/// Asks the system to keep memory that will be read here and there for long in large pages, so that the
/// processor finds it without looking up a page each time. Its contents stay; a system without large pages
/// leaves all as it is. Of no use below some megabytes.
/// @param begin, bytes  written already
void keep_in_large_pages(const void* begin, std::size_t bytes) noexcept;

/// The same of a matrix's numbers.
template <typename Array>
void prefer_large_pages(const Array& array) noexcept {
  prefer_large_pages(array.data(), static_cast<std::size_t>(array.size()) * sizeof(*array.data()));
}
/// The same of a vector's or a matrix's numbers.
template <typename Array>
void keep_in_large_pages(const Array& array) noexcept {
  keep_in_large_pages(array.data(), static_cast<std::size_t>(array.size()) * sizeof(*array.data()));
}

}  // namespace fingerpad
