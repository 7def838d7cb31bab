#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "contact/normals.hpp"
#include "contact/reckoned_error.hpp"
#include "contact/surface_places.hpp"

namespace fingerpad {

struct ContactCase;
struct PartMeasures;

/// Reckoned errors, each reckoned once: they follow from a part's places and the press alone, whatever the
/// tolerances. The measures that it was asked about outlive it.
class ErrorMemory {
 public:
  const ReckonedError& error(const ContactCase& on, const ContactMethodEntry& method, Normals normals);
  /// How many were reckoned, which is nearly all that a choice costs.
  long reckoned() const noexcept { return static_cast<long>(errors_.size()); }

 private:
  /// The measures, finer, press and pair.
  using Key = std::tuple<const PartMeasures*, int, double, double, double, const ContactMethodEntry*,
                         const NormalsEntry*>;

  const std::vector<SurfacePlace>& places(const PartMeasures& part, int finer);

  std::map<Key, ReckonedError> errors_;
  /// Of the last part that was asked for with smaller facets.
  std::vector<SurfacePlace> finer_places_;
  const PartMeasures* finer_part_ = nullptr;
  int finer_ = 1;
};

}  // namespace fingerpad
