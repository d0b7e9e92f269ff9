// A string: at most so long along its points and positions, slides through the inner ones; a row for each segment, whose
// equations the solver does together.
#include <unordered_map>

#include "base/check.hpp"
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

Vec3 position_of(const Model& model, const Passage& p) { return p.point ? position(model, p.point) : p.position; }

void check(const Model& model, Constraint& c) {
  const std::span<const Passage> passages = c.passages();
  require(passages.size() >= 2, "string: needs two points or more, got ", passages.size());
  double fixed = 0.0;
  std::unordered_map<ParticleId, std::size_t> known;
  for (std::size_t i = 0; i < passages.size(); i++) {
    const Passage& p = passages[i];
    if (!p.point) internal::require_finite("string", "a position", p.position, "m");
    if (p.point) {
      const auto [other, is_new] = known.try_emplace(model.points[p.point].particle, i);
      require(is_new, "string: points ", other->second + 1, " and ", i + 1, " are one particle");
    }
    if (i > 0 && !p.point && !passages[i - 1].point) fixed += norm(p.position - passages[i - 1].position);
  }
  require(static_cast<bool>(c.a), "string: it goes through positions only; one must be a point or a particle");
  internal::require_positive("string", "length", c.number.now, "m");
  require(c.number.now > fixed, "string: its positions are ", fixed, " m apart, so it cannot be ", c.number.now,
          " m long");
}

double value(const Model& model, const Constraint& c) {
  double sum = 0.0;
  for (std::size_t i = 1; i < c.passages().size(); i++)
    sum += norm(position_of(model, c.passages()[i]) - position_of(model, c.passages()[i - 1]));
  return sum;
}

double rate(const Model& model, const Constraint& c) {
  double sum = 0.0;
  const auto velocity_of = [&](const Passage& p) { return p.point ? velocity(model, p.point) : zero3(); };
  for (std::size_t i = 1; i < c.passages().size(); i++) {
    const Passage &from = c.passages()[i - 1], &to = c.passages()[i];
    const Vec3 along = direction(position_of(model, to) - position_of(model, from));
    sum += dot(along, velocity_of(to) - velocity_of(from));
  }
  return sum;
}

void start(const Model& model, Constraint& c, double tolerance) {
  start_number(c, std::fmax(0.0, value(model, c) - c.number.now), rate(model, c), tolerance * c.number.now);
}

double gap(const Model& model, const Constraint& c) {
  return std::fmax(0.0, value(model, c) - c.number.now - c.attract.excess);
}

/// Whether a segment cannot change its length.
bool is_fixed(const Model& model, const Passage& from, const Passage& to) {
  if (!from.point || !to.point) return !from.point && !to.point;
  const BodyId body = model.points[from.point].body;
  return body && body == model.points[to.point].body;
}

double fixed_length(const Model& model, const Constraint& c) {
  double sum = 0.0;
  for (std::size_t i = 1; i < c.passages().size(); i++)
    if (is_fixed(model, c.passages()[i - 1], c.passages()[i]))
      sum += norm(position_of(model, c.passages()[i]) - position_of(model, c.passages()[i - 1]));
  return sum;
}

std::vector<RowPlan> rows(const Model& model, const Constraint& c) {
  std::vector<RowPlan> plans;
  for (std::uint32_t i = 0; i + 1 < c.passages().size(); i++) {
    PointId from = c.passages()[i].point, to = c.passages()[i + 1].point;
    if (is_fixed(model, c.passages()[i], c.passages()[i + 1])) continue;
    if (!from) std::swap(from, to);
    plans.push_back({&coupled_row, false, from, to, {}, {}, zero3(), zero3(), i});
  }
  return plans;
}

void load(Condition& condition, const Row&, const Model& model, const Constraint& c) {
  const Passage &from = c.passages()[condition.index], &to = c.passages()[condition.index + 1];
  condition.whole0 = condition.whole1 = model.plane.along(from.point ? to.position : from.position);
  condition.velocity = zero3();
  const double fixed = fixed_length(model, c);
  condition.whole_value0 -= fixed;
  condition.whole_value1 -= fixed;
}

}  // namespace

const ConstraintRule string_rule = {
    .keeps = kept_length,
    .check = check,
    .freedoms = [](const Constraint&) { return FreedomsTaken{}; },
    .directions = no_direction,
    .start = start,
    .gap = gap,
    .size = [](const Constraint& c) { return c.number.now; },
    .value = value,
    .rows = rows,
    .load = load,
    .has_range = [](const Constraint&) { return true; },
};

}  // namespace pantin
