#pragma once

namespace fingerpad::test {

/// How often memory was asked for, of operator new or of the C library's allocators, by which Embree goes
/// past it. Under the address sanitizer, whose own allocators these would hide, nothing is counted: 0.
long allocations_of_process() noexcept;

/// Of these, those that this thread made.
long allocations_of_thread() noexcept;

}  // namespace fingerpad::test
