#pragma once

#include <TopoDS_Shape.hxx>

namespace fingerpad::parts {

/// Something set into the dashboard's fascia: what is cut out of the panel, and what is put into the hole.
/// Drawn about the origin with the fascia's surface at z = 0, x along the dashboard, y up the fascia; the
/// insert is wider than the hole, so that the two join inside the panel's thickness.
struct Feature {
  TopoDS_Shape hole;
  TopoDS_Shape insert;
};

Feature instrument(double bezel_radius_mm, int tick_marks);
Feature knob();
Feature buttons();
Feature tray();
/// An air outlet: a filleted frame about a duct with tilted slats and two upright vanes.
Feature vent();

}  // namespace fingerpad::parts
