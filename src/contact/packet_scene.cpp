#include "contact/packet_scene.hpp"

#include <embree3/rtcore.h>

#include <string>

#include "base/error.hpp"

namespace fingerpad {
namespace {

bool count_memory(void* total, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
  return true;
}

void bounds(const RTCBoundsFunctionArguments* args) {
  const auto& packed = *static_cast<const PackedPart*>(args->geometryUserPtr);
  const TrianglePacket& packet = packed.packets[args->primID];
  float low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = static_cast<float>(packet.origin[i] - packet.box_half[i]) - box_padding;
    high[i] = static_cast<float>(packet.origin[i] + packet.box_half[i]) + box_padding;
  }
  *args->bounds_o = {low[0], low[1], low[2], 0, high[0], high[1], high[2], 0};
}

/// What hangs behind Embree's point query.
struct PointSearch {
  PacketScene::Visit visit;
  void* search;
};

bool visit_point(RTCPointQueryFunctionArguments* args) {
  const PointSearch& behind = *static_cast<const PointSearch*>(args->userPtr);
  const float radius = behind.visit(behind.search, args->primID, args->query->radius);
  if (!(radius < args->query->radius)) return false;
  args->query->radius = radius;
  return true;
}

/// What hangs behind Embree's ray.
struct RaySearch {
  RTCIntersectContext context;  // first, so that Embree's pointer to it is a pointer to this
  RayQuery* query;
};

void intersect(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& packed = *static_cast<const PackedPart*>(args->geometryUserPtr);
  RayQuery& query = *reinterpret_cast<RaySearch*>(args->context)->query;
  RTCRayHit& ray = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  const float far = ray.ray.tfar;
  query.look_at(query, packed.packets[args->primID], ray.ray.tfar);
  if (ray.ray.tfar >= far) return;
  ray.hit.primID = args->primID;
  ray.hit.geomID = args->geomID;
}

}  // namespace

PacketScene::PacketScene(const PackedPart& packed) : packed_(&packed) {
  // The widest instruction set is not the fastest: 8-wide boxes were 8-13 % faster than 16-wide ones.
  device_ = rtcNewDevice(__builtin_cpu_supports("avx2") ? "isa=avx2" : nullptr);
  if (device_ == nullptr) throw Error(ErrorKind::fault, "", "Embree cannot start");
  rtcSetDeviceMemoryMonitorFunction(device_, count_memory, &memory_);
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(packed.packets.size()));
  rtcSetGeometryUserData(geometry, const_cast<PackedPart*>(packed_));
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  const RTCError error = rtcGetDeviceError(device_);
  if (error == RTC_ERROR_NONE) return;
  const std::string count = std::to_string(packed.packets.size());
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
  throw Error(ErrorKind::fault, "",
              "Embree cannot build a tree of " + count + " packets of triangles (its error " +
                  std::to_string(error) + ")");
}

PacketScene::~PacketScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void PacketScene::each_near(const float* point, float radius, Visit visit, void* search) const noexcept {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{point[0], point[1], point[2], 0, radius};
  PointSearch behind{visit, search};
  rtcPointQuery(scene_, &query, &context, visit_point, &behind);
}

void PacketScene::cast(RayQuery& query, const Vec3& from, const Vec3& direction,
                       double length) const noexcept {
  RaySearch search{{}, &query};
  rtcInitIntersectContext(&search.context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x());
  ray.ray.org_y = static_cast<float>(from.y());
  ray.ray.org_z = static_cast<float>(from.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tnear = 0;
  ray.ray.tfar = static_cast<float>(length);
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &search.context, &ray);
}

std::string embree_version() {
  RTCDevice device = rtcNewDevice("threads=1");
  if (device == nullptr) return "";
  const auto version = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);  // 31305 is 3.13.5
  rtcReleaseDevice(device);
  return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100);
}

}  // namespace fingerpad
