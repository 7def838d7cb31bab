#pragma once

#include <string>

#include "part/verdict.hpp"

namespace fingerpad {

/// Whether a mesh file was read in the wrong unit, in words that name a likely one; empty where its size is
/// usual. CAD files carry no unit, and a scan in metres that is read in millimetres is a grain of sand.
///
/// Rule: parts that a finger touches are 2 mm to 20 m long (a unit cube is 1 mm in mm). For another, the
/// first of m, mm, in and cm that makes it 10 mm to 5 m long is likely. A STEP file knows its own.
std::string unit_hint(const Verdict& verdict, double metres_per_unit);

}  // namespace fingerpad
