#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/arrow_scale.hpp"
#include "view/blending_renderer_vtk.hpp"
#include "view/chart_column_vtk.hpp"
#include "view/close_up_vtk.hpp"
#include "view/contact_glyphs.hpp"
#include "view/draw_space.hpp"
#include "view/drawing_item_vtk.hpp"
#include "view/input_at.hpp"
#include "view/kept_renderer_vtk.hpp"
#include "view/layout.hpp"
#include "view/overlay.hpp"
#include "view/overlay_room.hpp"
#include "view/place_marks.hpp"
#include "view/pointed_scene.hpp"
#include "view/scene_view_vtk.hpp"
#include "view/side_panels.hpp"
#include "view/stage_words.hpp"
#include "view/theme_device_vtk.hpp"
#include "view/turning_pace_vtk.hpp"
#include "view/view_state.hpp"
#include "view/world_props_vtk.hpp"

class vtkContextActor;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace fingerpad {

/// What a picture and a window have in common: the scene, the close-up of the contact, the charts and the
/// flat parts over them, in one render window.
class Stage {
 public:
  /// @param input     kept by reference
  /// @param charts    a column of charts on the right
  /// @param timeline  a time line at the bottom
  Stage(const ViewInput& input, int width, int height, bool charts, bool timeline);
  ~Stage();

  vtkRenderWindow* window() { return window_; }
  vtkRenderer* scene() { return scene_; }
  WorldProps& world() { return *world_; }
  const DrawSpace& space() const { return space_; }
  const ViewExtent& extent() const { return extent_; }
  const Layout& layout() const { return layout_; }
  ViewState& state() { return state_; }
  const ViewInput& input() const { return input_; }

  using Pace = fingerpad::Pace;
  void set_pace(Pace pace) { pace_->set_pace(pace); }
  /// Whether the view has come to rest since the last frame, so that another one is to be drawn.
  bool has_come_to_rest() const { return pace_->has_come_to_rest(); }
  bool shows_coarse() const { return pace_->shows_coarse(); }
  /// False: every frame draws everything anew. True (the default) draws anew what is stale (KeptRenderer).
  void set_keeping(bool keeping) { keeping_ = keeping; }
  /// How often what is still was drawn rather than put back, and the charts.
  long still_drawn() const { return scene_->drawn(); }
  long charts_drawn() const { return column_.drawn(); }

  /// A view that was fitted and not changed since is fitted again.
  void resize(int width, int height);
  void reset_camera();
  /// From now on what is looked at stands beside the readings, where the window has room for both.
  void keep_clear_of_readings();
  /// All in sight from a direction, or from where it is looked now: in a live touch the finger too.
  void look(const LookFrom& from) { view_.look(from, finger_in_sight()); }
  void look_at_all() { view_.look_at_all(finger_in_sight()); }
  void zoom(double factor) { view_.zoom(factor); }

  /// The moment shown; `speed_m_per_s` may be nan. Without a row only the surfaces are shown.
  void show(const std::optional<TickRecord>& row, double speed_m_per_s);
  /// The law, the method and the surfaces' properties from now on, where they change while it is touched.
  void put(const Scene& scene) { shown_.put(scene); }
  /// The scene and the surfaces as they are at the moment shown; without rows.
  const ViewInput& now() const { return shown_.now(); }
  /// Lists over the scene, and the layout that they stand in: below what has gone wrong.
  SidePanels& panels() { return panels_; }
  Layout panel_layout() const { return below_alarm(words_.alarm, layout_); }
  /// Places that somebody marked, and the distance of two.
  void show_marks(PlaceMarks marks) { marks_ = std::move(marks); }
  void show_chart(Chart chart) { column_.show(std::move(chart)); }
  /// The chart column: zoomed by the wheel, panned by a drag, asked by the mouse over it.
  ChartBoard& charts() { return column_.board(); }
  const ArrowScale& arrow_scale() const { return arrow_scale_; }
  /// What the window says beside its picture.
  StageWords& words() { return words_; }

  /// Brings everything in line with state, camera and moment, and renders.
  void render();

  /// The time under the mouse, on the time line or a chart.
  std::optional<double> time_at(double x_px, double y_px) const;

  /// The line of sight through a pixel of the scene, near to far, draw space [mm].
  std::pair<Vec3, Vec3> line_of_sight(double x_px, double y_px) const {
    return view_.line_of_sight(x_px, y_px);
  }
  /// For one who points at it.
  PointedScene pointed() const;

 private:
  void add_renderers();
  void add_flat();
  void place_renderers();
  void paint_grounds();
  void place(vtkRenderer* renderer, const Box& box);
  void draw();
  std::optional<FingerInSight> finger_in_sight() const;
  std::optional<double> close_up_half_height_mm() const;
  void place_overlay(OverlayFacts& facts, const GlyphInk& ink);
  OverlayFacts overlay_facts() const;
  void project_labels(OverlayFacts& facts, const GlyphChoice& choice);
  void project_marks(OverlayFacts& facts);

  const ViewInput& input_;
  InputAt shown_;
  SidePanels panels_;
  PlaceMarks marks_;
  ViewExtent extent_;
  DrawSpace space_;
  ChartColumn column_;
  bool timeline_;
  Layout layout_;
  ViewState state_;
  std::unique_ptr<WorldProps> world_;
  std::optional<ContactMoment> moment_;
  double speed_m_per_s_ = 0;
  ArrowScale arrow_scale_;
  OverlayPlaces places_;
  StageWords words_;

  bool keeping_ = true;
  std::unique_ptr<TurningPace> pace_;

  vtkNew<vtkRenderWindow> window_;
  // From the back to the front: what is still, and what moves, by one camera; the charts and their paper; all
  // that is flat.
  vtkNew<KeptRenderer> scene_;
  SceneView view_;  ///< by the scene's camera
  vtkNew<BlendingRenderer> moving_;
  vtkNew<vtkRenderer> flat_;
  vtkNew<vtkPolyData> solid_, clear_;
  vtkNew<DrawingItem> item_, readings_item_;
  vtkNew<ThemeDevice> device_, readings_device_;
  std::unique_ptr<CloseUp> close_up_;
};

}  // namespace fingerpad
