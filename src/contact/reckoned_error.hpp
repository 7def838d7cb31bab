#pragma once

#include <array>
#include <span>
#include <vector>

namespace fingerpad {

struct ContactMethodEntry;
class Normals;
struct SurfacePlace;

/// How a finger presses on a part.
struct Press {
  double stiffness_n_per_m = 1000;
  double finger_radius_m = 0;
  double greatest_force_n = 10;

  /// Smaller forces are held to errors of this one [N].
  double least_force_n() const noexcept { return greatest_force_n / 10; }
  double greatest_depth_m() const noexcept { return greatest_force_n / stiffness_n_per_m; }
};

/// How far a way to touch is off the smooth surface that a part's facets stand for, by reckoning: where the
/// part is at its worst, since a finger may stay there.
struct ReckonedError {
  static constexpr std::size_t forces = 7;  ///< from the least to the greatest, each so many times the last
  double force_share = 0;    ///< of the force, or of Press::least_force_n, on 99 % of the finger's way in a
                             ///< region (SurfacePlace), at the force at which that is the largest
  double mean_tilt_rad = 0;  ///< of the force's direction, over a region's places, under the greatest force
  /// The same two under each force, in the region that is the worst for it.
  std::array<double, forces> force_shares{}, mean_tilts_rad{};
  /// Of the force: by how much the proxy falls behind where the finger goes round a quarter of a rounding
  /// faster than a proxy may follow, on more than a hundredth of the way in a region; and the rounding.
  double behind_share = 0, behind_m = 0;
};

/// The error in one region of a part.
struct RegionError {
  int region = 0;  ///< SurfacePlace::region
  ReckonedError error;
};

/// Reckons it place by place. With the force F, the stiffness k, the finger's centre h = radius - F/k over
/// the surface, the surface's curvature c and u = h c:
///
///   along the force   the facet stands off the surface by its sag: an error of k sag, whatever the force;
///   across it         the normal that is shown is off by `off` (NormalsEntry::off_rad) at one place, and
///                     shown at another: the finger's foot on the facet, whose normal is turned by t, lies
///                     off that on the surface by h t, where the surface is turned by t |u| (u < 0, the
///                     finger's centre on the side of the centre of curvature; at most t) or t u / (1 + u):
///                     beyond, edges of the facets hold the foot. So: F (off + t |u|). Inside a rounding
///                     that is round both ways, as a ball is, they do not hold a proxy's: t |u| / (1 + u).
///                     Facets' own normals know no foot: they are off by t, less where the finger rolls over
///                     the edges between them (t / (1 + u), u > 0), and more under a proxy inside a rounding,
///                     which leaves a facet when the finger is past what lies straight under it:
///                     t / (1 + u), u < 0, up to three quarters of the radius deep
///                     (ProxyLimits::rounds_deep). Deeper it falls behind by more than a facet (study
///                     contact: 0.7 of the force at 4/5 of a fillet's radius), which counts as the whole
///                     force.
///
/// A ball in a hollow, R = -1/c: its centre's place among facets whose sags differ by d is that of the
/// nearest of all that turn by up to sqrt(2 d / (R - radius)), which outdoes the facet's own turn t where d
/// is a share of the sag R t^2 / 2 and the radius near to R: all tilts are larger by sqrt(d / sag / (1 -
/// radius/R)).
///
/// A finger dwells at a place for as long as its centre has way to go there, at the height h: (1 + u) of the
/// place's area, the offset surface's; none where that is not above 0, in hollows too tight for a ball, and
/// over roundings tighter than a point is deep, from which it slides off at once. A region of
/// less than a two-thousandth of the part's places is not judged: they are too few.
///
/// The patches' shown normals, which all are held against, are off the surface where they fit their patches
/// badly: all are off by so much more (NormalsEntry::off_rad). Of a facet too low for its file's digits
/// nothing is known: all that is off there is a right angle.
///
/// A method that touches the patches themselves has no foot on facets. A patch whose own normals are turned
/// off the shown ones by s shows normals off by 5/4 s, and stands off by half the height that a slope of s
/// makes over the facet's width. Inside a rounding that turns the foot on the patch too, as above by
/// 5/4 s |u| / (1 + u): 5/4 s / (1 + u) in all.
///
/// Held against exact surfaces (study contact: contact_accuracy.csv, auto_judged.csv) the first is right to a
/// tenth; of the last the tilt is right to a tenth where it is a hundredth or more, and the height is between
/// one and four times the error.
/// noexcept but for memory.
/// @param places  region by region
std::vector<RegionError> region_errors(std::span<const SurfacePlace> places, const Press& press,
                                       const ContactMethodEntry& method, Normals normals);

/// The worst of them.
ReckonedError reckoned_error(std::span<const SurfacePlace> places, const Press& press,
                             const ContactMethodEntry& method, Normals normals);

/// By how much of the least force the force is off where the vertices are off their places by so much, along
/// it. Less than a hundredth counts as nothing.
double rounding_share(const Press& press, double rounding_m) noexcept;

/// Adds that to what is reckoned.
void add_rounding(ReckonedError& error, const Press& press, double rounding_m) noexcept;

}  // namespace fingerpad
