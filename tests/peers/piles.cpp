#include "peers/piles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace pantin::peers {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double density = 100.0;  // [kg/m³] of what has sizes of its own

/// Linear congruential: every engine and compiler gets the same start.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : state_(16 + seed) {}
  double between(double low, double high) {
    state_ = state_ * 1664525u + 1013904223u;
    return low + (high - low) * static_cast<double>(state_ >> 8) / 16777216.0;
  }
  double about(double size) { return between(-size, size); }

 private:
  std::uint32_t state_;
};

Quaterniond about_axis(double angle, const Vector3d& axis) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); }

class Builder {
 public:
  Builder(const std::string& name, bool in_plane, std::uint32_t seed) : chance_(seed), plane_(in_plane) {
    made_.name = name;
  }

  Mechanism finish() { return std::move(made_); }

  void stack(int n) {
    floor();
    for (int i = 0; i < n; i++)
      add(Form::box, {0.5, 0.5, 0.5}, 1.0, {chance_.about(1e-3), 0.5 + i * 1.001, depth(chance_.about(1e-3))});
  }

  /// The boxes of a row have gaps of 0.1 to 0.9 mm between them.
  void pyramid(int rows) {
    floor();
    for (int row = 0; row < rows; row++)
      for (int i = 0; i < rows - row; i++)
        add(Form::box, {0.5, 0.5, 0.5}, 1.0,
            {1.0005 * (i - 0.5 * (rows - row - 1)) + chance_.about(2e-4), 0.5 + row, depth(chance_.about(2e-4))});
  }

  void boxes(int n, int heavy_one_of) {
    grid(n, 1.3 * std::cbrt(n / 100.0), 1.02, 0.9);
    for (int i = 0; i < n; i++) {
      const double mass = heavy_one_of > 0 && (i + 1) % heavy_one_of == 0 ? 1000.0 : 1.0;
      const Vector3d at = cell(i, 0.05);
      add(Form::box, {0.2, 0.3, 0.25}, mass, at, turn());
    }
  }

  void slabs(int n) {
    grid(n, 1.0 * std::cbrt(n / 80.0), 0.8, 0.75);
    for (int i = 0; i < n; i++) {
      const Vector3d at = cell(i, 0.05);
      add(Form::box, {0.3, 0.02, 0.2}, 1.0, at, turn());
    }
  }

  void balls(int n) {
    grid(n, 0.9 * std::cbrt(n / 300.0), 0.38, 0.38);
    for (int i = 0; i < n; i++) add(Form::ball, {0.15, 0, 0}, 1.0, cell(i, 0.03));
  }

  void mixed(int n) {
    grid(n, 1.2 * std::cbrt(n / 100.0), 1.05, 1.05);
    for (int i = 0; i < n; i++) {
      const auto length = [&] { return chance_.between(0.1, 0.3); };
      const Vector3d at = cell(i, 0.0);
      if (i % 3 == 0) {
        const double a = length(), b = length(), c = length();
        add(Form::box, {a, b, c}, density * 8 * a * b * c, at, turn());
      } else if (i % 3 == 1) {
        const double radius = length();
        add(Form::ball, {radius, 0, 0}, density * 4 / 3 * pi * std::pow(radius, 3), at);
      } else {
        const double radius = 0.5 * length(), half = length();
        add(Form::capsule, {radius, 0, half}, density * pi * radius * radius * (4 / 3.0 * radius + 2 * half), at,
            turn() * about_axis(pi / 2, Vector3d::UnitX()));
      }
    }
  }

  /// Of five boxes each, along x and z by turns.
  void chains(int n) {
    bin(plane_ ? 3.2 : 1.6);
    for (int i = 0; i < n; i++) {
      const bool across = i % 2 == 1 && !plane_;
      const Vector3d middle(chance_.about(0.3), 0.6 + 0.45 * i, depth(chance_.about(0.3)));
      const Quaterniond q = across ? about_axis(pi / 2, Vector3d::UnitY()) : Quaterniond::Identity();
      for (int k = 0; k < 5; k++) {
        const int link = add(Form::box, {0.25, 0.06, 0.06}, 1.0, middle + q * Vector3d(0.5 * (k - 2), 0, 0), q);
        if (k > 0) made_.joints.push_back({link - 1, link, {0.25, 0, 0}, {-0.25, 0, 0}, false});
      }
    }
  }

  /// Lying, one above the other; in a plane upright.
  void ragdolls(int n) {
    bin(plane_ ? 2.4 : 1.2);
    for (int i = 0; i < n; i++) {
      const Quaterniond q =
          plane_ ? Quaterniond::Identity()
                 : about_axis(chance_.about(pi), Vector3d::UnitY()) * about_axis(-pi / 2, Vector3d::UnitX());
      const double side = plane_ ? (i % 2 == 0 ? 1.1 : -1.1) : 0.0;
      const double height = plane_ ? 1.2 + 2.0 * (i / 2) : 0.5 + 0.45 * i;
      ragdoll({side + chance_.about(0.1), height, depth(chance_.about(0.1))}, q);
    }
  }

 private:
  double depth(double z) const { return plane_ ? 0.0 : z; }

  Quaterniond turn() {
    if (plane_) return about_axis(chance_.about(pi), Vector3d::UnitZ());
    const double a = chance_.between(0, 1), b = chance_.about(pi), c = chance_.about(pi);
    return {std::sqrt(1 - a) * std::sin(b), std::sqrt(1 - a) * std::cos(b), std::sqrt(a) * std::sin(c),
            std::sqrt(a) * std::cos(c)};
  }

  int add(Form form, const Vector3d& size, double mass, const Vector3d& at,
          const Quaterniond& q = Quaterniond::Identity()) {
    SolidDef solid;
    solid.form = form;
    solid.size = size;
    solid.mass = mass;
    solid.moments = moments_of(form, size, mass);
    solid.at = at;
    solid.turn = q;
    made_.solids.push_back(solid);
    return static_cast<int>(made_.solids.size()) - 1;
  }

  void floor() { made_.walls.push_back({Vector3d::UnitY(), 0.0}); }

  void bin(double half) {
    floor();
    made_.walls.push_back({Vector3d::UnitX(), -half});
    made_.walls.push_back({-Vector3d::UnitX(), -half});
    if (plane_) return;
    made_.walls.push_back({Vector3d::UnitZ(), -half});
    made_.walls.push_back({-Vector3d::UnitZ(), -half});
  }

  /// A bin, and cells in it `wide` [m] from each other, in layers `rise` [m] apart.
  void grid(int n, double half, double wide, double rise) {
    wide_ = wide;
    rise_ = rise;
    if (plane_) half = 2.0 * half * std::pow(n / 100.0, 1.0 / 6.0);
    half = std::max(half, 0.55 * wide);
    side_ = 1 + static_cast<int>(std::max(0.0, 2 * half - 1.05 * wide) / wide);
    bin(half);
  }

  Vector3d cell(int i, double shift) {
    const auto place = [&](int k) { return wide_ * (k % side_ - 0.5 * (side_ - 1)); };
    const double x = place(i) + chance_.about(shift), z = plane_ ? 0.0 : place(i / side_) + chance_.about(shift);
    const int layer = plane_ ? i / side_ : i / (side_ * side_);
    return {x, 0.6 + rise_ * layer, z};
  }

  void ragdoll(const Vector3d& at, const Quaterniond& q) {
    const auto part = [&](Form form, const Vector3d& size, double mass, const Vector3d& place,
                          const Quaterniond& own = Quaterniond::Identity()) {
      return add(form, size, mass, at + q * place, q * own);
    };
    const auto tie = [&](int a, int b, const Vector3d& place) {
      const auto in = [&](int i) -> Vector3d {
        const SolidDef& solid = made_.solids[static_cast<std::size_t>(i)];
        return solid.turn.conjugate() * (at + q * place - solid.at);
      };
      made_.joints.push_back({a, b, in(a), in(b), false});
    };
    const int torso = part(Form::box, {0.15, 0.25, 0.08}, 20.0, {0, 0, 0});
    tie(torso, part(Form::ball, {0.11, 0, 0}, 4.0, {0, 0.38, 0}), {0, 0.26, 0});
    const Quaterniond sideways = about_axis(pi / 2, Vector3d::UnitY());
    const Quaterniond upright = about_axis(pi / 2, Vector3d::UnitX());
    for (const double s : {-1.0, 1.0}) {
      const int arm = part(Form::capsule, {0.05, 0, 0.1}, 2.0, {s * 0.31, 0.2, 0}, sideways);
      tie(torso, arm, {s * 0.16, 0.2, 0});
      tie(arm, part(Form::capsule, {0.04, 0, 0.1}, 1.5, {s * 0.62, 0.2, 0}, sideways), {s * 0.47, 0.2, 0});
      const int thigh = part(Form::capsule, {0.07, 0, 0.14}, 6.0, {s * 0.09, -0.47, 0}, upright);
      tie(torso, thigh, {s * 0.09, -0.26, 0});
      tie(thigh, part(Form::capsule, {0.05, 0, 0.14}, 3.0, {s * 0.09, -0.88, 0}, upright), {s * 0.09, -0.69, 0});
    }
  }

  Mechanism made_;
  Chance chance_;
  bool plane_;
  double wide_ = 0.0, rise_ = 0.0;
  int side_ = 1;
};

}  // namespace

Eigen::Vector3d moments_of(Form form, const Eigen::Vector3d& size, double mass) {
  if (form == Form::ball) return Vector3d::Constant(0.4 * mass * size.x() * size.x());
  if (form == Form::box) {
    const Vector3d s = size.cwiseProduct(size);
    return mass / 3.0 * Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
  }
  const double r = size.x(), half = size.z();
  const double ends = mass * (4 / 3.0 * r) / (4 / 3.0 * r + 2 * half), middle = mass - ends;
  const double along = ends * 0.4 * r * r + middle * 0.5 * r * r;
  // A half ball: 83/320 m r² about its centre, which lies 3/8 r from its face.
  const double across =
      ends * (83.0 / 320.0 * r * r + std::pow(half + 0.375 * r, 2)) + middle * (r * r / 4 + half * half / 3);
  return {across, across, along};
}

Mechanism pile(const std::string& name, bool in_plane, std::uint32_t seed) {
  const auto wrong = [&](const char* why) {
    return std::invalid_argument(
        "'" + name + "' is no case: " + why +
        "; cases are stack(n), pyramid(rows), boxes(n), balls(n), mixed(n), slabs(n), chains(n), "
        "ragdolls(n) and heavy(n)");
  };
  const std::size_t open = name.find('(');
  const std::string kind = name.substr(0, open);
  const std::string number = open == std::string::npos ? "" : name.substr(open + 1);
  if (number.size() < 2 || number.back() != ')' || number.find_first_not_of("0123456789") != number.size() - 1)
    throw wrong("it needs a number, as in boxes(100)");
  const int n = number.size() > 6 ? 0 : std::stoi(number);
  if (n < 1 || n > 10000) throw wrong("the number must be from 1 to 10000");
  Builder builder(name, in_plane, seed);
  if (kind == "stack")
    builder.stack(n);
  else if (kind == "pyramid")
    builder.pyramid(n);
  else if (kind == "boxes")
    builder.boxes(n, 0);
  else if (kind == "heavy")
    builder.boxes(n, 16);
  else if (kind == "balls")
    builder.balls(n);
  else if (kind == "mixed")
    builder.mixed(n);
  else if (kind == "slabs")
    builder.slabs(n);
  else if (kind == "chains")
    builder.chains(n);
  else if (kind == "ragdolls")
    builder.ragdolls(n);
  else
    throw wrong("nothing is called so");
  return builder.finish();
}

std::vector<std::string> usual_piles() {
  return {"stack(10)",  "stack(30)",  "pyramid(20)", "boxes(100)", "balls(300)",
          "mixed(100)", "chains(12)", "ragdolls(8)", "heavy(80)"};
}

}  // namespace pantin::peers
