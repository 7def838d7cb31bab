#pragma once

#include <optional>
#include <string_view>

namespace fingerpad {

/// What a tick's contact costs with a method and normals on a part of so many triangles, in units of what
/// closest-point with facets costs on a part of a thousand; none where the table has no such pair:
/// `auto` takes that for dearer than all that it has.
///
/// Read off a table of measured ratios, with straight lines between the logarithms of the counts; the table's
/// ends go on. `bench_contact_cost` measures the table on a machine of today; the choice is the same on every
/// machine.
/// @param has_radius  a ball's ticks and a point's are measured apart
std::optional<double> contact_cost(std::string_view method, std::string_view normals, int triangles,
                                   bool has_radius) noexcept;

}  // namespace fingerpad
