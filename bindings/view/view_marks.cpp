#include "view/view_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "articulates/articulate.hpp"
#include "contacts/touching.hpp"
#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "view/draw_list.hpp"

namespace pantin {

namespace {

constexpr Color force_color = {0.82f, 0.18f, 0.24f, 1.0f}, velocity_color = {0.14f, 0.45f, 0.78f, 1.0f},
                cell_color = {0.45f, 0.55f, 0.62f, 0.35f}, next_color = {0.45f, 0.44f, 0.42f, 1.0f},
                highlight_color = {0.85f, 0.20f, 0.26f, 1.0f}, contact_force_color = {0.90f, 0.45f, 0.05f, 1.0f},
                contact_color = {0.05f, 0.55f, 0.45f, 1.0f}, near_color = {0.50f, 0.52f, 0.55f, 0.8f};
constexpr double shown_time = 0.1;   // [s] at the scene's pace: of its motion that a velocity's arrow is long
constexpr double ring_part = 0.22;   // of the unit: how far members are drawn from their hinge
constexpr double normal_part = 0.4;  // of the thickness: how long a normal is
constexpr std::size_t most_cells = 1500;

Mark mark(Mark::Kind kind, Vec3 from, Vec3 to, const Color& color, double size) {
  return {kind, from, to, color, size, false, {}};
}

/// Members round their hinge, each on the way to its body.
void add_ring(const World& world, const Particle& ring, const Stage& stage, std::vector<Mark>& marks) {
  const Vec3 at = shown_place(world, ring.points[0]);
  if (!finite(at)) return;
  const auto place = [&](PointId id) {
    const BodyId body = world.points[id].body;
    const Vec3 away = body ? world.motion_of(body).x + image_shift(world, world.motion_of(body).x) - at : zero3();
    const double far_off = norm(away);
    return at + away * (far_off > 0.0 ? std::min(ring_part * stage.unit / far_off, 0.5) : 0.0);
  };
  for (std::size_t i = 0; i < ring.points.size(); i++) {
    const PointId id = ring.points[i], next = ring.points[(i + 1) % ring.points.size()];
    const Vec3 here = place(id), there = place(next);
    const Color color = world.points[id].color;
    marks.push_back(mark(Mark::Kind::line, at, here, color, 2.0));
    if (ring.points.size() > 2 || i == 0)
      marks.push_back(mark(Mark::Kind::arrow, here, here + (there - here) * 0.85, next_color, 1.5));
    marks.push_back(mark(Mark::Kind::point, here, here, color, 9.0));
  }
  marks.push_back(mark(Mark::Kind::point, at, at, next_color, 5.0));
}

void add_rings(const World& world, const Stage& stage, std::vector<Mark>& marks) {
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && world.particles.at_slot(s).is_hinge())
      add_ring(world, world.particles.at_slot(s), stage, marks);
}

/// Calls visit(place, force [N], colour) for what hinges and constraints, and contacts, exerted in the last step.
template <class Visit>
void each_force(const World& world, const Views& views, Visit visit) {
  if (views.on(View::contact_forces))
    for (const Contact& c : world.contacts.list)
      visit(c.at + image_shift(world, c.at), contact_force(world, c), contact_force_color);
  if (!views.on(View::forces)) return;
  const auto visit_point = [&](PointId id, Vec3 force) { visit(shown_place(world, id), force, force_color); };
  for (const auto& articulate : world.articulates)
    for (const Row& row : articulate->rows)
      if (row.condition < 0 && world.points.alive(row.member)) visit_point(row.member, row.f);
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
    if (!world.constraints.alive_at(s)) continue;
    const Constraint& c = world.constraints.at_slot(s);
    if (c.enabled && world.points.alive(c.a)) visit_point(c.a, c.force);
  }
}

/// Each contact with its normal, and its manifold as lines from the middle.
void add_contacts(const World& world, std::vector<Mark>& marks) {
  const std::vector<Contact>& list = world.contacts.list;
  for (std::size_t from = 0, end = 0; from < list.size(); from = end) {
    Vec3 middle = zero3();
    for (end = from; end < list.size() && list[end].key.same_shapes(list[from].key); end++) middle += list[end].at;
    middle = middle / static_cast<double>(end - from);
    const Vec3 shift = image_shift(world, middle);
    if (!finite(middle)) continue;
    for (std::size_t k = from; k < end; k++) {
      const Contact& c = list[k];
      const Vec3 at = c.at + shift;
      const Color& color = presses(c) ? contact_color : near_color;
      if (end > from + 1) marks.push_back(mark(Mark::Kind::line, middle + shift, at, color, 1.0));
      marks.push_back(mark(Mark::Kind::arrow, at, at + c.normal * (normal_part * c.size), color, 1.5));
      marks.push_back(mark(Mark::Kind::point, at, at, color, 6.0));
    }
  }
}

void add_velocities(const World& world, double pace, std::vector<Mark>& marks) {
  const auto add = [&](Vec3 at, Vec3 v) {
    if (finite(at) && finite(v))
      marks.push_back(mark(Mark::Kind::arrow, at, at + v * (shown_time * pace), velocity_color, 2.0));
  };
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) {
    const Motion& m = world.motion[s];
    if (world.bodies.alive_at(s) && m.mass > 0.0) add(m.x + image_shift(world, m.x), m.p / m.mass);
  }
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body)
      add(world.free_motion[s].x + image_shift(world, world.free_motion[s].x), world.free_motion[s].v);
}

void add_cell(const Grid& grid, const std::array<std::int32_t, 3>& cell, std::vector<Mark>& marks) {
  const auto corner = [&](int bits) {
    Vec3 at = zero3();
    for (std::size_t k = 0; k < 3; k++)
      at[static_cast<int>(grid.axis[k])] = grid.origin[k] + (cell[k] + (bits >> k & 1)) / grid.cells_per_metre[k];
    return at;
  };
  for (int from = 0; from < 8; from++)
    for (int k = 0; k < 3; k++)
      if (!(from >> k & 1))
        marks.push_back(mark(Mark::Kind::line, corner(from), corner(from | 1 << k), cell_color, 1.0));
}

}  // namespace

void ViewMarks::add_forces(const World& world, const Views& views, const Stage& stage, std::vector<Mark>& marks) {
  double most = 0.0;
  each_force(world, views, [&](Vec3, Vec3 force, const Color&) { most = std::fmax(most, norm(force)); });
  if (!(most > 0.0) || !std::isfinite(most)) return;
  const double longest = std::max(stage.unit, 0.1 * stage.size);  // [m]
  each_force(world, views, [&](Vec3 at, Vec3 force, const Color& color) {
    const double part = norm(force) / most;
    if (!(part > 1e-4) || !finite(at)) return;
    marks.push_back(mark(Mark::Kind::arrow, at, at + force * (longest * std::sqrt(part) / norm(force)), color, 2.0));
  });
  char line[80];
  std::snprintf(line, sizeof line, "forces: longest %.3g N, length by the root", most);
  legend_ = line;
}

/// The occupied cells of the first interaction that looks for neighbours.
void ViewMarks::add_cells(const World& world, std::vector<Mark>& marks) {
  if (!world.forces || !world.forces->rows) return;
  const Forces& forces = *world.forces;
  const auto cut = std::ranges::find_if(forces.interactions, [](const ActingInteraction& i) {
    return i.pairs.neighbours.cutoff() > 0.0 && std::isfinite(i.pairs.neighbours.cutoff());
  });
  if (cut == forces.interactions.end() || !world.interactions.alive(cut->id)) return;
  const Interaction& interaction = world.interactions[cut->id];
  const Box box{world.settings.box.value_or(zero3())};
  positions_.clear();
  members_.clear();
  cells_.clear();
  for (std::uint32_t i = 0; i < forces.sites.n; i++) {
    const Vec3 at = forces.sites.x[i];
    const FamilyId family = world.particles.at_slot(forces.sites.particle[i]).family;
    if (!finite(at) || (family != interaction.a && family != interaction.b)) continue;
    members_.push_back(static_cast<std::uint32_t>(positions_.size()));
    positions_.push_back(box.wrapped(at));
  }
  if (positions_.empty()) return;
  const Grid grid =
      make_grid(positions_, members_, members_, box, cut->pairs.neighbours.cutoff() + forces.skin.width());
  for (const Vec3 at : positions_) cells_.push_back({grid.cell(0, at), grid.cell(1, at), grid.cell(2, at)});
  std::ranges::sort(cells_);
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  if (cells_.size() > most_cells) cells_.resize(most_cells);
  for (const auto& cell : cells_) add_cell(grid, cell, marks);
}

void add_highlight(const World& world, PointId point, std::vector<Mark>& marks) {
  const Vec3 at = shown_place(world, point);
  marks.push_back(mark(Mark::Kind::ring, at, at, highlight_color, world.points[point].body ? 28.0 : 22.0));
}

void ViewMarks::add(const World& world, const Views& views, const Stage& stage, double pace, std::vector<Mark>& marks) {
  legend_.clear();
  if (views.on(View::cells)) add_cells(world, marks);
  if (views.on(View::velocities)) add_velocities(world, pace, marks);
  if (views.on(View::forces) || views.on(View::contact_forces)) add_forces(world, views, stage, marks);
  if (views.on(View::contacts)) add_contacts(world, marks);
  if (views.on(View::rings)) add_rings(world, stage, marks);
}

}  // namespace pantin
