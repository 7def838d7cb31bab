#pragma once

#include <array>

#include "base/types.hpp"

namespace fingerpad {

class ClosestMemory;

/// A surface that holds the finger.
struct ContactHold {
  int surface = -1;               ///< index into the surfaces that the method was made for
  int triangle = -1;              ///< index into Part::triangles; -1: a plane
  Vec3 point_W = Vec3::Zero();    ///< the surface's point [m]
  Vec3 normal_W = Vec3::UnitZ();  ///< outward, unit
  double share_m = 0;             ///< its part of the depth, along its own normal
};

/// Where the finger touches.
struct Contact {
  int hold_count = 0;  ///< 0: the finger is free, and of what is below only the flags mean anything
  std::array<ContactHold, 3> holds;  ///< greatest share first
  double depth_m = 0;                ///< > 0
  Vec3 point_W = Vec3::Zero();       ///< S, the surface's point [m]
  Vec3 normal_W = Vec3::UnitZ();     ///< that the finger feels: outward, unit
  bool started = false;              ///< a method that remembers has begun anew here: see ContactMethodEntry
  bool placed = true;  ///< false: it found no place where the finger fits, and tries again with each tick
  bool broken_off = false;  ///< the method stopped before it was at rest, so that the tick's work has a bound
  bool behind = false;      ///< that was so in this tick or before, and it has not been at rest since
};

/// How contact is found: one tick of a finger to where it touches. It may keep what it likes from tick to
/// tick; each finger has one of its own.
class ContactMethod {
 public:
  virtual ~ContactMethod() = default;
  /// @param p_WQ  the finger's centre [m], finite
  /// @param dt_s  since the last call [s], > 0
  /// @returns     good until the next call. Finite. noexcept, allocates nothing.
  virtual const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept = 0;
  /// What it keeps of a surface from query to query, for other searches near the finger; null if nothing.
  virtual const ClosestMemory* memory_of(int /*surface*/) const noexcept { return nullptr; }
  /// Forgets the past, as before the first tick.
  virtual void reset() noexcept = 0;
};

}  // namespace fingerpad
