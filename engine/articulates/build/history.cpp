#include "articulates/build/history.hpp"

#include <algorithm>

namespace pantin {

namespace {

void copy_lane(Vec3x4& to, std::size_t lane, const Vec3x4& from, std::size_t of) {
  to.x[lane] = from.x[of];
  to.y[lane] = from.y[of];
  to.z[lane] = from.z[of];
}

/// Of articulates that differ only what is true of both: as many last steps as the one that knows least, of other lengths one.
void inherit_predictor(const Predictor& from, Predictor& to, bool first) {
  const bool same = first || (from.since == to.since && from.scale == to.scale);
  to.known = std::min({first ? Predictor::levels : to.known, from.known, same ? Predictor::levels : std::size_t{1}});
  to.rough = to.rough || from.rough;
  to.since = from.since;
  to.scale = from.scale;
  for (std::size_t k = 0; k < Predictor::levels; k++) to.missed[k] += from.missed[k];
}

}  // namespace

History::History(const Model& model, std::span<const Thing> things, const Articulates& before) {
  nodes_.reserve(things.size());
  for (Thing t : things) {
    Origin origin;
    const std::int32_t articulate =
        t.is_body ? model.motion[t.slot].articulate : model.points.at_slot(t.slot).articulate;
    if (articulate >= 0) {
      origin.articulate = before[static_cast<std::size_t>(articulate)].get();
      origin.index = static_cast<std::uint32_t>(node_of(model, t));
    }
    nodes_.push_back(origin);
  }
}

History::Match History::row(const Edge& edge) const {
  const Origin& a = nodes_[static_cast<std::size_t>(edge.a)];
  const Origin& b = edge.b >= 0 ? nodes_[static_cast<std::size_t>(edge.b)] : a;
  if (a.articulate == nullptr || a.articulate != b.articulate) return {};
  const auto on_a = a.articulate->rows_on[a.index], on_b = b.articulate->rows_on[b.index];
  for (std::uint32_t k : on_a.size() < on_b.size() ? on_a : on_b) {
    const Row& row = a.articulate->rows[k];
    const bool same_ends =
        row.a == static_cast<std::int32_t>(a.index) && row.b == (edge.b >= 0 ? static_cast<std::int32_t>(b.index) : -1);
    if (same_ends && is_row_of(*a.articulate, row, edge)) return {a.articulate, &row};
  }
  return {};
}

void History::inherit(Articulate& to) const {
  to.edited = false;
  const Articulate* last = nullptr;
  for (const Origin& origin : nodes_) {
    if (origin.articulate == last || origin.articulate == nullptr) continue;
    const Articulate& from = *origin.articulate;
    to.last_h = last == nullptr || from.last_h == to.last_h ? from.last_h : 0.0;
    inherit_predictor(from.predictor, to.predictor, last == nullptr);
    to.wait = last == nullptr ? from.wait : std::max(to.wait, from.wait);
    to.sub_steps.count = std::max(to.sub_steps.count, from.sub_steps.count);
    to.course.next = std::max(to.course.next, from.course.next);
    to.stages_not_stiff = std::max(to.stages_not_stiff, from.stages_not_stiff);
    to.weak = to.weak || from.weak;
    to.fell_back = to.fell_back || from.fell_back;
    to.edited = to.edited || from.edited || from.has_offsets;
    to.torn = to.torn || from.torn;
    to.effort.usual = last == nullptr ? from.effort.usual : std::max(to.effort.usual, from.effort.usual);
    to.effort.failed = std::max(to.effort.failed, from.effort.failed);
    to.effort.pause = std::max(to.effort.pause, from.effort.pause);
    to.open_steps = std::max(to.open_steps, from.open_steps);
    if (from.epsilon < from.most_epsilon) to.epsilon = std::min(to.epsilon, from.epsilon);
    to.projection_wait = std::max(to.projection_wait, from.projection_wait);
    to.gaps.points = std::fmax(to.gaps.points, from.gaps.points);
    to.gaps.others = std::fmax(to.gaps.others, from.gaps.others);
    to.gaps.unaccepted = std::fmax(to.gaps.unaccepted, from.gaps.unaccepted);
    last = &from;
  }
  to.edited = to.edited || last == nullptr;
}

void History::inherit(Articulate& to, std::span<const std::uint32_t> things) const {
  for (std::size_t n = 0; n < things.size(); n++) {
    const Origin& origin = nodes_[things[n]];
    if (origin.articulate == nullptr) continue;
    const NodeBatch& old = origin.articulate->batches[origin.index / batch_size];
    NodeBatch& batch = to.batches[n / batch_size];
    const std::size_t from = origin.index % batch_size, lane = n % batch_size;
    copy_lane(batch.cayley, lane, old.cayley, from);
    for (std::size_t k = 0; k < Predictor::levels; k++)
      copy_lane(to.predictor.rates[n / batch_size][k], lane,
                origin.articulate->predictor.rates[origin.index / batch_size][k], from);
    for (int k = 0; k < 3; k++) copy_lane(batch.J_inverse[k], lane, old.J_inverse[k], from);
  }
}

}  // namespace pantin
