#pragma once

#include "contact/proxy_surroundings.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {

/// A surface that holds the proxy.
struct ProxyHold {
  int surface = -1;
  int triangle = -1;              ///< index into Part::triangles; -1: a plane
  Vec3 point_W = Vec3::Zero();    ///< the surface's point under the proxy [m]
  Vec3 normal_W = Vec3::UnitZ();  ///< unit, towards the proxy; shaded as Normals says
  double share_m = 0;             ///< multiplier: its part of the depth, along its own normal
};

/// Where the proxy stands against the finger.
struct ProxyContact {
  bool placed = true;    ///< false: a start found no place for the ball; the next move tries again
  bool started = false;  ///< this move put the proxy down anew
  bool touching = false;
  bool settled = true;          ///< false: the proxy is still on its way to where it is closest to the finger
  Vec3 proxy_W = Vec3::Zero();  ///< centre of the ball, its skin taken off [m]
  double depth_m = 0;           ///< from the finger to it
  Vec3 direction_W = Vec3::UnitZ();  ///< unit, from the finger to it
  Vec3 normal_W = Vec3::UnitZ();     ///< as that, shaded: see Proxy
  Vec3 point_W = Vec3::Zero();     ///< S: the surface's point; of several, and on the way, the ball's lowest
  int hold_count = 0;              ///< >= 1 while touching
  std::array<ProxyHold, 3> holds;  ///< greatest share first; on the way: those of before
};

/// A god-object (Zilles & Salisbury 1995; for a ball Ruspini, Kolarov & Khatib 1997): a ball of the finger's
/// radius that goes where the finger goes but never crosses a surface, and holds out on the side where it
/// came from. What pushes the finger is the way from it to the proxy.
///
/// Sound: a step is the projection of the finger onto half spaces that each triangle in view leaves free,
/// with the start in all of them, so it crosses nothing however often it is repeated and wherever it ends;
/// triangles block from both sides, whatever their winding. Steps repeat until the projection stays, which
/// is a place from where every short way nearer to the finger is blocked. Lengths compare with the parts'
/// size only.
///
/// Shaded normals: each wall that holds the proxy shades its own normal, which turns it by an angle that the
/// facets meeting there span. The normal shown for all of them together is the way from the finger to the
/// proxy turned by the mean of these turns, each weighted with its wall's share. So it stays within the
/// greatest of the walls' own angles of the way, however sharp the corner (a sum of shaded normals, in which
/// large shares nearly cancel, does not), and a wall whose share vanishes has no say any more.
///
/// Bounded steps: with `facet` the push (depth_m along normal_W) changes in a tick by at most the finger's
/// motion and the proxy's, which is twice as much or a share of the depth: see move(). With shaded normals it
/// changes by no more: a turn that jumps, as walls come and go, follows as fast as this leaves room for, and
/// until then is at most as wide as it was. A hop over a smooth edge adds 7 % of the depth, which nobody
/// feels; one that would add more is shown over as many ticks as that takes, and the next hop waits for it.
class Proxy {
 public:
  /// @param smooth  over edges that are no creases the proxy goes on to the neighbour that is nearer to the
  /// finger, as the closest point does: facets there stand for a smooth surface, and what they hold back is
  /// not its shape
  Proxy(std::vector<ProxySurface> surfaces, double radius_m, Normals normals);

  /// Forgets where the proxy is: the next move starts anew.
  void reset() noexcept;

  /// Takes the proxy after the finger.
  ///
  /// The first move after a reset puts it there, or, where the ball would not fit, at the nearest place that
  /// is outside of all surfaces. In contact the proxy goes at most twice as far as the finger in a tick
  /// (or, where the finger rests, by the share dt/0.5 s of the depth), so that a finger pressed in deep that
  /// slips off an edge is let go within a motion and not within a tick.
  /// @param p_WQ  finite
  /// noexcept, allocates nothing.
  const ProxyContact& move(const Vec3& p_WQ, double dt_s) noexcept;

  /// Where the ball's centre stands, its skin included [m]; the finger's place where nothing holds it.
  Vec3 ball_W() const noexcept { return place_ + around_.centre_W(); }
  /// What the ball keeps from every surface: radius and skin [m].
  double clearance_m() const noexcept { return around_.clearance_m(); }

 private:
  /// The weights of a facet's corners at the foot of a place.
  struct FacetWeights {
    Vec3 corner = Vec3::Zero();   ///< its first, where they are 1, 0, 0 ...
    Mat3 weights = Mat3::Zero();  ///< ... and how they change with the place from there, a row each

    Vec3 at(const Vec3& place) const noexcept { return weights * (place - corner) + Vec3::UnitX(); }
  };
  /// What the last look around allows without another: to fly in a ball that is free, or to slide along the
  /// walls that hold the proxy within a ball where nothing else stands in front of them.
  struct Cruise {
    enum class Kind { none, flight, slide } kind = Kind::none;
    Vec3 centre = Vec3::Zero();  ///< of the ball, relative to the world's, as all here
    double room_m = 0;
    int wall_count = 0;              ///< slide
    std::array<ProxyWall, 3> walls;  ///< seen from the world's centre
    std::array<FacetWeights, 3> facets;

    bool has_room(const Vec3& place) const noexcept {
      return (place - centre).squaredNorm() <= room_m * room_m;
    }
  };
  /// Facets that share a smooth vertex with a wall's triangle and lie behind it, as walls seen from the
  /// world's centre.
  struct Fan {
    int surface = -1, triangle = -1;
    double side = 0;
    std::array<ProxyWall, 24> neighbours;
    std::array<double, 24> per_slope;  ///< 1/|difference of a neighbour's and the wall's normal|
    int count = 0;
    Vec3 clear_goal = Vec3::Zero();  ///< no neighbour is nearer than the wall to a finger ...
    double clear_m = -1;             ///< ... that is within so much of here
  };
  /// Where the proxy slides on it looks around from so much of the view's reach ahead.
  static constexpr double lead = 0.4;
  /// A change of the push by less than this share of it is not felt: fingers tell 6 to 7 % apart.
  static constexpr double unfelt_share = 0.07;

  double widest_view() const noexcept;
  void start(const Vec3& goal) noexcept;
  bool cruise(const Vec3& goal) noexcept;
  bool slide_on_one(const Vec3& goal) noexcept;
  bool slide_on_several(const Vec3& goal) noexcept;
  bool is_in_room(const Vec3& place) const noexcept;
  bool land(const ProxyWall& wall, const Vec3& from, const Vec3& to) noexcept;
  bool extend_slide(const Vec3& place) noexcept;
  bool make_room(std::span<const ProxyWall> walls, const Vec3& centre, const Vec3& place) noexcept;
  bool fly(const Vec3& goal) noexcept;
  void suit_view() noexcept;
  void settle(const Vec3& goal, double& budget_m) noexcept;
  void follow(const Vec3& goal, double budget_m) noexcept;
  bool advance(const ProxyStep& step, const Vec3& goal, double& budget_m) noexcept;
  bool is_at_rest(const ProxyStep& step) const noexcept;
  bool has_come_to_rest() const noexcept;
  const ProxyWall* nearer_neighbour(const Vec3& goal) noexcept;
  void look_towards(const Vec3& far, double way_m) noexcept;
  bool hop(const Vec3& goal) noexcept;
  bool is_felt(const Vec3& goal) const noexcept;
  bool roll(const Vec3& goal, double budget_m) noexcept;
  bool go_over(const ProxyWall& here, const ProxyWall& there, const Vec3& goal, double budget_m) noexcept;
  void remember() noexcept;
  FacetWeights weights_of(const ProxyWall& wall) const noexcept;
  void remember_neighbours() noexcept;
  void remember_fan(int corner) noexcept;
  void report(const Vec3& goal) noexcept;
  void report_held(const Vec3& goal, const ProxyProjection& p) noexcept;
  void report_underway(const Vec3& goal) noexcept;
  Vec3 turn_of_holds(std::span<const ProxyWall> walls) const noexcept;
  void show(const Vec3& shaded) noexcept;
  Vec3 normal_towards(const Vec3& shaded, double most_m) const noexcept;
  double most_step_m() const noexcept;
  ProxyHold hold_at(const ProxyWall& wall, double share_m) const noexcept;
  ProxyHold hold_over(const ProxyWall& wall, double share_m, const Vec3& weights) const noexcept;
  Vec3 shaded_W(const ProxyWall& wall, const TrianglePoint& at) const noexcept;

  ProxySurroundings around_;
  Normals normals_;

  bool placed_ = false;
  Vec3 place_ = Vec3::Zero();  ///< of the ball's centre, relative to the world's
  Vec3 last_goal_ = Vec3::Zero();
  double finger_m_ = 0;    ///< how far the finger went in this tick
  double rest_share_ = 0;  ///< of the depth, by which a resting finger's proxy goes on in this tick
  bool hopped_ = false;    ///< over a smooth edge, in this tick
  bool lags_ = false;      ///< a hop is still on its way to be shown
  Vec3 last_push_ = Vec3::Zero(), last_direction_ = Vec3::UnitZ();  ///< what the last tick showed
  double reach_m_ = 0;  ///< of a view; grows and shrinks with what there is to see
  Vec3 hold_place_ = Vec3::Zero();
  ProxyStep hold_;  ///< the last step, from hold_place_, with the walls that stopped it
  Cruise cruise_;
  Fan fan_;
  ProxyContact contact_;
};

}  // namespace fingerpad
