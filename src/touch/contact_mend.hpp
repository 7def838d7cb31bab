#pragma once

#include <string>

#include "touch/contact_reckoning.hpp"

namespace fingerpad {

/// What would keep a scene's tolerances on part i, on which `verdict` does not: "a greatest_force_n of 1.4
/// would", "a greatest_force_n of 3.3 would, with force_tolerance 0.26, or with a finer mesh or a STEP file
/// (facets 4 times smaller)".
///
/// Only what was tried is said to do so, and what was not enough is told as that: the choice is reckoned anew
/// with each change, first with one alone, then with what that leaves unkept. What keeps the part taken alone
/// is then tried on the whole scene, where one way to touch must do for all parts.
/// @param reckoning  that the verdict on the scene came from
std::string mend_of(const Scene& scene, ContactReckoning& reckoning, const ContactVerdict& verdict,
                    std::size_t i);

/// Whether the same mends parts i and j: they are of one shape, and the scene asks the same of both.
bool is_mended_alike(const ContactVerdict& verdict, std::size_t i, std::size_t j) noexcept;

}  // namespace fingerpad
