#include "model/weigh.hpp"

#include "model/model.hpp"

namespace pantin {
namespace {

constexpr double same_position = 1e-13;  // relative to the largest coordinate: round-off of one position
constexpr double same_line = 1e-9;       // relative to the extent
constexpr double no_inertia = 1e-12;     // about a line, relative to that across it
constexpr double no_moment = 1e-24;      // relative to mass x extent²

/// Places that count for how it lies: all points, and the position of its own mass.
struct Layout {
  double extent = 0.0;    // [m] farthest position from the first
  double coordinate = 0;  // [m] largest
  Vec3 along = zero3();   // direction of the farthest
  bool line = true;       // all on one line
  bool spot = true;       // all at one position
};

template <class Each>
Layout layout_of(Vec3 first, const Each& each) {
  Layout s;
  each([&](Vec3 position, double) {
    s.coordinate = std::fmax(s.coordinate, largest(position));
    const double far = norm(position - first);
    if (far > s.extent) s.extent = far, s.along = (position - first) / far;
  });
  s.spot = s.extent <= same_position * s.coordinate;
  each([&](Vec3 position, double) {
    const Vec3 d = position - first;
    if (norm(d - s.along * dot(d, s.along)) > same_line * s.extent) s.line = false;
  });
  return s;
}

Mat3 about_distance(double mass, Vec3 r) { return (diagonal(vec(1, 1, 1) * norm2(r)) - outer(r, r)) * mass; }

double largest_of(const Mat3& a) { return std::fmax(largest(a[0]), std::fmax(largest(a[1]), largest(a[2]))); }

/// Moments as a loose body moves with them: see Freedom.
void settle(Weighed& w, const Layout& layout) {
  const double most = w.moments[2];
  if (layout.spot && !(most > 0.0)) {
    w.freedom = Freedom::point;
    w.moments = zero3();
  } else if (w.moments[0] <= no_inertia * most) {
    w.bare = !layout.line || layout.spot;
    w.freedom = w.bare ? Freedom::rigid : Freedom::line;
    w.moments = w.bare ? lifted(w.moments) : vec(most, most, most);
  }
}

/// The moment about a normal alone; `axes` (principal axes to the frame) have it for one of theirs.
void settle_in_plane(Weighed& w, const Mat3& inertia, const Quat& axes, Vec3 normal) {
  w.axes = axes;
  const Vec3 n = rotate(conjugate(axes), normal);
  for (int i = 0; i < 3; i++)
    if (std::fabs(n[i]) > 0.9) w.moments[i] = dot(normal, inertia * normal);
  w.freedom = largest(w.moments) > 0.0 ? Freedom::rigid : Freedom::point;
}

}  // namespace

Vec3 lifted(Vec3 moments) {
  const double least = least_inertia * moments[2];
  return vec(std::fmax(moments[0], least), std::fmax(moments[1], least), moments[2]);
}

Weighed weigh(const std::string& who, std::span<const MassPoint> points, const OwnMass& own, const Quat& near,
              Vec3 normal) {
  const auto each = [&](const auto& visit) {
    if (own.mass > 0.0) visit(own.position, own.mass);
    for (const MassPoint& p : points) visit(p.position, p.mass);
  };
  const Vec3 first = own.mass > 0.0 || points.empty() ? own.position : points[0].position;
  Weighed w;
  Vec3 moment = zero3();
  each([&](Vec3 position, double mass) {
    w.mass += mass;
    moment += (position - first) * mass;
  });
  require(w.mass > 0.0, who, ": mass must be > 0 kg, got ", w.mass);
  require(std::isfinite(w.mass), who, ": the masses add up to infinity; each must be smaller");
  const Vec3 from_first = moment / w.mass;
  w.centre = first + from_first;
  Mat3 inertia = own.inertia;
  each([&](Vec3 position, double mass) { inertia += about_distance(mass, position - first - from_first); });
  bool good = finite(w.centre);
  for (int i = 0; i < 3; i++) good = good && finite(inertia[i]);
  require(good, who, ": its inertia is too large for a number; masses [kg] or positions [m] must be smaller");

  const bool flat = norm2(normal) > 0.0;
  const auto seen = [&](Vec3 position) { return flat ? position - normal * dot(normal, position) : position; };
  const auto about = [&](const Mat3& m) { return flat ? outer(normal, normal) * dot(normal, m * normal) : m; };
  const Layout layout = layout_of(
      seen(first), [&](const auto& visit) { each([&](Vec3 position, double mass) { visit(seen(position), mass); }); });
  const double tiny = layout.spot ? 0.0 : no_moment * w.mass * layout.extent * layout.extent;
  inertia = layout.spot && !(largest_of(about(own.inertia)) > 0.0) ? zero33() : about(inertia);
  require(layout.spot || largest_of(inertia) > tiny, who,
          ": all its mass is at one position but it has points elsewhere, so it has no inertia to turn with; give "
          "`inertia` [kg m²], or give those points mass, or use a `rod` instead");
  if (flat) {
    settle_in_plane(w, inertia, near, normal);
    return w;
  }
  const Principal principal = principal_axes(inertia, matrix(near));
  w.moments = principal.moments;
  w.axes = quaternion(principal.axes);
  settle(w, layout);
  return w;
}

}  // namespace pantin
