#pragma once

namespace fingerpad {

/// How a surface answers touch; keys of [[part]] and [[plane]] in a scene.
struct SurfaceProperties {
  double stiffness_n_per_m = 1000;  ///< normal force per depth, > 0
  double damping_n_s_per_m = 0;     ///< normal force per speed into the surface, >= 0
  double mu_static = 0.3;           ///< friction gives way at this share of the normal force, >= mu_dynamic
  double mu_dynamic = 0.2;          ///< a sliding finger feels this share of it, >= 0
};

}  // namespace fingerpad
