#pragma once

#include <string>

namespace fingerpad {

/// Which build of the program this is: the hash that the linker made of it (ELF build id), as hex digits. The
/// same in every run and on every machine that the program is copied to, another after any change of its
/// code. It does not tell of the shared libraries beside it. Empty where the linker left none
/// (-Wl,--build-id=none).
std::string build_identity();

/// Its first twelve digits, for people.
std::string short_build_identity();

}  // namespace fingerpad
