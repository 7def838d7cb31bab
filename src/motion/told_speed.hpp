#pragma once

#include <span>

#include "base/types.hpp"

namespace fingerpad {

/// How many times faster a recording says it goes than its positions do: the median over pieces of 50 ms that
/// go far, of the way that the speeds make over that of the positions. 1 where their units agree; not a
/// number where fewer than three pieces move.
/// @param t_s        n, increasing
/// @param p_W        3 x n [m]
/// @param speed_m_per_s  n; of either sign
double speed_over_positions(std::span<const double> t_s, const Points& p_W,
                            std::span<const double> speed_m_per_s);

}  // namespace fingerpad
