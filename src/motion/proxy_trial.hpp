#pragma once

namespace fingerpad {

class FingerPath;
class TriangleTree;

/// How far a proxy of the finger's radius, with the facets' normals, is left behind at most by the ticks of a
/// path in a part's frame: how deep it is pressed in, by whatever wall the proxy stands at [m].
double deepest_press_m(const TriangleTree& tree, const FingerPath& path, double radius_m);

}  // namespace fingerpad
