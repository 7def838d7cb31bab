#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

#include "contact/closest_point.hpp"
#include "contact/looks.hpp"

namespace fingerpad {

class ClosestMemory;
struct KeptPoint;
struct PacketDisc;
struct TrianglePacket;

/// Says what of a packet of triangles may be wanted.
struct PacketSieve {
  /// By the disc around one, which is soon at hand.
  bool (*passes_over)(const void* context, const PacketDisc& disc) noexcept;
  /// Of one that is near the lanes of which something may be wanted, a bit each.
  unsigned (*lanes_left)(const void* context, const TrianglePacket& packet) noexcept;
  const void* context;
  long further_looks = 0;  ///< that `lanes_left` takes for a packet, beside what LookCosts says
};

/// The closest triangle of a part to a point.
struct ClosestTriangle {
  int triangle = -1;  ///< index into Part::triangles; -1 when nothing lies within the search radius
  TrianglePoint at;   ///< relative to the part's centre
};

/// A search for the closest triangle that may be broken off.
struct ClosestWalk {
  int triangle = -1;     ///< the closest so far; at the beginning one that is likely close, or -1
  std::size_t next = 0;  ///< where it goes on
};

/// Along a path: the last answer, and how much a query may look at. Where that is not enough it answers with
/// the closest of what it looked at.
struct BriefSearch {
  long most_looks;
  int triangle = -1;
  ClosestMemory* memory = nullptr;  ///< of the path, if one is kept: asked first, as it costs few looks.
                                    ///< Where the rest is broken off, what it holds makes the answer no worse
  const ClosestMemory* beside = nullptr;  ///< of another path that is near: its packets are looked at where
                                          ///< the memory's own do not answer
  long spent = 0;                         ///< looks, of the last answer
  bool broken_off = false;                ///< that was; something nearer may be there
};

/// A triangle that a way goes through.
struct TriangleMet {
  int triangle = -1;  ///< index into Part::triangles; -1 when it goes through none
  double along = std::numeric_limits<double>::infinity();  ///< 0 at its start, 1 at its end
};

/// A sum over a part's triangles for its winding number that may be broken off.
struct WindingWalk {
  std::size_t next = 0;    ///< the packet to go on with
  double half_angles = 0;  ///< so far
  int round = 0;           ///< of sums, each better than the last
};

/// How much a search may find: no more triangles and no more packets (groups of eight) within reach; and what
/// it may cost.
struct SearchLimit {
  int most_triangles, most_packets;
  long most_looks = Looks::unlimited;
  int triangles = 0, packets = 0;         ///< found
  long passed_over = 0;                   ///< packets, by the discs around them
  long tests = 0, shadowed = 0;           ///< of clusters of packets; of triangles against a shadow
  long packet_price = LookCosts::packet;  ///< set by the search: dearer in a large part
  double at_least_m = 0;                  ///< while a triangle is visited: its distance is no smaller

  long looks() const noexcept {
    return LookCosts::cluster * tests + LookCosts::passed_over * passed_over + packet_price * packets +
           LookCosts::shadowed * shadowed;
  }
  bool is_exceeded() const noexcept {
    return triangles > most_triangles || packets > most_packets || looks() > most_looks;
  }
};

/// Where a ray leaves a part.
struct RayExit {
  int triangle = -1;  ///< index into Part::triangles; -1 when the ray leaves nowhere
  double distance_m = std::numeric_limits<double>::infinity();
};

/// A callable as the tree's searches take it: `call_with_triangle<Visit>` and its address.
template <class Visit>
void call_with_triangle(void* visit, int triangle) {
  (*static_cast<Visit*>(visit))(triangle);
}

/// Where a segment enters a part.
struct SegmentHit {
  int triangle = -1;  ///< index into Part::triangles; -1 when the segment enters nowhere
  double along = std::numeric_limits<double>::infinity();  ///< 0 at its start, 1 at its end
};

/// A search tree over a part's triangles: Embree traverses padded float boxes of packets of eight, a float
/// filter with a proven margin looks at a packet at once, and what it leaves is decided in double. Immutable
/// after construction; queries from any number of threads.
class TriangleTree {
 public:
  /// Builds the tree on all threads. Throws Error (fault) if Embree cannot.
  explicit TriangleTree(std::shared_ptr<const Part> part);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  /// The closest triangle to q (relative to the part's centre [m]). Exact: the same answer as looking at
  /// every triangle; ties go to the lowest triangle, so it depends on q alone.
  /// @param seed  a triangle that is likely close (the last answer), or -1; costs speed only, never changes
  /// the answer
  /// @param reach_m  look no farther than this; infinity for no bound
  /// A query point more than a million sizes away is answered from the same direction at that distance (the
  /// point is then off by less than a millionth of the part; distance2_m2 is infinite where a double cannot
  /// hold it); one that is not finite is answered with nothing. Far points beyond any use of the tree are
  /// looked up one by one. noexcept, allocates nothing.
  ClosestTriangle closest(const Vec3& q, int seed, double reach_m) const noexcept;

  /// The same along a path, with what the caller kept from the last query: the same answers, faster, as
  /// most queries of a path that goes on slowly need no search of the tree.
  ClosestTriangle closest(const Vec3& q, ClosestMemory& memory, double reach_m) const noexcept;

  /// The same in pieces: looks at what `looks` allows, a packet more at most, and goes on with the next call.
  /// The order of the search is the part's alone, so that it ends at the same triangle on every machine.
  /// @param walk  kept between calls with the same q and reach_m
  /// @returns nothing where it was broken off. noexcept, allocates nothing.
  std::optional<ClosestTriangle> closest(const Vec3& q, double reach_m, ClosestWalk& walk,
                                         Looks& looks) const noexcept;

  ClosestTriangle closest(const Vec3& q, BriefSearch& search, double reach_m) const noexcept;

  /// The closest triangle to q of so many packets, the likeliest first, and of no more than `looks` allow: it
  /// is the part's closest, or about as close. None where q is far from the part. Of thousands of packets
  /// that are about as near it goes into a few hundred. The same on every machine.
  /// @param seed  a triangle that is likely close, or -1: the closer, the fewer packets are looked at
  /// noexcept, allocates nothing.
  ClosestTriangle about_closest(const Vec3& q, int seed, double reach_m, int most_packets,
                                Looks& looks) const noexcept;

  /// The triangle that a way from q to q + way goes through first, from either side; about so, and none where
  /// it goes through slivers alone, comes by very many triangles or q is far from the part. Where `looks` are
  /// spent, of what it looked at. The same on every machine. noexcept, allocates nothing.
  TriangleMet about_first_met(const Vec3& q, const Vec3& way, Looks& looks) const noexcept;

  /// Calls `visit(context, triangle)` once for every triangle whose distance to q is at most `reach_m`, as
  /// `closest` measures it (closest_on_triangle's distance2_m2 <= reach_m * reach_m, in double): those and no
  /// others, in no order that one may rely on.
  /// @param q  relative to the part's centre [m]; one that is not finite has no triangles within reach
  /// @param reach_m  nothing where negative or not a number; infinity for all
  /// noexcept (so `visit` must not throw), allocates nothing.
  void each_within(const Vec3& q, double reach_m, void (*visit)(void* context, int triangle),
                   void* context) const noexcept;

  /// The same, up to a limit. Whether that is exceeded depends on q and the reach alone, and which triangles
  /// were visited means nothing then.
  /// @returns false where it is exceeded
  bool each_within(const Vec3& q, double reach_m, SearchLimit& limit,
                   void (*visit)(void* context, int triangle), void* context) const noexcept;

  /// The same in an order that is the part's alone, for a ball about q: but for triangles that it cannot get
  /// at, as long as it keeps clear of a point and goes no farther than `reach_m - kept->clearance_m`
  /// (BallShadow).
  /// @param kept  null where no such point is known
  bool each_within(const Vec3& q, double reach_m, const KeptPoint* kept, SearchLimit& limit,
                   void (*visit)(void* context, int triangle), void* context) const noexcept;

  /// The same in pieces, in an order that is the part's alone: looks at what `looks` allows, a packet more at
  /// most, and goes on from `next` with the next call.
  /// @param sieve  is asked before a packet is looked at; null: nothing is left out
  /// @param next  0 at the beginning; kept between calls with the same q and reach_m
  /// @returns whether it came to its end
  bool each_within(const Vec3& q, double reach_m, std::size_t& next, Looks& looks, const PacketSieve* sieve,
                   void (*visit)(void* context, int triangle), void* context) const noexcept {
    return each_beside(q, Vec3::Zero(), reach_m, next, looks, sieve, visit, context);
  }
  /// The same of a way from q to q + way: all that come within reach of a place on it, and perhaps some that
  /// come near it.
  bool each_beside(const Vec3& q, const Vec3& way, double reach_m, std::size_t& next, Looks& looks,
                   const PacketSieve* sieve, void (*visit)(void* context, int triangle),
                   void* context) const noexcept;

  /// The lengths of a PacketSieve's packets and discs, of one metre.
  double packets_scale() const noexcept;

  /// The first triangle that the segment from `from` to `to` crosses from the outside to the inside, that is
  /// against the facet's normal; both ends count. Watertight (Woop, Benthin & Wald 2013, in double): no
  /// segment slips between triangles that share an edge's bits. Ties go to the lowest triangle. A facet seen
  /// edge-on is not crossed: its neighbours are.
  /// @param from, to  relative to the part's centre [m]; ends that are not finite or coincide cross nothing;
  /// of a segment with an end beyond 1e8 sizes the piece around the part is looked at, whose place is as
  /// exact as that end
  /// noexcept, allocates nothing.
  SegmentHit first_crossing(const Vec3& from, const Vec3& to) const noexcept;

  /// The first triangle through which a ray that starts on triangle `start` passes from the inside to the
  /// outside. Triangles that share a (welded) vertex with `start` are passed through, as are those met from
  /// the outside.
  /// @param origin  relative to the part's centre [m]; one beyond 1e4 sizes leaves nowhere
  /// @param direction  unit; one that is not leaves nowhere
  /// noexcept, allocates nothing.
  RayExit first_exit(int start, const Vec3& origin, const Vec3& direction) const noexcept;

  /// Whether the part lies around q: its generalized winding number there is above one half in size, so that
  /// small holes, overlaps and shells wound inside out do not matter.
  /// @param q  relative to the part's centre [m]; nothing lies around a point beyond 1e4 sizes, nor around
  /// one that is not finite. noexcept, allocates nothing.
  bool encloses(const Vec3& q) const noexcept;
  /// The same in pieces: nothing where it was broken off.
  /// @param walk  kept between calls with the same q
  std::optional<bool> encloses(const Vec3& q, WindingWalk& walk, Looks& looks) const noexcept;

  const Part& part() const noexcept;

  /// Asks for a point and along a ray, and needs no answer: for a thread that may not wait or allocate later,
  /// as Embree promises nothing of a thread's first query.
  void warm_up() const noexcept;

  /// Makes a table of the normals that curved patches have at corners (curved_normals.hpp), 72 bytes a
  /// triangle, on all threads; once, whoever asks. It makes `curved` queries about twice as fast and
  /// changes no bit of their answers. Throws std::bad_alloc.
  void prepare_curved() const;
  /// The table, 3 x 3n; null where nobody asked for it.
  const Points* curved_normals() const noexcept;

  /// What the tree holds besides the part, Embree's share with it [bytes].
  std::size_t memory_bytes() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fingerpad
