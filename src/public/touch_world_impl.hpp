#pragma once

#include <memory>
#include <vector>

#include "fingerpad/touch_world.hpp"
#include "public/part_surface_impl.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// A world that is still being made.
struct TouchWorld::Impl {
  struct PlacedPart {
    std::shared_ptr<const PartSurface::Impl> surface;
    Surface placed;
  };
  std::vector<PlacedPart> parts;
  std::vector<Surface> planes;
};

}  // namespace fingerpad
