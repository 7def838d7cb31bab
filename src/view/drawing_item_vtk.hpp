#pragma once

#include <vtkContextItem.h>
#include <vtkObjectFactory.h>

#include <memory>
#include <vector>

#include "view/drawing.hpp"

namespace fingerpad {

/// Paints drawings over a renderer, one over the other.
class DrawingItem : public vtkContextItem {
 public:
  static DrawingItem* New();
  vtkTypeMacro(DrawingItem, vtkContextItem);

  void show(std::vector<std::shared_ptr<const Drawing>> drawings);
  bool Paint(vtkContext2D* painter) override;

 private:
  std::vector<std::shared_ptr<const Drawing>> drawings_;
};

}  // namespace fingerpad
