#include "contact/taped_contact.hpp"

#include <utility>

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

class PlayedContact final : public ContactMethod {
 public:
  PlayedContact(std::unique_ptr<ContactMethod> method, std::shared_ptr<const ContactTape> tape)
      : method_(std::move(method)), tape_(std::move(tape)), reader_(*tape_) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    if (is_left_ || !reader_.next(contact_)) return method_->touch(p_WQ, dt_s);
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
  Contact contact_;
  bool is_left_ = false;  // for good
};

}  // namespace

std::unique_ptr<ContactMethod> recording_contact(std::unique_ptr<ContactMethod> method,
                                                 std::shared_ptr<ContactTape> tape) {
  return std::make_unique<RecordingContact>(std::move(method), std::move(tape));
}

std::unique_ptr<ContactMethod> played_contact(std::unique_ptr<ContactMethod> method,
                                              std::shared_ptr<const ContactTape> tape) {
  return std::make_unique<PlayedContact>(std::move(method), std::move(tape));
}

}  // namespace fingerpad
