#include "world/checks.hpp"

#include <cmath>

#include "constraints/kind.hpp"

namespace pantin::internal {

void require_unlocked(const World& world, std::string_view call) {
  require(!world.locked, call, ": the world cannot be edited while it steps; edit in an event or a step callback");
}

void require_step(double step) {
  constexpr double least = 1e-18;  // [s] no run of less comes anywhere
  require_positive("scene", "step", step, "s");
  require(step >= least, "scene: step must be at least 1e-18 s, got ", step);
}

void require_integrator(Integrator integrator) {
  require(!name_of(integrator).empty(), "scene: there is no integrator ", static_cast<int>(integrator));
}

void check_settings(const Settings& settings) {
  require_step(settings.step);
  require_finite("scene", "gravity", settings.gravity, "m/s²");
  require_integrator(settings.integrator);
  require(static_cast<std::size_t>(settings.contact) < contact_search_names.size(),
          "scene: there is no contact search ", static_cast<int>(settings.contact));
  if (settings.accuracy) require_positive("scene", "accuracy", *settings.accuracy, "1/s");
  for (int i = 0; settings.box && i < 3; i++) require_positive("scene", "box", (*settings.box)[i], "m");
  require_positive("scene", "tolerance", settings.tolerance, "");
  require_positive("scene", "boltzmann", settings.boltzmann, "J/K");
}

void require_inertia(std::string_view call, const Mat3& inertia) {
  double most = 0.0, skew = 0.0;
  for (int i = 0; i < 3; i++) {
    require(finite(inertia[i]), call, ": inertia must be finite, got ", to_text(inertia[i]), " kg m² in column ",
            i + 1);
    most = std::fmax(most, largest(inertia[i]));
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < i; j++) skew = std::fmax(skew, std::fabs(inertia[i][j] - inertia[j][i]));
  require(skew <= 1e-9 * most, call, ": inertia must be symmetric, but two elements differ by ", skew, " kg m²");
  const Vec3 moments = principal_axes(inertia, identity33()).moments;
  require(moments[0] >= -1e-9 * most, call, ": inertia must not be negative about any axis; its principal moments are ",
          to_text(moments), " kg m²");
  require(moments[2] - moments[1] - moments[0] <= 1e-9 * most, call,
          ": no body has this inertia, as one principal moment is larger than the sum of the others: ",
          to_text(moments), " kg m²");
}

void require_kept(std::string_view call, const Constraint& c, double value) {
  const KeptNumber& kept = rule_of(c).keeps;
  if (kept.allows(value)) return;
  if (kept.range == KeptNumber::Range::positive) require_positive(call, kept.name, value, kept.unit);
  require_finite(call, c.by_speed ? "speed" : kept.name, value, c.by_speed ? "rad/s" : kept.unit);
  throw Error(text(call, ": ", kept.name, " must not be 0"));
}

Quat unit(std::string_view call, const Quat& q) {
  const double most = std::fmax(std::fmax(std::fabs(q.w), std::fabs(q.x)), std::fmax(std::fabs(q.y), std::fabs(q.z)));
  const bool numbers = std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
  require(numbers && most > 0.0, call, ": orientation must be a finite quaternion other than 0, got (", q.w, ", ", q.x,
          ", ", q.y, ", ", q.z, ")");
  return normalised({q.w / most, q.x / most, q.y / most, q.z / most});
}

}  // namespace pantin::internal
