#pragma once

#include <memory>
#include <string>

#include "view/camera_look.hpp"
#include "view/small_run.hpp"
#include "view/small_shape.hpp"

namespace fingerpad {

/// Small pictures of shapes with a path over them, coloured by force, rendered one after the other.
class Thumbnails {
 public:
  /// Starts a virtual screen where there is none. Throws Error as screen_to_draw_on does.
  Thumbnails(int width, int height);
  ~Thumbnails();
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;

  /// @returns a JPEG file's bytes; empty where there is nothing to be seen
  std::string jpeg(const SmallShape& shape, const SmallPath& path, double max_force_n, const LookFrom& look);

 private:
  class Studio;
  std::unique_ptr<Studio> studio_;
};

/// From where a shape is looked at so that the contact is in sight: a little aside of its mean normal.
LookFrom telling_look(const Vec3& facing_W);

}  // namespace fingerpad
