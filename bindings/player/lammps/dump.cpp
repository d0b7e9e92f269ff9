#include "player/lammps/dump.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "choreography/resume.hpp"
#include "edit/edit.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

/// Reads numbers from a text.
class Numbers {
 public:
  Numbers(const std::string& content, std::string path)
      : at_(content.data()), end_(at_ + content.size()), path_(std::move(path)) {}

  /// The rest of the line that begins with a text, which must come.
  void skip_past(const char* begin) {
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    const std::size_t found = rest.find(begin);
    const std::size_t line = found == std::string_view::npos ? found : rest.find('\n', found);
    require(line != std::string_view::npos, path_, ": this is no whole dump of LAMMPS");
    at_ += line + 1;
  }
  template <class T>
  T next() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\n')) at_++;
    T value{};
    const auto [after, error] = std::from_chars(at_, end_, value);
    require(error == std::errc{}, path_, ": this is no whole dump of LAMMPS, or a number in it is not finite");
    at_ = after;
    return value;
  }

 private:
  const char *at_, *end_;
  std::string path_;
};

/// Axes along two directions, the first exactly.
Mat3 axes_along(Vec3 first, Vec3 second) {
  const Vec3 x = first / norm(first), z = cross(x, second), unit_z = z / norm(z);
  return {{x, cross(unit_z, x), unit_z}};
}

/// The rotation that takes one unit vector to another the shortest way.
Quat shortest_turn(Vec3 from, Vec3 to) {
  const Vec3 axis = cross(from, to);
  const double w = 1.0 + dot(from, to);
  if (w < 1e-12) {  // the opposite: about any axis across
    const Vec3 across = cross(from, std::abs(from[0]) < 0.9 ? vec(1, 0, 0) : vec(0, 1, 0));
    return normalised(Quat{0.0, across[0], across[1], across[2]});
  }
  return normalised(Quat{w, axis[0], axis[1], axis[2]});
}

/// A body as its points tell it.
class BodyState {
 public:
  BodyState(const World& world, BodyId body, const std::vector<Vec3>& x, const std::vector<Vec3>& v)
      : world_(world), body_(body) {
    double mass = 0.0;
    const std::vector<PointId>& points = world.bodies[body].points;
    for (std::size_t i = 0; i < points.size(); i++) {
      const double m = world.points[points[i]].mass;
      mass += m;
      centre += x[i] * m;
      velocity += v[i] * m;
      local_.push_back(world.points[points[i]].position - world.bodies[body].centre);
    }
    centre = centre / mass;
    velocity = velocity / mass;
    for (std::size_t i = 0; i < points.size(); i++) {
      turned_.push_back(x[i] - centre);
      angular += cross(turned_[i], (v[i] - velocity) * world.points[points[i]].mass);
    }
  }

  Vec3 centre = zero3(), velocity = zero3();  // [m], [m/s]
  Vec3 angular = zero3();                     // [kg m²/s]

  Quat orientation() const {
    const std::size_t a = farthest([&](std::size_t i) { return norm(local_[i]); });
    const auto off = [&](std::size_t i) { return norm(cross(local_[a], local_[i])); };
    const std::size_t b = farthest(off);
    const double size = norm(local_[a]);
    if (off(b) > 1e-6 * size * size)
      return quaternion(axes_along(turned_[a], turned_[b]) * transpose(axes_along(local_[a], local_[b])));
    const Quat before = pantin::orientation(world_, body_);
    return shortest_turn(rotate(before, local_[a]) / size, turned_[a] / norm(turned_[a])) * before;
  }

 private:
  const World& world_;
  BodyId body_;
  std::vector<Vec3> local_, turned_;  // [m] about the centre, in the frame and in the world

  template <class Measure>
  std::size_t farthest(Measure measure) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < local_.size(); i++)
      if (measure(i) > measure(best)) best = i;
    return best;
  }
};

Vec3 part(const DumpedAtoms& atoms, std::uint32_t atom, std::size_t from) {
  return vec(atoms[atom][from], atoms[atom][from + 1], atoms[atom][from + 2]);
}

void put_body(World& world, BodyId body, const std::vector<std::uint32_t>& atom_of, const DumpedAtoms& atoms) {
  std::vector<Vec3> x, v;
  for (PointId point : world.bodies[body].points) {
    const std::uint32_t atom = atom_of[world.points[point].particle.slot - 1];
    x.push_back(part(atoms, atom, 0));
    v.push_back(part(atoms, atom, 3));
  }
  const BodyState state(world, body, x, v);
  if (x.size() > 1) set_orientation(world, body, state.orientation());
  set_position(world, body, state.centre);
  set_velocity(world, body, state.velocity);
  if (x.size() == 1) return;
  const Motion& motion = world.motion_of(body);
  const Vec3 own = rotate(conjugate(motion.q), state.angular);
  set_spin(world, body, rotate(motion.q, own * inverse_inertia(motion)));
}

}  // namespace

DumpedAtoms read_dump(const std::string& path, std::size_t count, std::size_t columns) {
  const auto content = file_content(path);
  require(content.has_value(), path, ": LAMMPS wrote no such file");
  Numbers numbers(*content, path);
  numbers.skip_past("ITEM: NUMBER OF ATOMS");
  const auto told = numbers.next<std::size_t>();
  require(told == count, path, ": it has ", told, " atoms, and there were ", count, ": LAMMPS lost some");
  numbers.skip_past("ITEM: ATOMS");
  DumpedAtoms atoms(count);
  std::vector<char> seen(count, 0);
  for (std::size_t i = 0; i < count; i++) {
    const auto id = numbers.next<std::size_t>();
    require(id >= 1 && id <= count && !std::exchange(seen[id - 1], 1), path, ": atom ", id, " comes twice, or is none");
    for (std::size_t k = 0; k < columns; k++) {
      atoms[id - 1][k] = numbers.next<double>();
      require(std::isfinite(atoms[id - 1][k]), path, ": atom ", id,
              " is not at a finite place, or not of a finite velocity");
    }
  }
  return atoms;
}

void bring_back(World& world, const LammpsSystem& system, DumpedAtoms atoms, double time) {
  std::vector<std::uint32_t> atom_of(world.particles.slots(), 0);
  for (std::uint32_t i = 0; i < system.atoms.size(); i++) atom_of[system.atoms[i].slot - 1] = i;
  const std::vector<Vec3> away = boxes_away(world, system);
  for (std::uint32_t i = 0; i < system.atoms.size(); i++)
    for (std::size_t k = 0; k < 3; k++) atoms[i][k] += away[i][static_cast<int>(k)];
  for (std::uint32_t i = 0; i < system.atoms.size(); i++) {
    const PointId point = world.particles[system.atoms[i]].points[0];
    if (world.points[point].body) continue;
    set_position(world, point, part(atoms, i, 0));
    set_velocity(world, point, part(atoms, i, 3));
  }
  for (BodyId body : world.bodies.ids()) put_body(world, body, atom_of, atoms);
  begin_at(world, time, time);
}

}  // namespace pantin::player
