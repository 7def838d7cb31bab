#pragma once

#include <cstddef>

namespace fingerpad {

/// The numbers that only the speed of a proxy depends on. Those that decide where steps go past views, whose
/// first walls may lead them to an end by other walls, are more: `eager` and `crowded_share`, through these
/// what makes views rich or short, and what chooses these walls: `closest_packets`, `most_walked` and the two
/// cosines.
struct ProxyMemoryLimits {
  /// Triangles in view that are kept at hand; a vertex with a larger fan asks for more, but for no more than
  /// the second ...
  static constexpr int usual_view = 256, most_usual_view = 1024;
  /// It asks for two fans, as an edge has at its ends, and a small view besides.
  static constexpr int fans_in_view = 2, beside_fans = 64;
  /// ... and where a ball fits so well into its surroundings that no view has so few: a bore of its own
  /// radius with 1,440 facets. Of more than these the trees are asked anew with each pass.
  static constexpr int richest_view = 3072;
  /// Where there are too many for that, no view is looked for within this share of the clearance about the
  /// place: what is near changes as the ball goes on by about its own size.
  static constexpr double crowded_share = 0.5;
  /// Up to so many triangles, in so many packets, are looked for first: mostly there are no more.
  static constexpr int small_view = 64, small_packets = 64;
  /// ... and again where a search that found more came to so few packets: a quarter, so that it does not go
  /// to and fro between both.
  static constexpr int few_packets = small_packets / 4;
  /// Packets of triangles that a search may look at; where facets are so slender that all their boxes
  /// overlap it is as many however near one looks.
  static constexpr int most_packets = 2048;
  /// A search that is begun may cost so much however little is left of a tick's looks, and else no more than
  /// is left: of what is broken off nothing remains.
  static constexpr long search_looks = 2000;
  /// A view of about so many triangles pays: more are sorted out for nothing, fewer are soon left behind.
  static constexpr int poor_view = 8, rich_view = 32;
  /// By how much a poor view grows and a rich one shrinks, a search.
  static constexpr double growth = 1.2, shrinkage = 0.7;
  /// However rich, a view reaches as far as the finger goes in so many ticks, and by this share of the
  /// clearance: facets much smaller than either are many at any reach.
  static constexpr double least_ticks = 2, least_share = 1.0 / 32;
  /// One that was cut shorter than that grows again to where it is expected to be filled so far.
  static constexpr double filled_view = 0.5;
  /// The first view's reach, as a share of the extent.
  static constexpr double first_view = 0.01;
  /// A view that still shows this share of what was asked for serves again.
  static constexpr double serves_again = 0.5;
  /// A step that ended where its view did is asked for with a view that is so many times as wide.
  static constexpr double wider_view = 2;
  /// Where the proxy slides on, it looks around from so much of the view's reach ahead.
  static constexpr double lead = 0.4;
  /// For a way over an edge so many times as much as the way is to be in view: hops come in rows.
  static constexpr double past_edge = 3;
  /// A view too rich for what is kept at hand is made smaller by this factor, so often.
  static constexpr double cut = 0.25;
  static constexpr int most_cuts = 6;
  /// Where even this share of the clearance shows too many, so does any.
  static constexpr double hopeless_share = 1.0 / 512;
  /// A search for the richest view that was broken off, and before which a tick had looked at so much, is
  /// made again in the next tick.
  static constexpr long late = 1000;
  /// A way so many times as long counts for whether views would outrun a tick's looks: one does not know
  /// what the next views will cost, and is not to find out late.
  static constexpr double eager = 2;
  /// Packets that are looked at for a triangle that is about the closest: a hint, which need not be it.
  static constexpr int closest_packets = 40;
  /// Triangles that are gone over from the one that held the proxy last to the one under it now, and from the
  /// one that a way meets to the one under the finger.
  static constexpr int most_walked = 64;
  /// Where that does not lead under the finger: facets that look about the same way (60 degrees, less than a
  /// box's sides differ by) count as on the same side of a part, and a surface that has turned by so much (5
  /// degrees, more than flat faces do by rounding) as one that turns on.
  static constexpr double same_side_cosine = 0.5, turning_cosine = 0.996;
  /// Farther than this from a part, in its sizes, the distance to its box is near enough to the truth.
  static constexpr double far_from_box = 4;
  /// Flights through free balls in a tick, each to this share of the ball, so that it ends in front of what
  /// bounds it.
  static constexpr int most_flights = 8;
  static constexpr double flight_share = 1 - 1e-9;
  /// A triangle is passed over that leaves so many tolerances free: a ball that touches misses its clearance
  /// by one at the most.
  static constexpr double clear_tolerances = 2;
  /// A ball that touches keeps its clearance from its blocker but for so many times what counts as touching.
  static constexpr double missed_touching = 2;
  /// A bound that is used to leave something out is widened by this against rounding.
  static constexpr double rounding = 1e-12;
};

}  // namespace fingerpad
