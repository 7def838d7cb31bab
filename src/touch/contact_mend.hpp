#pragma once

#include <span>
#include <string>

#include "touch/contact_verdict.hpp"

namespace fingerpad {

/// What would keep a scene's tolerances on part i, on which `verdict` does not: "a greatest_force_n of 1.4
/// would", "a greatest_force_n of 3.3 would, with force_tolerance 0.26, or with a finer mesh or a STEP file
/// (facets 4 times smaller)".
///
/// Only what was tried is said to do so, and what was not enough is told as that: the choice is reckoned anew
/// with each change, first with one alone, then with what that leaves unkept. Of facets n times smaller it is
/// reckoned that they turn by an n-th and cut in by an n^2-th, that patches fit n times as well, and that a
/// ball in a hollow is near n^2 as many.
std::string mend_of(const Scene& scene, std::span<const Surface> surfaces,
                    std::span<const PartMeasures> measures, const ContactVerdict& verdict, std::size_t i);

/// What can be kept in the place of force_tolerance where the reckoned error is so large; infinity: nothing.
double kept_force_tolerance(double error) noexcept;

/// The same of a tolerance of friction that is missed so many times; infinity: nothing.
double kept_mu_tolerance(double mu_tolerance, double times) noexcept;

}  // namespace fingerpad
