#include "contact/taped_contact.hpp"

#include <utility>

#include "contact/let_come.hpp"

namespace fingerpad {
namespace {

class RecordingContact final : public ContactMethod {
 public:
  RecordingContact(std::unique_ptr<ContactMethod> method, std::shared_ptr<ContactTape> tape)
      : method_(std::move(method)), tape_(std::move(tape)) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    const Contact& contact = method_->touch(p_WQ, dt_s);
    tape_->append(contact);
    return contact;
  }
  const ClosestMemory* memory_of(int surface) const noexcept override { return method_->memory_of(surface); }
  void reset() noexcept override {
    tape_->spoil();
    method_->reset();
  }

 private:
  std::unique_ptr<ContactMethod> method_;
  std::shared_ptr<ContactTape> tape_;
};

/// The tape says what will be touched: of a large part each of its arrays would be waited for in turn.
class TapeForesight {
 public:
  TapeForesight(const ContactTape& tape, std::vector<PlacedSurface> surfaces)
      : reader_(tape), surfaces_(std::move(surfaces)) {
    reader_.pass();  // the first tick's comes at once ...
    reader_.pass();  // ... and the second's without what the first stage asks for
  }

  /// With each tick: asks for the corners of the next one's facet, whose numbers have come since, and for
  /// what else there is of the facet after that.
  void go_on() noexcept {
    if (const Part* const part = part_of(next_)) {
      for (int k = 0; k < 3; ++k) let_come(part->vertices.col(part->triangles(k, next_.triangle)).data(), 3);
    }
    next_ = reader_.pass();
    if (const Part* const part = part_of(next_)) let_come(*part, next_.triangle);
  }

 private:
  const Part* part_of(const ContactTape::Reader::Facet& hold) const noexcept {
    return hold.triangle < 0 ? nullptr : surfaces_[static_cast<std::size_t>(hold.surface)].part.get();
  }

  ContactTape::Reader reader_;  // a tick ahead of the one to come
  ContactTape::Reader::Facet next_;
  std::vector<PlacedSurface> surfaces_;
};

class PlayedContact final : public ContactMethod {
 public:
  PlayedContact(std::unique_ptr<ContactMethod> method, std::shared_ptr<const ContactTape> tape,
                std::vector<PlacedSurface> surfaces)
      : method_(std::move(method)),
        tape_(std::move(tape)),
        reader_(*tape_),
        ahead_(*tape_, std::move(surfaces)) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    if (is_left_ || !reader_.next(contact_)) return method_->touch(p_WQ, dt_s);
    ahead_.go_on();
    return contact_;
  }
  const ClosestMemory* memory_of(int surface) const noexcept override {
    return is_left_ ? method_->memory_of(surface) : nullptr;
  }
  void reset() noexcept override {
    is_left_ = true;
    method_->reset();
  }

 private:
  std::unique_ptr<ContactMethod> method_;
  std::shared_ptr<const ContactTape> tape_;
  ContactTape::Reader reader_;
  TapeForesight ahead_;
  Contact contact_;
  bool is_left_ = false;  // for good
};

}  // namespace

std::unique_ptr<ContactMethod> recording_contact(std::unique_ptr<ContactMethod> method,
                                                 std::shared_ptr<ContactTape> tape) {
  return std::make_unique<RecordingContact>(std::move(method), std::move(tape));
}

std::unique_ptr<ContactMethod> played_contact(std::unique_ptr<ContactMethod> method,
                                              std::shared_ptr<const ContactTape> tape,
                                              std::vector<PlacedSurface> surfaces) {
  return std::make_unique<PlayedContact>(std::move(method), std::move(tape), std::move(surfaces));
}

}  // namespace fingerpad
