#include "player/lammps/dump.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "choreography/resume.hpp"
#include "edit/edit.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

constexpr double largest = 1e100;  ///< of the numbers of a dump, whose squares are to be finite
constexpr double latest = 1e15;    ///< timestep of a dump

/// One picture of a text dump: what it is of, the names of its columns, and its rows.
class Picture {
 public:
  /// Throws Error where it is not whole.
  Picture(std::string_view content, std::string path) : rest_(content), path_(std::move(path)) {
    while (!rest_.starts_with("ITEM: ATOMS")) {
      const std::string_view item = line();
      if (item.starts_with("ITEM: TIMESTEP")) step = number<double>(line());
      if (item.starts_with("ITEM: NUMBER OF ATOMS")) count = number<std::size_t>(line());
      if (item.starts_with("ITEM: BOX BOUNDS"))
        for (double& edge : edges) edge = extent_of(line());
    }
    names_ = words(line().substr(std::string_view("ITEM: ATOMS").size()));
  }

  double step = 0.0;
  std::size_t count = 0;
  std::array<double, 3> edges{};  // [m] of its box

  bool has(std::initializer_list<const char*> names) const {
    return std::ranges::all_of(names, [&](const char* name) { return std::ranges::count(names_, name) > 0; });
  }
  /// Calls `take` with an atom's number, from 0, and what is in some columns.
  void each_row(const std::vector<const char*>& columns,
                const std::function<void(std::size_t, std::span<const double>)>& take) {
    std::vector<std::size_t> at;
    for (const char* column : columns) at.push_back(place_of(column));
    const std::size_t id_at = place_of("id");
    std::vector<char> seen(count, 0);
    std::vector<double> values(columns.size());
    for (std::size_t i = 0; i < count; i++) {
      const std::vector<std::string_view> row = words(line());
      require(row.size() >= names_.size(), path_, ": this is no whole dump of LAMMPS");
      const auto id = number<std::size_t>(row[id_at]);
      require(id >= 1 && id <= count && !std::exchange(seen[id - 1], 1), path_, ": atom ", id,
              " comes twice, or is none");
      for (std::size_t k = 0; k < at.size(); k++) {
        values[k] = number<double>(row[at[k]]);
        require(std::abs(values[k]) <= largest, path_, ": atom ", id, " has ", row[at[k]], " as its ", columns[k]);
      }
      take(id - 1, values);
    }
  }

 private:
  std::string_view rest_;
  std::string path_;
  std::vector<std::string_view> names_;

  std::string_view line() {
    const std::size_t end = rest_.find('\n');
    require(end != std::string_view::npos, path_, ": this is no whole dump of LAMMPS");
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return found;
  }
  static std::vector<std::string_view> words(std::string_view from) {
    std::vector<std::string_view> list;
    while (true) {
      const std::size_t begin = from.find_first_not_of(" \t\r");
      if (begin == std::string_view::npos) return list;
      from.remove_prefix(begin);
      list.push_back(from.substr(0, from.find_first_of(" \t\r")));
      from.remove_prefix(list.back().size());
    }
  }
  template <class T>
  T number(std::string_view from) const {
    T value{};
    const std::size_t begin = std::min(from.find_first_not_of(" \t"), from.size());
    const auto [after, error] = std::from_chars(from.data() + begin, from.data() + from.size(), value);
    const bool whole =
        std::string_view(after, from.data() + from.size()).find_first_not_of(" \t\r") == std::string_view::npos;
    require(error == std::errc{} && whole, path_, ": '", printable(from),
            "' is no number; this is no whole dump of LAMMPS");
    return value;
  }
  double extent_of(std::string_view bounds) const {
    const std::vector<std::string_view> ends = words(bounds);
    require(ends.size() >= 2, path_, ": this is no whole dump of LAMMPS");
    return number<double>(ends[1]) - number<double>(ends[0]);
  }
  std::size_t place_of(const char* column) const {
    const auto found = std::ranges::find(names_, column);
    require(found != names_.end(), path_, ": it has no column '", column,
            "'; have LAMMPS write: write_dump all custom end.dump id type xu yu zu vx vy vz modify format float %.17g");
    return static_cast<std::size_t>(found - names_.begin());
  }
};

std::string content_of(const std::string& path) {
  auto content = file_content(path);
  require(content.has_value(), path, ": LAMMPS wrote no such file");
  return *std::move(content);
}

/// Where each picture of a dump begins.
std::vector<std::size_t> beginnings(const std::string& content) {
  constexpr const char* first = "ITEM: TIMESTEP";
  std::vector<std::size_t> list;
  for (std::size_t at = content.find(first); at != std::string::npos; at = content.find(first, at + 1))
    list.push_back(at);
  return list;
}

/// LAMMPS may have changed it, as its barostats do.
void check_box(const Picture& picture, const std::string& path, const Vec3& box) {
  for (std::size_t k = 0; k < 3; k++)
    require(std::abs(picture.edges[k] - box[k]) <= 1e-9 * box[k], path, ": its box is ", picture.edges[0], " x ",
            picture.edges[1], " x ", picture.edges[2], " m, and the scene's ", box[0], " x ", box[1], " x ", box[2],
            " m");
}

LammpsState state_of(Picture picture, const std::string& path, const LammpsSystem& system,
                     const std::optional<Vec3>& box) {
  const std::size_t count = system.atoms.size();
  require(picture.step >= 0.0 && picture.step <= latest && picture.step == std::floor(picture.step), path,
          ": it is of timestep ", picture.step, ", which is no number of steps: the dump was altered");
  if (box) check_box(picture, path, *box);
  require(picture.count == count, path, ": it has ", picture.count, " atoms, and the scene has ", count,
          ": LAMMPS lost some, or it is of another scene");
  std::vector<const char*> columns = {"xu", "yu", "zu", "vx", "vy", "vz"};
  const bool unwrapped = picture.has({"xu", "yu", "zu"}), turns = picture.has({"ix", "iy", "iz"});
  if (!unwrapped && picture.has({"x", "y", "z"}) && (turns || !box)) columns = {"x", "y", "z", "vx", "vy", "vz"};
  if (!unwrapped && turns) columns.insert(columns.end(), {"ix", "iy", "iz"});
  const bool typed = picture.has({"type"});
  if (typed) columns.push_back("type");
  LammpsState state{picture.step, DumpedAtoms(count)};
  picture.each_row(columns, [&](std::size_t atom, std::span<const double> row) {
    require(!typed || row.back() == system.type_of[atom], path, ": atom ", atom + 1, " is of another type than ",
            "particle ", atom + 1, " of the scene: it is of another scene, or of other --set");
    for (std::size_t k = 0; k < 6; k++) state.atoms[atom][k] = row[k];
    for (std::size_t k = 0; k < 3 && !unwrapped && turns; k++) state.atoms[atom][k] += row[6 + k] * picture.edges[k];
  });
  return state;
}

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

/// The dump of another scene tears bodies.
void check_shape(const World& world, BodyId body, const std::vector<Vec3>& x, const std::vector<Vec3>& v) {
  const std::vector<PointId>& points = world.bodies[body].points;
  double size = 0.0, missed = 0.0, far = 0.0, fastest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < x.size(); i++) {
    size = std::max({size, norm(x[i] - x[0]), 1e-9 * norm(x[i])});
    missed = std::max(missed, norm(x[i] - position(world, points[i])));
    far = std::max(far, norm(x[i]));
    fastest = std::max(fastest, norm(v[i]));
    apart = std::max(apart, norm(v[i] - velocity(world, points[i])));
  }
  const bool has_few_digits = missed <= 1e-5 * far && missed <= 0.01 * size;
  require(missed <= 1e-6 * size, describe(world, body), " has another shape in LAMMPS, by ", rounded(missed), " m: ",
          has_few_digits
              ? "the numbers of the dump have too few digits; have LAMMPS write it with modify format float %.17g"
              : "the dump is of another scene, or of other --set");
  require(apart <= 1e-3 * fastest, describe(world, body), " moves in LAMMPS as no rigid body does, by ", rounded(apart),
          " m/s: the dump was altered, or is of another scene");
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
  check_shape(world, body, x, v);
}

}  // namespace

std::vector<Vec3> read_forces(const std::string& path, std::size_t count) {
  const std::string content = content_of(path);
  Picture picture(content, path);
  require(picture.count == count, path, ": it has ", picture.count, " atoms, and there were ", count,
          ": LAMMPS lost some");
  std::vector<Vec3> forces(count);
  picture.each_row({"fx", "fy", "fz"},
                   [&](std::size_t atom, std::span<const double> row) { forces[atom] = vec(row[0], row[1], row[2]); });
  return forces;
}

LammpsState read_state(const std::string& path, const LammpsSystem& system, const std::optional<Vec3>& box) {
  const std::string content = content_of(path);
  const std::vector<std::size_t> begins = beginnings(content);
  require(!begins.empty(), path, ": this is no text dump of LAMMPS");
  const auto read = [&](std::size_t begin) {
    return state_of(Picture(std::string_view(content).substr(begin), path), path, system, box);
  };
  if (begins.size() == 1) return read(begins.back());
  try {
    return read(begins.back());
  } catch (const Error&) { return read(begins[begins.size() - 2]); }  // LAMMPS was ended while it wrote the last
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
