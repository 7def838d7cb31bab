#pragma once

#include "contact/every_wall.hpp"
#include "contact/facet_weights.hpp"
#include "contact/fan_memory.hpp"
#include "contact/proxy.hpp"
#include "contact/proxy_views.hpp"

namespace fingerpad {

/// What a proxy remembers to be fast. Where the last look around shows that nothing but the walls that hold
/// the proxy can be met, it takes the proxy where a step would, in closed form:
/// - a flight: a ball that is free of all surfaces; there the proxy is where the finger is;
/// - a slide: walls that hold the proxy, and a ball in which nothing stands in front of them. There the proxy
///   is the finger's foot on the walls.
/// Where that is not known, it declines, and the proxy asks its sight.
class ProxyMemory : public ProxyViews {
 public:
  ProxyMemory(ProxyWorld world, Looks looks) : ProxyViews(std::move(world), looks) {}

  bool carry(ProxyState& state) noexcept override;
  void note_rest(const ProxyState& state) noexcept override;
  bool slide(ProxyState& state) noexcept override;
  std::optional<ProxyStep> step_over(const WayOver& way) noexcept override;
  std::optional<WallPair> nearer_neighbour(const ProxyState& state) noexcept override;
  void let_go() noexcept override;
  void forget() noexcept override;

 private:
  struct Ball {
    Vec3 centre_O = Vec3::Zero();
    double radius_m = 0;

    bool holds(const Vec3& place_O) const noexcept {
      return (place_O - centre_O).squaredNorm() <= radius_m * radius_m;
    }
  };

  /// A ball that the proxy may go about in: free, or with nothing in front of the walls that hold the proxy.
  struct Room : Ball {
    enum class Kind { none, flight, slide } kind = Kind::none;
    int wall_count = 0;  ///< slide
    std::array<ProxyWall, 3> walls_O;
    EveryWall every;  ///< of several walls
    std::array<FacetWeights, 3> facets;

    bool is_slide_on_one() const noexcept { return kind == Kind::slide && wall_count == 1; }
  };

  bool is_way_free(const WayOver& way) noexcept;
  bool land(const WayOver& way) noexcept;
  bool fly(ProxyState& state) noexcept;
  bool slide_on_one(ProxyState& state) noexcept;
  bool slide_on_several(ProxyState& state) noexcept;
  bool extend_slide(const Vec3& from_O, const Vec3& to_O) noexcept;
  bool make_room(std::span<const ProxyWall> walls, const Vec3& centre_O, const Vec3& from_O,
                 const Vec3& to_O) noexcept;
  ContactHold hold_over(const ProxyWall& wall, double share_m, const Vec3& place_O,
                        const Vec3& weights) const noexcept;

  Room room_;
  FanMemory fan_;
};

}  // namespace fingerpad
