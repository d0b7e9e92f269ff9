// Impulses of contacts go on from step to step.
#include <catch2/catch.hpp>
#include <vector>

#include "contacts/find.hpp"

using namespace pantin;

namespace {

Contact point_of_pair(std::uint32_t feature, Vec3 at, double load = 0.0) {
  Contact c;
  c.key = {1, 2, 0, feature};
  c.body_a = 1;
  c.body_b = 2;
  c.normal = vec(0, 1, 0);
  c.at = at;
  c.total = vec(0, load, 0);
  c.place_impulse = vec(0, 0.5 * load, 0);
  return c;
}

struct Wrench {
  Vec3 force = zero3(), moment = zero3();
};

Wrench wrench(const std::vector<Contact>& contacts, Vec3 Contact::*impulse) {
  Wrench w;
  for (const Contact& c : contacts) {
    w.force += c.*impulse;
    w.moment += cross(c.at, c.*impulse);
  }
  return w;
}

std::vector<Contact> square(double size) {
  return {point_of_pair(1, vec(0, 0, 0), 1.0), point_of_pair(2, vec(size, 0, 0), 2.0),
          point_of_pair(3, vec(0, 0, size), 3.0), point_of_pair(4, vec(size, 0, size), 5.0)};
}

}  // namespace

TEST_CASE("A contact has the impulses of the one with the same features") {
  const std::vector<Contact> before = square(1.0);
  std::vector<Contact> now = {point_of_pair(2, vec(1.1, 0, 0)), point_of_pair(4, vec(1, 0, 0.9))};
  keep_impulses({before[1], before[3]}, now);
  CHECK(now[0].total[1] == 2.0);
  CHECK(now[1].total[1] == 5.0);
}

TEST_CASE("One with new features has those of the nearest that is gone, where that is near") {
  std::vector<Contact> now = {point_of_pair(7, vec(0.2, 0, 0)), point_of_pair(8, vec(0.5, 0, 0))};
  keep_impulses({point_of_pair(1, vec(0.1, 0, 0), 3.0)}, now);
  CHECK(now[0].total[1] == 3.0);
  CHECK(now[1].total[1] == 0.0);
}

TEST_CASE("What points had that are gone acts where it did, by those that the pair has now") {
  const std::vector<Contact> before = square(1.0);
  std::vector<Contact> now = {point_of_pair(11, vec(-0.5, 0, -0.5)), point_of_pair(12, vec(1.5, 0, -0.5)),
                              point_of_pair(13, vec(-0.5, 0, 1.5)), point_of_pair(14, vec(1.5, 0, 1.5))};
  keep_impulses(before, now);
  for (const auto impulse : {&Contact::total, &Contact::place_impulse}) {
    const Wrench had = wrench(before, impulse), has = wrench(now, impulse);
    CHECK(norm(has.force - had.force) < 1e-12 * norm(had.force));
    CHECK(norm(has.moment - had.moment) < 1e-2 * norm(had.moment));
  }
  for (const Contact& c : now) CHECK(c.total[1] >= 0.0);
}

TEST_CASE("What acted outside of all points that are left goes to the nearest ones, whole") {
  std::vector<Contact> now = {point_of_pair(2, vec(1, 0, 0)), point_of_pair(4, vec(1, 0, 1))};
  keep_impulses(square(1.0), now);
  CHECK(wrench(now, &Contact::total).force[1] == Approx(11.0));
  CHECK(now[0].total[1] == Approx(3.0).epsilon(1e-2));
  CHECK(now[1].total[1] == Approx(8.0).epsilon(1e-2));
}

TEST_CASE("Of what does not move nothing is shared out") {
  std::vector<Contact> before = square(1.0);
  for (Contact& c : before) c.body_b = -1;
  std::vector<Contact> now = {before[0], before[1]};
  for (Contact& c : now) c.total = zero3();
  keep_impulses(before, now);
  CHECK(wrench(now, &Contact::total).force[1] == 3.0);
}
