#pragma once

#include <vector>

#include "view/camera_look.hpp"
#include "view/draw_space.hpp"

class vtkCamera;
class vtkRenderer;

namespace fingerpad {

/// Sets a parallel camera that sees the contact region from its outside, with no wall before it (free_sight),
/// and enough of the part around it to know where it is.
/// @param shown  the tick that is; may be null
/// @param width_to_height  of the renderer's viewport
void set_scene_camera(vtkRenderer* renderer, const ViewInput& input, const TickRecord* shown,
                      const ViewExtent& extent, const DrawSpace& space, double width_to_height);

/// Sets a parallel camera that sees everything from a direction.
void set_look(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent, const DrawSpace& space,
              const LookFrom& look, double width_to_height);

/// A finger that is to be in sight whole, as it is drawn: some of it is as large as the view makes it.
struct FingerInSight {
  Vec3 tip_W = Vec3::Zero(), back_W = Vec3::UnitZ();  ///< back: unit, from the tip along the finger
  double radius_m = 0, length_m = 0;                  ///< it is at least so long
  double length_px = 0;                               ///< and so
};

/// Widens what set_look made to hold the finger too, unless that is far from all parts.
/// @param height_px  of the renderer's viewport
void take_in_finger(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent,
                    const DrawSpace& space, const FingerInSight& finger, double width_to_height,
                    double height_px);

/// Sets a parallel camera straight over a contact: Cx to the right, Cy upwards, `half_height_mm` from the
/// middle to the top edge.
void set_close_up_camera(vtkRenderer* renderer, const Vec3& contact_mm, const Mat3& frame,
                         double half_height_mm);

/// From where a camera looks, where to, which way is up, and how near: what a person changes of it.
std::vector<double> view_of(vtkCamera* camera);

/// World axes on the screen: column i is axis i as (right, up, towards the eye).
Mat3 axes_on_screen(vtkRenderer* renderer);

}  // namespace fingerpad
