#pragma once

#include <string>

namespace fingerpad {

struct ContactDemand;

/// Why the nearest surface point gives another force than a finger that stays outside would feel; empty where
/// it does not. It answers from the nearest surface, so it is wrong where that changes under the finger:
///   - the part is open, wound against itself or inside out: its inside is not known;
///   - bodies of the part overlap or touch over an area, or it passes through itself: the nearest sheet may
///     be one that lies inside of another body, and its side says nothing (seen by samples: PartMeasures);
///   - a wall is thinner than twice the depth to which the finger's centre is pressed: beyond its middle the
///     far side is nearer;
///   - a knife edge, whose material is sharper than 60 degrees, where the centre can get inside;
///   - the finger has a radius and touches two walls at once: in a concave crease that turns by phi, where
///     the nearest wall alone is wrong by sin(phi/2) of the force, or in a hollow of a smaller radius (taken
///     as a right angle), where that is more than the force tolerance;
///   - another surface stands nearer than the finger's width;
///   - the finger's centre gets inside, and there is a convex crease that turns by phi with
///     2 sin(phi/2) > force tolerance, or a rounding tighter than the centre is deep: as near to it as it is
///     deep, the face beside is nearer than the one that is pressed, and the force turns over to it though
///     the finger has not come past the edge.
std::string closest_point_fails(const ContactDemand& demand);

/// Why it does not, in words that follow "because".
std::string closest_point_holds(const ContactDemand& demand);

}  // namespace fingerpad
