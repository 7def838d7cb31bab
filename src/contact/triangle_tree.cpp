#include "contact/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/large_pages.hpp"
#include "contact/curved_normals.hpp"
#include "contact/tree_parts.hpp"
#include "contact/within_search.hpp"

namespace fingerpad {
namespace {

float visit_closest(void* any_search, unsigned index, float radius) noexcept {
  ClosestSearch& search = *static_cast<ClosestSearch*>(any_search);
  const TrianglePacket& packet = search.packed->packets[index];
  if (&packet == search.looked_at || search.passes_over(packet) || !search.look_at(packet)) return radius;
  return search.radius(std::sqrt(search.winner.at.distance2_m2));
}

float visit_within(void* any_search, unsigned index, float radius) noexcept {
  const WithinSearch& search = *static_cast<const WithinSearch*>(any_search);
  search.look_at(search.packed->packets[index]);
  return radius;
}

}  // namespace

std::uint64_t new_tree_number() noexcept {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

TriangleTree::TriangleTree(std::shared_ptr<const Part> part)
    : impl_(std::make_unique<Impl>(std::move(part))) {}
TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

/// What a path over a large part reads lies far apart: of its triangles a few numbers in each array.
void TriangleTree::Impl::keep_in_large_pages() const noexcept {
  const Part& part = *packed.part;
  fingerpad::keep_in_large_pages(packed.packets);
  fingerpad::keep_in_large_pages(packed.discs);
  fingerpad::keep_in_large_pages(packed.slot_of);
  for (const Points* points : {&part.vertices, &part.facet_normals, &part.edge_pseudonormals,
                               &part.vertex_pseudonormals, &part.corner_normals})
    fingerpad::keep_in_large_pages(*points);
  for (const IndexTriples* indices : {&part.triangles, &part.welded, &part.neighbours})
    fingerpad::keep_in_large_pages(*indices);
  fingerpad::keep_in_large_pages(part.file_triangle);
}

const Part& TriangleTree::part() const noexcept {
  return *impl_->packed.part;
}

double TriangleTree::packets_scale() const noexcept {
  return impl_->packed.scale;
}

void TriangleTree::warm_up() const noexcept {
  if (impl_->packed.packets.empty()) return;
  closest(Vec3::Zero(), -1, std::numeric_limits<double>::infinity());
  first_crossing(Vec3::UnitX() * -impl_->packed.extent_m, Vec3::UnitX() * impl_->packed.extent_m);
}

void TriangleTree::prepare_curved() const {
  std::call_once(impl_->curved_once, [this] {
    impl_->curved_table = curved_corner_normals(part());
    keep_in_large_pages(impl_->curved_table);
    impl_->curved_normals.store(&impl_->curved_table, std::memory_order_release);
  });
}

const Points* TriangleTree::curved_normals() const noexcept {
  return impl_->curved_normals.load(std::memory_order_acquire);
}

std::size_t TriangleTree::memory_bytes() const noexcept {
  const Points* curved = curved_normals();
  return sizeof(Impl) + impl_->packed.memory_bytes() + impl_->scene.memory_bytes() +
         impl_->winding.memory_bytes() +
         (curved == nullptr ? 0 : static_cast<std::size_t>(curved->size()) * sizeof(double));
}

bool TriangleTree::encloses(const Vec3& q) const noexcept {
  WindingWalk walk;
  Looks looks(Looks::unlimited);
  return encloses(q, walk, looks).value_or(false);
}

ClosestTriangle TriangleTree::closest(const Vec3& q, int seed, double reach_m) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite()) return {};
  if (impl.out_of_reach(farthest, reach_m)) return {};
  if (farthest > tree_range * packed.extent_m) return impl.far_closest(q, reach_m);

  ClosestSearch search(packed, impl.filter, q, reach_m);
  const int count = static_cast<int>(packed.slot_of.size());
  if (seed >= 0 && seed < count) search.look_at_seed(seed);
  impl.search_tree(search, std::sqrt(search.winner.at.distance2_m2));
  return search.answer();
}

void TriangleTree::Impl::search_tree(ClosestSearch& search, double within_m) const noexcept {
  if (within_m > packed.extent_m) within_m = std::min(within_m, search.q.norm() + 2 * packed.extent_m);
  scene.each_near(search.embree, search.radius(within_m), visit_closest, &search);
}

/// Every triangle in turn: for points so far away that a tree of float boxes sees no difference between them.
ClosestTriangle TriangleTree::Impl::far_closest(const Vec3& q, double reach_m) const noexcept {
  const Part& part = *packed.part;
  const double farthest = q.cwiseAbs().maxCoeff();
  const double limit = direction_range * packed.extent_m;
  const Vec3 nearer = within_direction_range(q, packed.extent_m);
  const double tie_m = tie_distance_m(part, nearer);
  Winner winner;
  winner.at.distance2_m2 = std::numeric_limits<double>::infinity();
  for (const TrianglePacket& packet : packed.packets) {
    for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
      const int t = packet.exact[static_cast<std::size_t>(lane)].triangle;
      const FramePoint p = closest_in(exact_frame(part, packet, lane), nearer, tie_m);
      if (winner.beaten_by(t, p)) winner = {t, p};
    }
  }
  ClosestTriangle result{winner.triangle, in_part_corners(winner.at, corner_order(part, winner.triangle))};
  const double distance_m = (q - result.at.point).stableNorm();
  if (farthest > limit) result.at.distance2_m2 = distance_m * distance_m;
  if (!(distance_m <= reach_m)) return {};
  return result;
}

void TriangleTree::each_within(const Vec3& q, double reach_m, void (*visit)(void* context, int triangle),
                               void* context) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(reach_m >= 0)) return;
  if (impl.out_of_reach(farthest, reach_m)) return;

  if (farthest > tree_range * packed.extent_m) {
    impl.far_each_within(q, reach_m, visit, context);
    return;
  }
  WithinSearch search(packed, impl.filter, q, reach_m, visit, context);
  impl.scene.each_near(search.embree, search.radius(search.bound_m), visit_within, &search);
}

/// Every triangle in turn, as far_closest.
void TriangleTree::Impl::far_each_within(const Vec3& q, double reach_m,
                                         void (*visit)(void* context, int triangle),
                                         void* context) const noexcept {
  const WithinSearch search(packed, filter, q, reach_m, visit, context);
  for (const TrianglePacket& packet : packed.packets) search.look_from_afar_at(packet);
}

}  // namespace fingerpad
