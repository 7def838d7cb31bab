#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "contact/normals.hpp"
#include "contact/taped_contact.hpp"
#include "motion/finger_path.hpp"
#include "touch/world.hpp"

namespace fingerpad {

struct ContactMethodEntry;
struct Scene;

/// All that decides where a finger touches, tick by tick.
class ContactCourse {
 public:
  ContactCourse(const Scene& scene, const World& world, const FingerPath& path);
  bool operator==(const ContactCourse& other) const;
  /// That a recording takes which it keeps to compare others with.
  std::size_t memory_bytes() const noexcept { return path_.memory_bytes(); }

 private:
  /// A surface, which it does not keep in memory.
  struct Place {
    std::weak_ptr<const TriangleTree> tree;
    Vec3 p_WP, plane_point_W, plane_normal_W;
    Mat3 R_WP;

    bool operator==(const Place& other) const;
  };

  const ContactMethodEntry* method_;
  Normals normals_;
  double radius_m_;
  std::vector<Place> places_;
  FingerPath path_;
};

/// Of memory, that a batch's contact takes beside its meshes and motions, and a tape on which it is recorded.
inline constexpr std::size_t most_contact_bytes = std::size_t{512} << 20;
/// That a tape is given: some ticks are held by several surfaces.
inline constexpr std::size_t contact_bytes_a_tick = 96;

/// Keeps where fingers touched, for the jobs of a batch whose finger goes the same way with another friction:
/// those used last, up to a bound. What a job comes to does not depend on whether it found a tape here.
/// Thread-safe.
class ContactStore {
 public:
  /// @param most_bytes  of all tapes that are kept, with the motions that they are told by, and of all that
  /// are being recorded, at contact_bytes_a_tick: where that is not enough a job plays alone
  explicit ContactStore(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// A job's part in it.
  class Share {
   public:
    Share() = default;
    Share(Share&& other) noexcept { *this = std::move(other); }
    Share& operator=(Share&& other) noexcept;
    ~Share();
    /// What is to be made of its contact method; empty where it plays alone.
    ContactWrap wrap() const;
    /// The job has run to its end: others may play what it recorded.
    void finish();

   private:
    friend class ContactStore;
    ContactStore* store_ = nullptr;
    std::shared_ptr<const ContactCourse> course_;
    std::shared_ptr<const ContactTape> played_;
    std::shared_ptr<ContactTape> recorded_;
    std::size_t reserved_bytes_ = 0;  ///< for what is recorded
  };

  /// Whether a job's friction has no part in where its finger goes: not so in a hand.
  static bool may_share(const Scene& scene) noexcept;
  /// Plays what there is of this course, or records it. One that may not share has no part in it.
  Share share(const Scene& scene, const World& world, const FingerPath& path);

  /// How many jobs have played a tape so far.
  long played_count() const;

 private:
  struct Kept {
    std::shared_ptr<const ContactCourse> course;
    std::shared_ptr<const ContactTape> tape;
    std::size_t bytes() const noexcept { return tape->bytes() + course->memory_bytes(); }
  };
  void keep(const Kept& kept);

  void give_back(std::size_t reserved_bytes);

  std::size_t most_bytes_, bytes_ = 0, reserved_bytes_ = 0;
  long played_count_ = 0;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  // last used in front
};

}  // namespace fingerpad
