#include "view/kept_renderer_vtk.hpp"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtk_glew.h>

namespace fingerpad {

vtkStandardNewMacro(KeptRenderer);

KeptRenderer::KeptRenderer() = default;
KeptRenderer::~KeptRenderer() = default;

KeptRenderer::Box KeptRenderer::box() {
  Box box{};
  vtkRenderer* const whose = box_of_ != nullptr ? box_of_ : this;
  whose->GetTiledSizeAndOrigin(&box[2], &box[3], &box[0], &box[1]);
  return box;
}

std::vector<double> KeptRenderer::depends_on() {
  std::vector<double> all;
  const auto add = [&all](const auto* values, int count) {
    for (int i = 0; i < count; ++i) all.push_back(static_cast<double>(values[i]));
  };
  const auto add_one = [&all](auto value) { all.push_back(static_cast<double>(value)); };
  add(box().data(), 4);
  add(this->RenderWindow->GetSize(), 2);
  add_one(this->RenderWindow->GetMultiSamples());
  add(this->GetViewport(), 4);
  add_one(this->GetGradientBackground());
  add(this->GetBackground(), 3);
  add(this->GetBackground2(), 3);

  vtkCamera* const camera = this->GetActiveCamera();
  add(camera->GetPosition(), 3);
  add(camera->GetFocalPoint(), 3);
  add(camera->GetViewUp(), 3);
  add(camera->GetClippingRange(), 2);
  add_one(camera->GetParallelProjection());
  add_one(camera->GetParallelScale());
  add_one(camera->GetViewAngle());

  vtkCollectionSimpleIterator at;
  vtkLightCollection* const lights = this->GetLights();
  for (lights->InitTraversal(at); vtkLight* light = lights->GetNextLight(at);) {
    add_one(light->GetSwitch());
    add_one(light->GetIntensity());
    add(light->GetDiffuseColor(), 3);
  }
  vtkPropCollection* const props = this->GetViewProps();
  for (props->InitTraversal(at); vtkProp* prop = props->GetNextProp(at);) {
    add_one(prop->GetVisibility());
    add_one(prop->GetVisibility() != 0 ? prop->GetRedrawMTime() : 0);
  }
  add_one(content_);
  return all;
}

void KeptRenderer::DeviceRender() {
  if (!keeping_) {
    kept_for_.clear();
    ++drawn_;
    this->Superclass::DeviceRender();
    return;
  }
  if (!kept_for_.empty() && depends_on() == kept_for_) {
    copy(Way::put_back, box());
    return;
  }
  ++drawn_;
  this->Superclass::DeviceRender();
  copy(Way::keep, box());
  kept_for_ = depends_on();  // after it, since drawing makes tables of colours and the like
}

void KeptRenderer::copy(Way way, const Box& box) {
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(this->RenderWindow);
  vtkOpenGLState* const state = window->GetState();
  window->MakeCurrent();
  state->PushFramebufferBindings();
  if (way == Way::keep) {
    int size[2] = {0, 0};
    kept_->GetLastSize(size);
    const int samples = window->GetMultiSamples();
    if (kept_->GetFBOIndex() == 0 || size[0] != box[2] || size[1] != box[3] ||
        kept_->GetMultiSamples() != samples) {
      kept_->ReleaseGraphicsResources(window);
      kept_->SetContext(window);
      // As the window makes its own: samples and depths can only be copied between buffers of one format.
      constexpr int colours = 1, depth_bits = 32;
      kept_->PopulateFramebuffer(box[2], box[3], true, colours, VTK_UNSIGNED_CHAR, true, depth_bits, samples,
                                 window->GetStencilCapable() != 0);
    }
  }
  vtkOpenGLFramebufferObject* const drawn = window->GetRenderFramebuffer();
  vtkOpenGLFramebufferObject* const from = way == Way::keep ? drawn : kept_.Get();
  vtkOpenGLFramebufferObject* const to = way == Way::keep ? kept_.Get() : drawn;
  from->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  from->ActivateReadBuffer(0);
  to->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  to->ActivateDrawBuffer(0);
  {
    const vtkOpenGLState::ScopedglEnableDisable whole(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    const int x = box[0], y = box[1], right = x + box[2], top = y + box[3];
    const unsigned int bits = flat_ ? GL_COLOR_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
    if (way == Way::keep) {
      state->vtkglBlitFramebuffer(x, y, right, top, 0, 0, box[2], box[3], bits, GL_NEAREST);
    } else {
      state->vtkglBlitFramebuffer(0, 0, box[2], box[3], x, y, right, top, bits, GL_NEAREST);
    }
  }
  state->PopFramebufferBindings();
}

void KeptRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  kept_->ReleaseGraphicsResources(window);
  kept_for_.clear();
  this->Superclass::ReleaseGraphicsResources(window);
}

}  // namespace fingerpad
