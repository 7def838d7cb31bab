#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "view/coarse_meshes_vtk.hpp"
#include "view/world_props_vtk.hpp"

class vtkCamera;

namespace fingerpad {

/// What is given up where frames are slow, as they are without a graphics card: nothing, as in a picture;
/// smooth edges; and while the view turns most triangles of large parts as well, as soon as coarse meshes
/// are made. `coarse` does not wait until frames are slow.
enum class Pace { exact, smooth_edges_only, smooth, coarse };

/// Watches how long frames take and whether the view turns, and shows coarse parts meanwhile.
class TurningPace {
 public:
  TurningPace(std::shared_ptr<const World> world, const DrawSpace& space, WorldProps& props)
      : world_(std::move(world)), space_(space), props_(props) {}

  void set_pace(Pace pace) { pace_ = pace; }
  /// Whether the view has come to rest since the last frame, so that another one is to be drawn.
  bool has_come_to_rest() const;
  bool shows_coarse() const { return shown_coarse_; }

  /// Before a frame: shows coarse parts or whole ones.
  void choose(vtkCamera* camera);
  /// After it. @param drew_parts  they were drawn, not put back
  void note(double frame_s, bool drew_parts);
  /// Whether frames have been slow for long enough to do without smooth edges.
  bool gives_up_smooth_edges() const;

 private:
  using Clock = std::chrono::steady_clock;
  void watch(vtkCamera* camera);

  std::shared_ptr<const World> world_;
  DrawSpace space_;
  WorldProps& props_;
  Pace pace_ = Pace::exact;
  double slow_s_ = 0;                ///< time that frames took beyond what is smooth
  std::vector<double> camera_then_;  ///< at the last frame
  std::optional<Clock::time_point> turned_at_;
  bool shown_coarse_ = false;  ///< in the last frame
  bool is_slow_ = false;       ///< the last frame that drew whole parts was
  std::unique_ptr<CoarseMeshes> coarse_;
};

}  // namespace fingerpad
