#pragma once

#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>

#include <array>
#include <cstdint>
#include <vector>

class vtkOpenGLFramebufferObject;

namespace fingerpad {

/// A renderer that keeps what it drew, with its depths, and puts that back where nothing that it depends on
/// has changed: without a graphics card a million triangles take a third of a second, their picture a
/// hundredth.
///
/// What it drew is stale where any of depends_on() differs: its place and the window's size and samples, its
/// camera, its background, its lights, what it shows and the times of all that, and the content that it was
/// told of. Nothing needs to be told for what is an actor's: its mesh, colours, representation, visibility.
///
/// @pre what it shows is opaque, where others draw after it with its depths
class KeptRenderer : public vtkOpenGLRenderer {
 public:
  static KeptRenderer* New();
  vtkTypeMacro(KeptRenderer, vtkOpenGLRenderer);

  /// False: everything is drawn anew each time.
  void set_keeping(bool keeping) { keeping_ = keeping; }
  /// The part of the window that is kept, that of another renderer; without it the renderer's own.
  void keep_box_of(vtkRenderer* other) { box_of_ = other; }
  /// It has no depths: they are neither kept nor put back.
  void set_flat(bool flat) { flat_ = flat; }
  /// What is drawn by items that have no times of their own: another number, another content.
  void set_content(std::uint64_t content) { content_ = content; }
  /// How often it was drawn rather than put back.
  long drawn() const { return drawn_; }

  void DeviceRender() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  KeptRenderer();
  ~KeptRenderer() override;

 private:
  using Box = std::array<int, 4>;  ///< left, bottom, width, height [px]
  Box box();
  std::vector<double> depends_on();
  /// Copies colours and depths between the window's buffer and the kept one.
  enum class Way { keep, put_back };
  void copy(Way way, const Box& box);

  bool keeping_ = false, flat_ = false;
  vtkRenderer* box_of_ = nullptr;
  std::uint64_t content_ = 0;
  long drawn_ = 0;
  std::vector<double> kept_for_;  ///< depends_on() of what is kept; empty: nothing is
  vtkNew<vtkOpenGLFramebufferObject> kept_;
};

}  // namespace fingerpad
