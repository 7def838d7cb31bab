#include "touch/error_memory.hpp"

#include "touch/contact_case.hpp"

namespace fingerpad {

const ReckonedError& ErrorMemory::error(const ContactCase& on, const ContactMethodEntry& method,
                                        Normals normals) {
  const PartMeasures& part = on.contact.part;
  const Key key{&part,
                on.finer,
                on.press.stiffness_n_per_m,
                on.press.finger_radius_m,
                on.press.greatest_force_n,
                &method,
                normals.operator->()};
  const auto found = errors_.find(key);
  if (found != errors_.end()) return found->second;
  ReckonedError error = reckoned_error(places(part, on.finer), on.press, method, normals);
  add_rounding(error, on.press, part.rounding_m);
  return errors_.emplace(key, error).first->second;
}

const std::vector<SurfacePlace>& ErrorMemory::places(const PartMeasures& part, int finer) {
  if (finer == 1) return part.places;
  if (finer_part_ == &part && finer_ == finer) return finer_places_;
  finer_part_ = &part;
  finer_ = finer;
  finer_places_ = part.places;
  for (SurfacePlace& place : finer_places_) {
    if (!place.is_told) continue;  // nor is it of a smaller facet
    place.sag_m /= finer * finer;
    for (double* number : {&place.facet_rad, &place.smooth_rad, &place.patch_rad, &place.width_m})
      *number /= finer;
  }
  return finer_places_;
}

}  // namespace fingerpad
