#pragma once

namespace fingerpad::test {

/// How often memory was asked for, of operator new or of the C library's allocators, by which Embree goes
/// past it. What links fingerpad_test_allocations counts; nothing else does.
long allocations_of_process() noexcept;

/// Of these, those that this thread made.
long allocations_of_thread() noexcept;

}  // namespace fingerpad::test
