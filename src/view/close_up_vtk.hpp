#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "view/blending_renderer_vtk.hpp"
#include "view/contact_glyphs.hpp"
#include "view/layout.hpp"
#include "view/triangles_in_sight.hpp"
#include "view/world_props_vtk.hpp"

class vtkActor;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace fingerpad {

/// The contact from near by, in a box over the scene. Of the parts it draws what is near the contact, or it
/// would cost as much as the scene.
class CloseUp {
 public:
  /// @param input, world  kept by reference
  CloseUp(const ViewInput& input, const DrawSpace& space, WorldProps& world);

  void add_to(vtkRenderWindow* window);
  std::vector<vtkRenderer*> renderers() { return {scene_, marks_}; }
  vtkRenderer* scene() { return scene_; }

  void hide();
  /// @param box      in the window [px]
  /// @param limit_n  mu_s n at this moment [N]
  void show(const ContactMoment& moment, const Box& box, const Box& window, double half_height_mm,
            double limit_n, const GlyphInk& ink);

 private:
  void show_parts_in(const CloseUpSight& sight);

  const ViewInput& input_;
  DrawSpace space_;
  WorldProps& world_;
  vtkNew<BlendingRenderer> scene_, marks_;
  vtkNew<vtkPolyData> solid_, clear_;
  struct Near {
    vtkSmartPointer<vtkActor> body, creases;
    bool made = false;  ///< for the sight that is shown, if the part was shown then
  };
  CloseUpSight shown_for_;
  std::vector<Near> near_;  ///< one a surface; empty for planes
};

/// Adds an actor for marks, in front of the surface that they lie on.
void add_glyphs(vtkRenderer* renderer, vtkPolyData* mesh, bool outsides_alone = false);

/// A key light over the left shoulder and a fill light: both move with the camera.
void light(vtkRenderer* renderer);

}  // namespace fingerpad
