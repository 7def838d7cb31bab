#include "part/openmesh_reader.hpp"

#include <OpenMesh/Core/System/config.h>
#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/reader/BaseReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <istream>
#include <mutex>
#include <streambuf>

namespace fingerpad {
namespace {

namespace om = OpenMesh;

/// A stream over bytes that are already in memory.
class MemoryBuffer : public std::streambuf {
 public:
  explicit MemoryBuffer(const std::string& bytes) {
    char* begin = const_cast<char*>(bytes.data());  // never written to: there is no put area
    setg(begin, begin, begin + bytes.size());
  }

 protected:
  pos_type seekoff(off_type by, std::ios_base::seekdir from, std::ios_base::openmode) override {
    char* base = eback();
    if (from == std::ios_base::cur) base = gptr();
    if (from == std::ios_base::end) base = egptr();
    if (by < eback() - base || by > egptr() - base) return pos_type(off_type(-1));
    setg(eback(), base + by, egptr());
    return pos_type(gptr() - eback());
  }
  pos_type seekpos(pos_type to, std::ios_base::openmode which) override {
    return seekoff(off_type(to), std::ios_base::beg, which);
  }
};

/// Takes what a reader delivers as it comes; all but vertices and faces is let go.
class Collector : public om::IO::BaseImporter {
 public:
  /// @param expected  how many faces there should be
  Collector(OpenMeshDelivery& into, int expected, const LoadProgress& progress)
      : into_(into), expected_(expected), progress_(progress) {}

  om::VertexHandle add_vertex(const om::Vec3f& p) override { return add(Vec3(p[0], p[1], p[2])); }
  om::VertexHandle add_vertex(const om::Vec3d& p) override { return add(Vec3(p[0], p[1], p[2])); }
  om::VertexHandle add_vertex() override { return add(Vec3::Zero()); }

  void set_point(om::VertexHandle vertex, const om::Vec3f& p) override {
    if (knows(vertex)) into_.vertices[static_cast<std::size_t>(vertex.idx())] = Vec3(p[0], p[1], p[2]);
  }

  om::FaceHandle add_face(const VHandles& corners) override {
    for (const om::VertexHandle corner : corners) into_.corners.push_back(knows(corner) ? corner.idx() : -1);
    into_.ends.push_back(static_cast<int>(into_.corners.size()));
    constexpr std::size_t between_news = 1 << 16;
    if (into_.ends.size() % between_news == 0) {
      const double share = static_cast<double>(into_.ends.size()) / std::max(expected_, 1);
      tell(progress_, "reading through OpenMesh", std::min(share, 1.0));
    }
    return om::FaceHandle(static_cast<int>(into_.ends.size()) - 1);
  }

  om::FaceHandle add_face(om::HalfedgeHandle) override { return om::FaceHandle(); }
  om::HalfedgeHandle add_edge(om::VertexHandle, om::VertexHandle) override { return om::HalfedgeHandle(); }
  void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec2f>&) override {}
  void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec3f>&) override {}
  void set_face_texindex(om::FaceHandle, int) override {}
  void set_halfedge(om::VertexHandle, om::HalfedgeHandle) override {}
  void set_normal(om::VertexHandle, const om::Vec3f&) override {}
  void set_normal(om::VertexHandle, const om::Vec3d&) override {}
  void set_color(om::VertexHandle, const om::Vec3uc&) override {}
  void set_color(om::VertexHandle, const om::Vec4uc&) override {}
  void set_color(om::VertexHandle, const om::Vec3f&) override {}
  void set_color(om::VertexHandle, const om::Vec4f&) override {}
  void set_texcoord(om::VertexHandle, const om::Vec2f&) override {}
  void set_status(om::VertexHandle, const om::Attributes::StatusInfo&) override {}
  void set_next(om::HalfedgeHandle, om::HalfedgeHandle) override {}
  void set_face(om::HalfedgeHandle, om::FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(om::HalfedgeHandle, const om::Vec2f&) override {}
  void set_texcoord(om::VertexHandle, const om::Vec3f&) override {}
  void set_texcoord(om::HalfedgeHandle, const om::Vec3f&) override {}
  void set_status(om::HalfedgeHandle, const om::Attributes::StatusInfo&) override {}
  void set_color(om::EdgeHandle, const om::Vec3uc&) override {}
  void set_color(om::EdgeHandle, const om::Vec4uc&) override {}
  void set_color(om::EdgeHandle, const om::Vec3f&) override {}
  void set_color(om::EdgeHandle, const om::Vec4f&) override {}
  void set_status(om::EdgeHandle, const om::Attributes::StatusInfo&) override {}
  void set_normal(om::FaceHandle, const om::Vec3f&) override {}
  void set_normal(om::FaceHandle, const om::Vec3d&) override {}
  void set_color(om::FaceHandle, const om::Vec3uc&) override {}
  void set_color(om::FaceHandle, const om::Vec4uc&) override {}
  void set_color(om::FaceHandle, const om::Vec3f&) override {}
  void set_color(om::FaceHandle, const om::Vec4f&) override {}
  void set_status(om::FaceHandle, const om::Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}
  std::size_t n_vertices() const override { return into_.vertices.size(); }
  std::size_t n_faces() const override { return into_.ends.size(); }
  std::size_t n_edges() const override { return 0; }

 private:
  om::VertexHandle add(const Vec3& point) {
    into_.vertices.push_back(point);
    return om::VertexHandle(static_cast<int>(into_.vertices.size()) - 1);
  }
  bool knows(om::VertexHandle vertex) const {
    return vertex.idx() >= 0 && static_cast<std::size_t>(vertex.idx()) < into_.vertices.size();
  }

  OpenMeshDelivery& into_;
  int expected_;
  const LoadProgress& progress_;
};

}  // namespace

OpenMeshDelivery read_by_openmesh(om::IO::BaseReader& reader, const std::string& bytes, const RawMesh& mesh,
                                  const LoadProgress& progress) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  // Its remarks to the console are replaced by the comparison with the file itself.
  omerr().disable();
  omlog().disable();
  OpenMeshDelivery delivery;
  delivery.vertices.reserve(mesh.vertices.size());
  delivery.corners.reserve(mesh.corners.size());
  delivery.ends.reserve(mesh.ends.size());
  tell(progress, "reading through OpenMesh", 0);
  MemoryBuffer buffer(bytes);
  std::istream stream(&buffer);
  Collector collector(delivery, mesh.polygon_count(), progress);
  om::IO::Options options;
  if (mesh.binary) options += om::IO::Options::Binary;
  // A scanned binary file holds all that it announces: a read past its end means that OpenMesh takes other
  // bytes for counts, and it would go on for minutes. (Texts are read until they end.)
  if (mesh.binary) stream.exceptions(std::ios::failbit);
  try {
    delivery.succeeded = reader.read(stream, collector, options);
  } catch (const std::ios_base::failure&) {
    delivery.succeeded = false;
  }
  return delivery;
}

std::string openmesh_version() {
  return std::to_string(OM_GET_VER) + "." + std::to_string(OM_GET_MAJ);
}

}  // namespace fingerpad
