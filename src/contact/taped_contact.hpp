#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "contact/contact_method.hpp"
#include "contact/contact_tape.hpp"
#include "contact/placed_surface.hpp"

namespace fingerpad {

/// What is made of a finger's contact method before its first tick.
/// @param surfaces  that the method touches
using ContactWrap = std::function<std::unique_ptr<ContactMethod>(std::unique_ptr<ContactMethod>,
                                                                 std::vector<PlacedSurface> surfaces)>;

// Where a finger goes decides where it touches; what friction makes of that does not. So of fingers that go
// the same way over the same surfaces, with other friction each, the first alone asks its contact method.

/// Answers as `method` does and writes that down. What happens on a reset is friction's to say and another
/// finger's may not: the tape is spoiled.
std::unique_ptr<ContactMethod> recording_contact(std::unique_ptr<ContactMethod> method,
                                                 std::shared_ptr<ContactTape> tape);

/// Answers as a tape has it, tick by tick. Behind a reset `method`, which was never asked, is what any method
/// is then, and answers from there on.
/// @param surfaces  that the tape's method touched, by their numbers: what a tick reads of them is asked for
/// ahead
/// @pre the tape is this method's along the path to come, for as many ticks as are asked for
std::unique_ptr<ContactMethod> played_contact(std::unique_ptr<ContactMethod> method,
                                              std::shared_ptr<const ContactTape> tape,
                                              std::vector<PlacedSurface> surfaces);

}  // namespace fingerpad
