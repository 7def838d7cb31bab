#pragma once

#include <memory>
#include <utility>

#include "fingerpad/finger.hpp"
#include "scene/scene.hpp"
#include "touch/touch.hpp"

namespace fingerpad {

/// A finger's scene and world, kept for those that record it, and its touch.
struct Finger::Impl {
  Scene scene;
  std::shared_ptr<const World> world;
  ContactChoice contact;
  Touch touch;

  Impl(Scene its_scene, std::shared_ptr<const World> its_world)
      : scene(std::move(its_scene)),
        world(std::move(its_world)),
        contact(settled_contact(scene, *world)),
        touch(world, scene) {}
};

}  // namespace fingerpad
