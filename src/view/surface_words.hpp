#pragma once

#include <string>
#include <vector>

#include "view/view_input.hpp"

namespace fingerpad {

/// What a picture calls a surface: its file, cut to `longest` letters; "-" where there is none.
std::string surface_name(const World& world, int index, std::size_t longest);

/// What is to say about the parts where nothing moves.
std::vector<std::string> about_lines(const ViewInput& input);

}  // namespace fingerpad
