#pragma once

#include "contact/proxy_sight.hpp"

namespace fingerpad {

/// The numbers that only the speed of a proxy depends on.
struct ProxyMemoryLimits {
  /// Triangles in view that are kept at hand; a vertex with a larger fan asks for more, but for no more than
  /// the second ...
  static constexpr int usual_view = 256, most_usual_view = 1024;
  /// ... and where a ball fits so well into its surroundings that no view has so few: a bore of its own
  /// radius with 1,440 facets. Of more than these the trees are asked anew with each pass.
  static constexpr int richest_view = 3072;
  /// Packets of triangles that a search may look at; where facets are so slender that all their boxes
  /// overlap it is as many however near one looks.
  static constexpr int most_packets = 8192;
  /// A view of about so many triangles pays: more are sorted out for nothing, fewer are soon left behind.
  static constexpr int poor_view = 8, rich_view = 32;
  /// Up to so many triangles a pass costs too little to be told from another.
  static constexpr std::size_t small_view = 256;
  /// By how much a poor view grows and a rich one shrinks, a search.
  static constexpr double growth = 1.2, shrinkage = 0.7;
  /// However rich, a view reaches as far as the finger goes in so many ticks, and by this share of the
  /// clearance: facets much smaller than either are many at any reach.
  static constexpr double least_ticks = 2, least_share = 1.0 / 32;
  /// The first view's reach, as a share of the extent.
  static constexpr double first_view = 0.01;
  /// A view that still shows this share of what was asked for serves again.
  static constexpr double serves_again = 0.5;
  /// Where the proxy slides on, it looks around from so much of the view's reach ahead.
  static constexpr double lead = 0.4;
  /// For a way over an edge so many times as much as the way is to be in view: hops come in rows.
  static constexpr double past_edge = 3;
  /// A view too rich for what is kept at hand is made smaller by this factor, so often.
  static constexpr double cut = 0.25;
  static constexpr int most_cuts = 6;
  /// Where even this share of the clearance shows too many, so does any.
  static constexpr double hopeless_share = 1.0 / 512;
  /// Farther than this from a part, in its sizes, the distance to its box is near enough to the truth.
  static constexpr double far_from_box = 4;
  /// Flights through free balls in a tick, each to this share of the ball, so that it ends in front of what
  /// bounds it.
  static constexpr int most_flights = 8;
  static constexpr double flight_share = 1 - 1e-9;
  /// A bound that is used to leave something out is widened by this against rounding.
  static constexpr double rounding = 1e-12;
};

/// A triangle in a proxy's view, and what is known of its distance. The distance to a triangle is a convex
/// function of the place that changes no faster than the place does, so that one look bounds it everywhere.
struct NearTriangle {
  Vec3 towards_P = Vec3::Zero();  ///< unit, from the triangle to where it was looked at from
  double level_m = 0;             ///< the gap that the tangent there leaves at the part's centre
  double gap_m = 0;               ///< distance from there less the clearance
  int triangle = -1;
  bool seen = false;  ///< looked at so far; most stand behind the wall that holds the proxy and never are
  TriangleCorners corners;
  Vec3 seen_from_P = Vec3::Zero();

  void look_from(const Vec3& place_P, double clearance_m) noexcept {
    if (seen && seen_from_P == place_P) return;
    const TriangleApproach approach = approach_triangle(corners, place_P);
    seen = true;
    seen_from_P = place_P;
    towards_P = approach.towards;
    gap_m = approach.distance_m - clearance_m;
    level_m = gap_m - towards_P.dot(place_P);
  }

  /// The gap that the tangent leaves at a place; the true one is no smaller.
  double least_gap_m(const Vec3& place_P) const noexcept { return level_m + towards_P.dot(place_P); }
};

/// A proxy's sight that keeps what its last search of the trees found. From a place nearby, these triangles
/// are all that can be within what is left of that search's reach; and what one look at a triangle showed
/// bounds its distance from everywhere, so that most are passed over. Speed alone: the walls of a step are
/// those that a search would find. A view may end a step short of the finger, though, where a search made for
/// it would not; the proxy then goes on from there.
class ProxyViews : public ProxySight {
 public:
  ProxyViews(ProxyWorld world, Looks looks);

  ProxyStep step(const Vec3& place_O, const Vec3& goal_O, double most_m) noexcept override;
  ProxyStep step_over(const Vec3& edge_O, const Vec3& goal_O, const ProxyWall& first,
                      double rest_m) noexcept override;
  bool is_way_free(const Vec3& place_O, const Vec3& over, const Vec3& far,
                   const ProxyWall& here) noexcept override;
  void let_go() noexcept override;
  void forget() noexcept override;

 protected:
  /// Looks around where a view that shows as far as `need_m` will do; a search is made from `ahead` of the
  /// place, which is nearer than the usual reach.
  void look_ahead(const Vec3& place_O, double need_m, const Vec3& ahead) noexcept;
  /// Sees to a view that shows the way over an edge to `far`, and some more in this direction.
  /// @param way_m  to the edge
  void look_over_edge(const Vec3& place_O, const Vec3& far, double way_m) noexcept;
  bool is_seen_free(const Vec3& over, const ProxyWall& here) noexcept;
  /// How far one can go from a centre in view and, in front of all these walls, meet no other [m].
  /// @param walls  seen from the place looked around from
  double room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre_O) noexcept;
  /// The room around a place: no surface comes nearer to any place within it than the clearance. Negative
  /// where the clearance is missed. Not looked for beyond `enough_m`.
  double room_m(const Vec3& place_O, double enough_m) noexcept;
  bool is_clear_of_planes(const Vec3& place_O, int but) const noexcept;

  /// Where the trees were searched from.
  const Vec3& search_place_O() const noexcept { return search_place_O_; }

  double finger_m_ = 0;      // how far the finger went in this tick
  double view_reach_m_ = 0;  // of the next search; grows and shrinks with what there is to see

 private:
  struct PartView {
    Vec3 at_P = Vec3::Zero();  ///< the place looked around from
    bool within_reach = false;
    std::size_t first = 0, end = 0;  ///< its triangles in near_; the one that blocked last comes first
  };

  double look_around(const Vec3& place_O, double reach_m, bool anew) noexcept;
  bool see_from(const Vec3& place_O, double need_m, double reach_m, const Vec3& ahead) noexcept;
  bool look_again(const Vec3& place_O, double need_m) noexcept;
  void search_around(const Vec3& place_O, double reach_m) noexcept;
  bool search(const Vec3& place_O, double reach_m, int most) noexcept;
  bool search_part(int surface, double distance_m, int most) noexcept;
  /// No search showed anything before the looks were spent.
  bool is_blind() const noexcept { return reach_m_ < 0; }
  void suit_view() noexcept;
  double least_view_m() const noexcept;
  void see_nothing(double next_reach_m) noexcept;
  double widest_view_m() const noexcept;
  bool is_box_within(int surface, const Vec3& q_P, double distance_m) const noexcept;
  bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                  Round& round) noexcept override;

  Vec3 search_place_O_ = Vec3::Zero();
  double search_reach_m_ = -1;
  double asked_m_ = 0;        // how far the next step is to see ...
  bool falls_short_ = false;  // ... because the last one ended where its view did
  bool is_cut_ = false;       // the last search found too many and was made again, nearer
  bool is_rich_ = false;      // it found more than usual however near
  bool overflow_ = false;     // near_ cannot hold them: every pass asks the trees again
  int usual_view_ = ProxyMemoryLimits::usual_view;  // triangles; more with large fans
  std::vector<NearTriangle> near_;
  std::vector<int> found_;  // triangles, by the last search of a part
  std::vector<PartView> views_;
  std::vector<int> seeds_;
};

}  // namespace fingerpad
