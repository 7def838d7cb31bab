#include "view/friction_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/number_text.hpp"
#include "view/touch_series.hpp"

namespace fingerpad {
namespace {

const ComparedColumn* values_of(const ComparedRun& run, std::string_view name) {
  const auto found = std::ranges::find(run.columns, name, &ComparedColumn::name);
  return found == run.columns.end() ? nullptr : &*found;
}

/// The line along which all rub straight; nothing where there is none. What stays at its place has friction
/// along any line, so the first that moves says which.
const Vec3* common_line(const std::vector<ComparedRun>& runs) {
  const auto is_straight = [](const ComparedRun& run) { return run.rub.is_straight; };
  if (runs.empty() || !std::ranges::all_of(runs, is_straight)) return nullptr;
  const auto moves = [](const ComparedRun& run) { return run.rub.moves; };
  const auto first = std::ranges::find_if(runs, moves);
  if (first == runs.end()) return &runs.front().rub.direction_W;
  const Vec3& line_W = first->rub.direction_W;
  const bool is_shared = std::ranges::all_of(runs, [&](const ComparedRun& run) {
    return !run.rub.moves || are_along_one_line(run.rub.direction_W, line_W);
  });
  return is_shared ? &line_W : nullptr;
}

/// Puts the friction's component along a line in the place of that along the sliding.
void tell_along(ComparedRun& run, const Vec3& line_W) {
  const auto friction = std::ranges::find(run.columns, "friction", &ComparedColumn::name);
  const std::array parts = {values_of(run, "ffx_n"), values_of(run, "ffy_n"), values_of(run, "ffz_n")};
  if (friction == run.columns.end()) return;
  for (std::size_t i = 0; i < friction->values.size(); ++i)
    friction->values[i] = Vec3(parts[0]->values[i], parts[1]->values[i], parts[2]->values[i]).dot(line_W);
  friction->thinned.clear();  // no way goes into it, so ticks that are left out change nothing
}

FrictionSense sense_along(const Vec3& line_W) {
  const std::string name = direction_name(line_W);
  FrictionSense sense{
      name, "+ pushes towards +" + name,
      fmt::format("friction: along {0}, positive where it pushes the finger towards +{0}", name)};
  if (!is_world_axis(line_W))
    sense.sentence += fmt::format("; {} is ({}, {}, {})", name, fixed_text(line_W.x(), 2),
                                  fixed_text(line_W.y(), 2), fixed_text(line_W.z(), 2));
  return sense;
}

}  // namespace

FrictionSense share_friction_sense(std::vector<ComparedRun>& runs) {
  if (const Vec3* found = common_line(runs)) {
    const Vec3 line_W = *found;
    for (ComparedRun& run : runs) tell_along(run, line_W);
    return sense_along(line_W);
  }
  return {"sliding", "- against it",
          fmt::format("friction: along the sliding direction{}, negative where it holds the finger back",
                      runs.size() > 1 ? " of each" : "")};
}

}  // namespace fingerpad
