#pragma once

#include <string>
#include <vector>

namespace fingerpad {

struct PartEntry;
struct Scene;
struct Verdict;
struct World;

/// A line for a part that was read in an unlikely unit; none for others.
void add_unit_hint(const Verdict& verdict, const PartEntry& part, std::vector<std::string>& lines);

/// A line for a finger whose radius is meant in millimetres: larger than all parts; empty for others.
std::string finger_hint(const World& world, const Scene& scene);
/// Throws Error (refused) for such a finger of over half a metre, which would press with thousands of
/// newtons, unless the scene has a plane, on which a large ball may roll.
void refuse_huge_finger(const World& world, const Scene& scene);

/// A line for each part that was read in an unlikely unit: "FILE: is 0.1 mm long; ..." (unit_hint); and for
/// the finger.
std::vector<std::string> unit_hints(const World& world, const Scene& scene);

}  // namespace fingerpad
