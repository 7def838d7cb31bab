#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// What sets scenes apart, for each as a person would say it: "mu_static 0.3", "knob.stl, law dahl"; "as by
/// default" where others say what this one leaves out, "no part 2" where they have more of these. Names of
/// scenes do not count, nor how a number is written (1000, 1000.0). Empty texts where the scenes do not
/// differ.
/// @param scene_texts  as traces keep them; Throws Error (refused) for a text that is no TOML
std::vector<std::string> scene_differences(const std::vector<std::string>& scene_texts);

}  // namespace fingerpad
