#pragma once

namespace fingerpad {

class FingerPath;
class TriangleTree;

/// Whether a proxy of the finger's radius, with the facets' normals, is left behind by more than `limit_m` at
/// any tick of a path in a part's frame: how deep it is pressed in, by whatever wall the proxy stands at.
/// Looks no further than to that tick.
bool presses_deeper(const TriangleTree& tree, const FingerPath& path, double radius_m, double limit_m);

}  // namespace fingerpad
