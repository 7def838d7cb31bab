#include "contact/contact_tape.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "contact/taped_contact.hpp"

namespace fingerpad::contact_tape_test {
namespace {

/// A contact of so many holds with numbers of all kinds, zeros of both signs among them.
Contact contact_of(int holds, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3(number(random), -0.0, number(random)); };
  Contact contact;
  contact.hold_count = holds;
  for (std::size_t i = 0; i < static_cast<std::size_t>(holds); ++i)
    contact.holds[i] = {static_cast<int>(random() % 3), static_cast<int>(random() % 1000) - 1, vector(),
                        vector(), number(random)};
  contact.depth_m = number(random);
  contact.point_W = vector();
  contact.normal_W = vector();
  contact.started = random() % 2 == 0;
  contact.placed = random() % 2 == 0;
  contact.broken_off = random() % 2 == 0;
  contact.behind = random() % 2 == 0;
  return contact;
}

/// The one surface that holds is the whole contact.
Contact lone(std::mt19937& random) {
  Contact contact = contact_of(1, random);
  contact.depth_m = contact.holds[0].share_m;
  contact.point_W = contact.holds[0].point_W;
  contact.normal_W = contact.holds[0].normal_W;
  return contact;
}

std::vector<std::uint64_t> bits_of(const Contact& contact) {
  std::vector<std::uint64_t> bits = {static_cast<std::uint64_t>(contact.hold_count), contact.started,
                                     contact.placed, contact.broken_off, contact.behind};
  const auto add = [&](const Vec3& v) {
    for (const double x : v) bits.push_back(std::bit_cast<std::uint64_t>(x));
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.hold_count); ++i) {
    const ContactHold& hold = contact.holds[i];
    bits.push_back(static_cast<std::uint64_t>(hold.surface));
    bits.push_back(static_cast<std::uint64_t>(hold.triangle));
    bits.push_back(std::bit_cast<std::uint64_t>(hold.share_m));
    add(hold.point_W);
    add(hold.normal_W);
  }
  if (contact.hold_count == 0) return bits;
  bits.push_back(std::bit_cast<std::uint64_t>(contact.depth_m));
  add(contact.point_W);
  add(contact.normal_W);
  return bits;
}

/// Tells its ticks by their depth.
class CountingMethod final : public ContactMethod {
 public:
  const Contact& touch(const Vec3& /*p_WQ*/, double /*dt_s*/) noexcept override {
    contact_.hold_count = 1;
    contact_.depth_m = ++ticks_;
    return contact_;
  }
  void reset() noexcept override { ticks_ = 0; }

 private:
  double ticks_ = 0;
  Contact contact_;
};

std::shared_ptr<ContactTape> recorded(int ticks) {
  const auto tape = std::make_shared<ContactTape>(ticks, 1 << 16);
  const auto method = recording_contact(std::make_unique<CountingMethod>(), tape);
  for (int k = 0; k < ticks; ++k) method->touch(Vec3::Zero(), 1e-3);
  return tape;
}

TEST(ContactTape, GivesBackEachTickToTheBit) {
  std::mt19937 random(1);
  std::vector<Contact> contacts;
  for (int k = 0; k < 200; ++k) {
    contacts.push_back(k % 5 == 4 ? lone(random) : contact_of(k % 5, random));
  }
  ContactTape tape(200, 1 << 20);
  for (const Contact& contact : contacts) tape.append(contact);
  ASSERT_TRUE(tape.is_whole());
  ContactTape::Reader reader(tape);
  Contact read;
  for (const Contact& contact : contacts) {
    ASSERT_TRUE(reader.next(read));
    ASSERT_EQ(bits_of(read), bits_of(contact));
  }
  EXPECT_FALSE(reader.next(read)) << "behind the last";
}

TEST(ContactTape, TellsTheFacetsOfTicksThatItGoesPast) {
  std::mt19937 random(4);
  std::vector<Contact> contacts;
  for (int k = 0; k < 50; ++k) contacts.push_back(k % 5 == 4 ? lone(random) : contact_of(k % 5, random));
  ContactTape tape(50, 1 << 20);
  for (const Contact& contact : contacts) tape.append(contact);
  ContactTape::Reader reader(tape);
  for (const Contact& contact : contacts) {
    const bool is_free = contact.hold_count == 0;
    const auto facet = reader.pass();
    EXPECT_EQ(facet.surface, is_free ? -1 : contact.holds[0].surface);
    EXPECT_EQ(facet.triangle, is_free ? -1 : contact.holds[0].triangle);
  }
  EXPECT_EQ(reader.pass().triangle, -1) << "behind the last";
}

TEST(ContactTape, TakesSeventyTwoBytesWhereOneSurfaceHoldsAndEightWhereNoneDoes) {
  std::mt19937 random(2);
  ContactTape tape(2, 1 << 20);
  tape.append(lone(random));
  EXPECT_EQ(tape.bytes(), 72u);
  tape.append(contact_of(0, random));
  EXPECT_EQ(tape.bytes(), 80u);
}

TEST(ContactTape, IsOfNoUseBeforeItIsWholeNorWhereItDoesNotFit) {
  std::mt19937 random(3);
  ContactTape tape(2, 1 << 20), small(100, 1 << 10);
  tape.append(lone(random));
  EXPECT_FALSE(tape.is_whole());
  tape.append(lone(random));
  EXPECT_TRUE(tape.is_whole());
  for (int k = 0; k < 100; ++k) small.append(lone(random));
  EXPECT_FALSE(small.is_whole());
  EXPECT_LE(small.bytes(), std::size_t{1} << 10);
}

TEST(PlayedContact, AnswersFromTheTapeAndBehindAResetAsAnyMethodWould) {
  const auto method = played_contact(std::make_unique<CountingMethod>(), recorded(5), {});
  EXPECT_EQ(method->touch(Vec3::Zero(), 1e-3).depth_m, 1);
  EXPECT_EQ(method->touch(Vec3::Zero(), 1e-3).depth_m, 2);
  method->reset();
  EXPECT_EQ(method->touch(Vec3::Zero(), 1e-3).depth_m, 1) << "begun anew";
  EXPECT_EQ(method->touch(Vec3::Zero(), 1e-3).depth_m, 2) << "and not to be found on the tape any more";
}

TEST(RecordingContact, SpoilsItsTapeWithAReset) {
  const auto tape = std::make_shared<ContactTape>(2, 1 << 16);
  const auto method = recording_contact(std::make_unique<CountingMethod>(), tape);
  method->touch(Vec3::Zero(), 1e-3);
  method->reset();
  method->touch(Vec3::Zero(), 1e-3);
  EXPECT_FALSE(tape->is_whole()) << "what another friction would not reset";
}

}  // namespace
}  // namespace fingerpad::contact_tape_test
