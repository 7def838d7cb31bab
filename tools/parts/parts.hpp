#pragma once

#include <TopoDS_Shape.hxx>

/// The parts that fingerpad's scenes touch, as exact solids in mm, z up. Their outside can be reached from
/// above.
namespace fingerpad::parts {

/// A segment of a car's dashboard, about 600 x 220 x 68: two instrument bezels, three vents, a knob, buttons,
/// a tray.
TopoDS_Shape dashboard();
/// A machined bracket, 130 x 80 x 82: base with pocket and counterbored holes, upright with a bore, two
/// gussets.
TopoDS_Shape bracket();
/// An open box, 150 x 95 x 40, walls of 1.2: bosses, ribs, slots, a connector's opening; lies on its floor.
TopoDS_Shape housing();

}  // namespace fingerpad::parts
