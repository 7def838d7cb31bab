#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "fingerpad/part_surface.hpp"
#include "part/verdict.hpp"

namespace fingerpad {

/// What copies of a PartSurface share.
struct PartSurface::Impl {
  std::shared_ptr<const Part> part;
  std::shared_ptr<const TriangleTree> tree;
  Verdict verdict;
  std::string hash;  ///< of the file's bytes; empty for a part made in code

  /// Its walls and edges, measured when first asked for.
  const PartMeasures& measures() const {
    std::call_once(measured_, [this] { measures_ = measure_part(*part, *tree); });
    return measures_;
  }

 private:
  mutable std::once_flag measured_;
  mutable PartMeasures measures_;
};

}  // namespace fingerpad
