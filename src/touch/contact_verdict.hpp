#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "touch/contact_case.hpp"

namespace fingerpad {

/// What of a scene's tolerances the chosen pair does not keep on a part.
enum class Unkept {
  nothing,
  grip,      ///< a pressed finger slips round the part, or round its roundings: nothing holds it
  method,    ///< the contact method cannot do there
  force,     ///< force_tolerance
  friction,  ///< mu_tolerance
};

/// Which of the pairs that a scene leaves open its choice falls on, by reckoning.
struct ContactVerdict {
  std::vector<ContactCase> cases;  ///< one a part
  std::vector<ContactPair> all;
  std::size_t chosen_at = 0;
  bool method_open = false, normals_open = false;

  const ContactPair& chosen() const { return all[chosen_at]; }
  /// The first in the enum's order.
  Unkept unkept_on(std::size_t i) const;
};

/// The cheapest pair that holds and keeps the tolerances; else the cheapest of those that are nearly as good
/// as can be. None (`all` is empty) where the scene names a method that no table has.
/// @param cases  of the scene (contact_cases); their measures outlive the verdict
ContactVerdict reckon_verdict(const Scene& scene, std::span<const Surface> surfaces,
                              std::vector<ContactCase> cases, ErrorMemory& errors);

/// How deep a part holds a finger that is pressed into it, before it slips round the part or its roundings
/// [m].
double holds_deep_m(const ContactCase& on) noexcept;

/// Whether all that a method cannot do on a part is to keep up with a ball.
bool falls_behind(const ContactCase& on, const ReckonedError& error) noexcept;

/// Whether the mesh's own numbers are why it is not kept on a part: they are rounded by what is felt, or its
/// facets are too small for them.
bool is_of_digits(const ContactCase& on, const ReckonedError& error) noexcept;

/// What can be kept in the place of force_tolerance where the reckoned error is so large; infinity: nothing.
double kept_force_tolerance(double error) noexcept;

/// The same of a tolerance of friction that is missed so many times; infinity: nothing.
double kept_mu_tolerance(double mu_tolerance, double times) noexcept;

}  // namespace fingerpad
