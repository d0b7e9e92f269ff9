#include "player/trajectory.hpp"

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "forces/curves.hpp"
#include "laws/run/sites.hpp"
#include "measure/query.hpp"

namespace pantin::player {
namespace {

template <class... Numbers>
void put(std::string& out, Numbers... numbers) {
  char digits[32];
  for (const double x : {static_cast<double>(numbers)...}) {
    out += ' ';
    out.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  }
}

void put(std::string& out, Vec3 v) { put(out, v[0], v[1], v[2]); }

/// A word: what is not a letter, digit or one of "_-+." becomes "_".
std::string word(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && !std::strchr("_-+.", c)) c = '_';
  return name;
}

std::string species(const World& world, const Particle& particle) {
  if (particle.family) return word(world.families[particle.family].name);
  if (particle.is_hinge()) return "hinge";
  return world.points[particle.points[0]].body ? "point" : "particle";
}

void put_row(std::string& out, const World& world, ParticleId id) {
  const Particle& particle = world.particles[id];
  out += species(world, particle);
  put(out, Box{world.settings.box.value_or(zero3())}.wrapped(position(world, id)));
  put(out, velocity(world, id));
  double mass = 0.0;
  for (const PointId point : particle.points) mass += world.points[point].mass;
  const Color color = present_color(world, id);
  put(out, mass, present_radius(world, id), color.r, color.g, color.b);
  out.append(" ").append(std::to_string(particle.serial)).append("\n");
}

}  // namespace

std::string xyz_frame(const World& world) {
  const std::vector<ParticleId> rows = particles(world);
  std::string out = std::to_string(rows.size()) + "\n";
  if (world.settings.box) {
    const Vec3 edge = *world.settings.box;
    out += "Lattice=\"";
    std::string edges;
    put(edges, edge[0], 0, 0, 0, edge[1], 0, 0, 0, edge[2]);
    out.append(edges, 1).append("\" pbc=\"T T T\" ");
  }
  out += "Properties=species:S:1:pos:R:3:velo:R:3:mass:R:1:radius:R:1:color:R:3:id:I:1 Time=";
  std::string time;
  put(time, world.time);
  out.append(time, 1).append("\n");
  for (const ParticleId id : rows) put_row(out, world, id);
  return out;
}

Trajectory::Trajectory(std::string path, double rate, double pace)
    : path_(std::move(path)), file_(path_, std::ios::binary), clock_{rate, pace} {
  require(file_.good(), "trajectory '", path_, "' cannot be written: ", std::strerror(errno));
}

void Trajectory::add_frames(const World& world) {
  while (clock_.take(world)) file_ << xyz_frame(world);
}

void Trajectory::finish() {
  file_.close();
  require(file_.good(), "trajectory '", path_, "' cannot be written: ", std::strerror(errno));
}

}  // namespace pantin::player
