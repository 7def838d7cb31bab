#pragma once

namespace fingerpad {

/// The numbers that a proxy's answer depends on, each with its reason. Lengths are shares of the parts'
/// extent, so that units and places do not matter.
struct ProxyLimits {
  /// The skin: what the ball keeps from every surface beyond its radius, so that rounding never takes it to
  /// the other side. 2^-27 (7.5e-9) of the extent: far below what a finger feels, far above rounding.
  static constexpr int skin_exponent = -27;
  /// The tolerance: by how much the clearance may be missed. 2^-6 of the skin: many ticks' misses do not add
  /// up to it, since each step looks at the distance anew.
  static constexpr int tolerance_exponent = -6;
  /// A projection may end this far behind a wall: 2^-2 of the tolerance, so that the check after it, which
  /// allows the whole tolerance, never sends the same wall back.
  static constexpr int slack_exponent = -2;
  /// Where rounding is all that a wall may be missed by, it is breached from so many times that on: a
  /// projection leaves up to once that behind it.
  static constexpr double breach_roundings = 2;
  /// A ball that is no more than so many tolerances away from a wall lies on it.
  static constexpr double touching_tolerances = 4;
  /// What rounding does to a step, as a share of its coordinates: two units in the last place.
  static constexpr double rounding = 4e-16;
  /// What it does to the distance from a plane: some ten sums and products, of shares that in a groove of a
  /// tenth of a degree are some three hundred times the depth. Among planes alone this is the only tolerance,
  /// since there is no extent to compare lengths with.
  static constexpr double plane_rounding = 2e-12;
  /// What is looked at reaches farther than what is asked for by this share, against rounding. Of two
  /// projections one is nearer only by more than this.
  static constexpr double reach_rounding = 1e-12;

  /// Farther than this from the parts the proxy is let go: coordinates there tell nothing.
  static constexpr double farthest = 1e6;
  /// In contact the push changes by the finger's motion and at most so many times as much: twice, so that the
  /// proxy catches up ...
  static constexpr double proxy_per_finger = 2;
  /// ... or, where the finger rests, lets the depth go in this time [s]: a motion and not a blow.
  static constexpr double release_s = 0.5;
  /// A first touch may be anything, and so may what is left of it where its tick's looks ran out, for so
  /// long [s]: the blow lasts no longer than it is felt as one.
  static constexpr double arrival_s = 0.02;
  /// On its way round a rounding the push turns with the proxy, which therefore keeps up as long as its way
  /// is at most so many times as long as the finger's. That is where the finger is no deeper than this share
  /// of the rounding's radius and the ball's together.
  static constexpr double rounds_per_finger = 2 + proxy_per_finger, rounds_deep = 1 - 1 / rounds_per_finger;

  /// A change of the push by less than this share of it is not felt: fingers tell 6 to 7 % apart.
  static constexpr double unfelt_share = 0.07;
  /// Of 1 + cosine: two unit vectors nearer than this to opposite have no smallest rotation between them.
  static constexpr double least_turn_sum = 1e-6;
  /// Sine of the angle between two normals below which they are the same or opposite: between these no way
  /// is the shortest.
  static constexpr double least_turn_sine = 1e-9;

  /// Pushes that a start may take to get out of every surface. Walls that stand at right angles need one
  /// each; between walls that lean towards each other each push leaves a fixed share.
  static constexpr int most_pushes = 200;
  /// A start after one that found no place has so many times fewer looks: a ball that is held in a slot
  /// narrower than itself would else cost a whole tick's looks as long as it is there.
  static constexpr long less_after_no_place = 8;
  /// So has a start that has taken so many ticks. Most take a few, in a bore that just fits some forty; where
  /// the ball fits nowhere all its pushes may take a second.
  static constexpr int patient_ticks = 64;
  /// A start goes round, and ends, where all its pushes together would take it on by less than this share of
  /// what it lacks.
  static constexpr double little_way = 1e-3;
  /// Steps, and hops over smooth edges, in a tick. Two or three do; the caps bound what a tick may cost.
  static constexpr int most_steps = 64;
  static constexpr int most_hops = 32;
  /// Walls that one step may try. It adds a wall a pass; two or three do, and no walk has been seen to take
  /// more than twelve.
  static constexpr int most_passes = 48;

  /// What a step along bent walls divides by, as a share of what it would be along flat ones: with less than
  /// this they bend about so close to the finger that the way to the second order means little.
  static constexpr double least_left_of_bend = 1.0 / 1024;

  /// Along bent walls a step may be as long as this share of the one before: ways that come to an end get
  /// shorter by more than that.
  static constexpr double next_bend = 0.5;

  /// The ball is far from a wall if the gap to it could be seen and felt: a share of the scene's extent, of a
  /// part as large as a hand a micrometre ...
  static constexpr double far_wall = 1e-5;
  /// ... or a share of the clearance, where that is less. A point's clearance is far below a micrometre: a
  /// point that has passed an edge is so close to the planes of both its faces, and is yet past one of them.
  static constexpr double far_wall_share = 1.0 / 32;

  /// Sine of the angle under which a wall's normal counts as that of the triangle it stands for: where they
  /// agree so well there is nothing to gain from another step.
  static constexpr double same_wall = 1e-8;
  /// Cosine of the widest turn that one roll over an edge or a corner makes: 60 degrees. Wider ones take
  /// several steps, since the planes on either side then meet far from the ball's way.
  static constexpr double least_roll_cosine = 0.5;
  /// The way over an edge may be so many times as long as the way to the new place: longer, and it is not the
  /// edge between the two facets but where their planes meet far off.
  static constexpr double longest_way_over = 1.5;
  /// Facets around the corners of one facet that are looked at for a hop, and turns about a corner. A vertex
  /// with more is a fan of slivers, where a hop that is not made costs a tick of rolling.
  static constexpr int most_neighbours = 24;
  static constexpr int most_turns = 64;

  /// A triangle whose area is smaller than this share of its sides' squares is no more than its edges: its
  /// width is then far below any clearance.
  static constexpr double face_area_share = 1e-13;
  /// Squared sine of the angle under which two walls' planes count as parallel.
  static constexpr double parallel2 = 1e-16;
  /// Three normals of a smaller volume than this span no corner that rounding leaves in place.
  static constexpr double flat_volume = 1e-12;

  /// Newton's steps of a sweep converge quadratically; a cap for what rounding might do.
  static constexpr int newton_steps = 32;
};

}  // namespace fingerpad
