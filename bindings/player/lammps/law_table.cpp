#include "player/lammps/law_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "base/lanes.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_points = std::size_t{1} << 18;
/// Of a spline that is good where particles are: more would only mend where they never come.
constexpr std::size_t most_splined = std::size_t{1} << 15;
/// Energies of so many times the largest there are now nothing in the scene gives: there a table may begin or end. Straight
/// lines need far more points to get there.
constexpr double far_splined = 1e6, far_straight = 1e3;
/// Where a law does not vanish as particles meet, its table is less exact in the first few intervals, to this at most.
constexpr double most_inner = 0.05;

/// A table with what it is made from.
class TableMaker {
 public:
  TableMaker(LawOfDistance& law, const TableWish& wish) : law_(law), wish_(wish) {}

  LawTable make() {
    find_sizes();
    const double last = wish_.to > 0.0 ? wish_.to : 2.0 * farthest_;
    far_ = splines(law_.kinks(0.5 * nearest_, last)) ? far_splined : far_straight;
    double from = beginning();
    const double to = wish_.to > 0.0 ? wish_.to : end();
    make_between(from, to);
    require(not_finite_ < 0.7 * nearest_, law_.name(), ": it is no finite number at ", rounded(not_finite_), " m (",
            what_is_at(not_finite_), "), which is between the ends of its table, ", rounded(from), " and ", rounded(to),
            " m; make it finite there, or end it before by a cutoff");
    require(table_.good_from < 0.7 * nearest_, law_.name(), ": no table of ", table_.r.size(),
            " points follows it to an error of ", wish_.error, " from ", rounded(table_.from()), " to ",
            rounded(table_.to()), " m, down from ", rounded(table_.good_from),
            " m: it jumps, bends in more than one place, has something narrow, or changes too much over that range; "
            "ask for a larger --error, a shorter cutoff, or make it smooth",
            what_is_before(from));
    for (int attempt = 0; attempt < 8 && table_.inner_error > most_inner; attempt++) {
      from = std::sqrt(from * table_.good_from);
      make_between(from, to);
    }
    require(table_.inner_error <= most_inner, law_.name(), ": no table follows it to an error of ", wish_.error,
            "; ask for a larger --error");
    return std::move(table_);
  }

 private:
  LawOfDistance& law_;
  TableWish wish_;
  LawTable table_;
  double nearest_ = 0.0, farthest_ = 0.0;              // [m] now
  double largest_energy_ = 0.0, largest_force_ = 0.0;  // [J], [N] there
  double energy_size_ = 0.0, force_size_ = 0.0;        // [J], [N]
  double far_ = far_straight;
  double not_finite_ = 0.0;  // [m] the farthest at which it was not

  /// "NaN", "infinite" or empty.
  std::string what_is_at(double r) const {
    const LawOfDistance::Value v = law_.at(std::span(&r, 1))[0];
    if (std::isnan(v.energy) || std::isnan(v.force)) return "NaN";
    return std::isfinite(v.energy) && std::isfinite(v.force) ? "" : "infinite";
  }
  /// Of a law that ends where its table begins.
  std::string what_is_before(double from) const {
    const std::string what = what_is_at(0.99 * from);
    return what.empty() ? "" : text(". It is ", what, " at ", rounded(0.99 * from), " m, just before that range");
  }

  double over(double r) const { return wish_.over == TableOver::square ? r * r : r; }
  double distance(double s) const { return wish_.over == TableOver::square ? std::sqrt(s) : s; }

  /// How large the law is where particles are now, and what its errors are held against: that, or where it does nothing yet a
  /// part of what particles bring along.
  void find_sizes() {
    nearest_ = std::ranges::min(wish_.distances);
    farthest_ = std::ranges::max(wish_.distances);
    for (const double more : {1.0, 1.01}) {
      std::vector<double> r;
      for (double distance : wish_.distances) r.push_back(more * distance);
      double energy = 0.0, force = 0.0;
      const std::vector<LawOfDistance::Value> values = law_.at(r);
      for (std::size_t i = 0; i < r.size(); i++) {
        const LawOfDistance::Value& v = values[i];
        require(std::isfinite(v.energy) && std::isfinite(v.force), law_.name(), ": it is not a finite number (",
                what_is_at(r[i]), ") at ", r[i], " m, as far as particles are apart now, the nearest ", nearest_, " m");
        energy += std::abs(v.energy);
        force += std::abs(v.force);
        largest_energy_ = std::max(largest_energy_, std::abs(v.energy));
        largest_force_ = std::max(largest_force_, std::abs(v.force));
        table_.stiffness = std::max(table_.stiffness, -v.slope);
      }
      const auto count = static_cast<double>(r.size());
      table_.usual_energy = std::max(table_.usual_energy, energy / count);
      table_.usual_force = std::max(table_.usual_force, force / count);
    }
    energy_size_ = table_.usual_energy;
    force_size_ = table_.usual_force;
    if (law_.has_energy() && (wish_.idle || largest_energy_ == 0.0) && energy_size_ < 0.1 * wish_.idle_kinetic) {
      energy_size_ = table_.beside = 0.1 * wish_.idle_kinetic;
      force_size_ = std::max(force_size_, energy_size_ / nearest_);
    }
  }

  bool splines(const std::vector<double>& kinks) const { return kinks.empty() && !wish_.straight && law_.has_energy(); }

  bool is_far(double r) const {
    const LawOfDistance::Value v = law_.at(std::span(&r, 1))[0];
    if (!std::isfinite(v.energy) || !std::isfinite(v.force)) return true;
    if (!law_.has_energy()) return largest_force_ > 0.0 && std::abs(v.force) > 1e3 * far_ * largest_force_;
    const double energy = std::max(largest_energy_, wish_.kinetic);
    return energy > 0.0 && std::abs(v.energy) > far_ * energy;
  }

  /// Where a table may begin: nearer particles have energy that nothing in the scene has to give.
  double beginning() const {
    double r = nearest_;
    while (r > 0.01 * nearest_ && !is_far(r * 0.97)) r *= 0.97;
    const double almost_none = 1e-6 * nearest_;
    return r <= 0.01 * nearest_ && goes_down_to(almost_none, r) ? almost_none : r;
  }

  /// LAMMPS follows a bond's table from its beginning down to nothing, and ends a run for a pair that is nearer. That of pairs
  /// has force / distance.
  bool goes_down_to(double almost_none, double r) const {
    if (is_far(almost_none)) return false;
    if (wish_.over == TableOver::distance) return true;
    const double near = std::abs(law_.at(std::span(&almost_none, 1))[0].force) / almost_none;
    return near <= 2.0 * std::abs(law_.at(std::span(&r, 1))[0].force) / r;
  }

  /// The same of a bond's other end; or where its law jumps, as to nothing at a cutoff.
  double end() const {
    double r = farthest_;
    while (r < 8.0 * farthest_ && !is_far(r * 1.03)) r *= 1.03;
    r = std::min(r, wish_.most);
    for (const double kink : law_.kinks(farthest_, r))
      if (jumps_at(kink)) return kink;
    return r;
  }

  bool jumps_at(double r) const {
    const std::vector<LawOfDistance::Value> sides = law_.at(
        std::vector<double>{r * (1.0 - 2.0 * LawOfDistance::resolution), r * (1.0 + 2.0 * LawOfDistance::resolution)});
    return missing(sides[0].energy, sides[1].energy, energy_size_) > wish_.error ||
           missing(sides[0].force, sides[1].force, force_size_) > wish_.error;
  }

  void make_between(double from, double to) {
    const std::vector<double> kinks = law_.kinks(from, to);
    table_.spline = splines(kinks);
    const std::size_t enough = table_.spline ? std::min(wish_.enough, most_splined) : wish_.enough;
    for (std::size_t n = wish_.points;;) {
      sample(from, to, kinks, n);
      const auto done = [&] {
        return std::max(table_.error, table_.inner_error) <= wish_.error || n >= most_points ||
               (n >= enough && table_.good_from < 0.5 * nearest_);
      };
      if (done()) look_closely();
      if (done()) return;
      // The error goes with the second or fourth power of the spacing.
      const double finer = std::pow(std::min(std::max(table_.error, table_.inner_error) / wish_.error, 1e30),
                                    table_.spline ? 0.25 : 0.5);
      const std::size_t next = n * std::bit_floor(static_cast<std::size_t>(std::clamp(finer, 2.0, 1024.0)));
      n = std::min(n < enough ? std::min(next, enough) : next, most_points);
    }
  }

  /// n points, one of them where the law has a kink.
  void sample(double from, double to, const std::vector<double>& kinks, std::size_t n) {
    double low = over(from), high = over(to);
    const auto pieces = static_cast<double>(n - 1);
    if (!kinks.empty()) {
      const double kink = over(kinks.front());
      const double after = std::clamp(std::ceil((high - kink) / (high - low) * pieces), 1.0, pieces - 1.0);
      const double width = wish_.to > 0.0 ? (high - kink) / after : (high - low) / pieces;
      low = kink - (pieces - after) * width;
      high = kink + after * width;
    }
    std::vector<double> r;
    const double width = (high - low) / static_cast<double>(2 * n - 2);
    for (std::size_t i = 0; i < 2 * n - 1; i++) r.push_back(distance(low + width * static_cast<double>(i)));
    if (wish_.to > 0.0) r.back() = to;
    r.front() = distance(low);
    std::vector<double> within = r;
    within.back() = r.back() * (1.0 - 2.0 * LawOfDistance::resolution);  // at a cutoff the law is another
    std::vector<LawOfDistance::Value> values = law_.at(within);
    keep(r, values);
    for (std::size_t i = 0; i < r.size(); i++) note_finite(r[i], values[i]);
    energy_ = curve(values, r, &LawOfDistance::Value::energy);
    force_ = curve(values, r, &LawOfDistance::Value::force);
    table_.error = table_.inner_error = 0.0;
    table_.good_from = to;
    for (std::size_t i = n - 1; i-- > 0;) hold_against(static_cast<double>(i) + 0.5, r[2 * i + 1], values[2 * i + 1]);
  }

  /// Between the points and their middles, where something narrow may be.
  void look_closely() {
    constexpr std::size_t places = std::size_t{1} << 17;
    constexpr double golden = 0.6180339887498949;  // so that they are none of the table's own
    const double low = over(table_.from()), high = over(table_.to());
    const double pieces = static_cast<double>(table_.r.size() - 1);
    std::vector<double> r, at;
    for (std::size_t k = places; k-- > 0;) {
      const double part = (static_cast<double>(k) + golden) / static_cast<double>(places);
      r.push_back(table_.from() + part * (table_.to() * (1.0 - 2.0 * LawOfDistance::resolution) - table_.from()));
      at.push_back((over(r.back()) - low) / (high - low) * pieces);
    }
    const std::vector<LawOfDistance::Value> values = law_.at(r);
    for (std::size_t k = 0; k < places; k++) {
      note_finite(r[k], values[k]);
      hold_against(at[k], r[k], values[k]);
    }
  }

  void note_finite(double r, const LawOfDistance::Value& v) {
    if (!std::isfinite(v.energy) || !std::isfinite(v.force)) not_finite_ = std::max(not_finite_, r);
  }

  /// At a place counted in points; from the last to the first.
  void hold_against(double at, double r, const LawOfDistance::Value& v) {
    const double push = force_.at(at) * (wish_.over == TableOver::square ? r : 1.0);
    double missed = std::max(missing(energy_.at(at), v.energy, energy_size_), missing(push, v.force, force_size_));
    if (!std::isfinite(missed)) missed = infinity;
    const double begin = table_.r[static_cast<std::size_t>(at)];
    if (missed <= wish_.error && (table_.inner_error == 0.0 || r > table_.good_from)) {
      table_.error = std::max(table_.error, missed);
      if (table_.inner_error == 0.0) table_.good_from = std::min(table_.good_from, begin);
    } else if (missed > wish_.error) {
      if (table_.inner_error == 0.0 || r > table_.good_from)
        table_.good_from = table_.r[std::min(static_cast<std::size_t>(at) + 1, table_.r.size() - 1)];
      table_.inner_error = std::max(table_.inner_error, missed);
    } else {
      table_.inner_error = std::max(table_.inner_error, missed);
    }
  }

  static double missing(double told, double true_value, double size) {
    const double scale = std::max(std::abs(true_value), size);
    return scale == 0.0 ? std::abs(told - true_value) : std::abs(told - true_value) / scale;
  }

  /// Of every other one is kept; the rest is what the table is held against.
  void keep(const std::vector<double>& r, const std::vector<LawOfDistance::Value>& values) {
    table_.r.clear(), table_.energy.clear(), table_.force.clear();
    for (std::size_t i = 0; i < r.size(); i += 2) {
      table_.r.push_back(r[i]);
      table_.energy.push_back(values[i].energy);
      table_.force.push_back(values[i].force);
    }
    table_.slope_from = values.front().slope;
    table_.slope_to = values.back().slope;
  }

  /// What LAMMPS reads out of a column between its points.
  struct Curve {
    std::vector<double> y, bend;
    double width = 0.0;
    double at(double place) const {
      const std::size_t i = std::min(static_cast<std::size_t>(place), y.size() - 2);
      const double b = place - static_cast<double>(i), a = 1.0 - b;
      return a * y[i] + b * y[i + 1] +
             ((a * a * a - a) * bend[i] + (b * b * b - b) * bend[i + 1]) * width * width / 6.0;
    }
  };
  Curve energy_, force_;  // of pairs force / r

  Curve curve(const std::vector<LawOfDistance::Value>& values, const std::vector<double>& r,
              double LawOfDistance::Value::*which) const {
    const bool over_r = which == &LawOfDistance::Value::force && wish_.over == TableOver::square;
    const std::size_t n = table_.r.size();
    Curve made{{}, std::vector<double>(n, 0.0), (over(table_.to()) - over(table_.from())) / static_cast<double>(n - 1)};
    for (std::size_t i = 0; i < n; i++) made.y.push_back(values[2 * i].*which / (over_r ? table_.r[i] : 1.0));
    if (table_.spline)
      made.bend = bends(made.y, made.width, end_slope(values.front(), r.front(), which),
                        end_slope(values.back(), r.back(), which));
    return made;
  }

  /// Derivative by what the table is even over.
  double end_slope(const LawOfDistance::Value& v, double r, double LawOfDistance::Value::*which) const {
    const bool of_energy = which == &LawOfDistance::Value::energy;
    if (wish_.over == TableOver::distance) return of_energy ? -v.force : v.slope;
    return of_energy ? -v.force / (2.0 * r) : (v.slope / r - v.force / (r * r)) / (2.0 * r);
  }

  /// Second derivatives of the cubic spline with given slopes at its ends.
  static std::vector<double> bends(const std::vector<double>& y, double width, double first, double last) {
    const std::size_t n = y.size();
    std::vector<double> upper(n), bend(n);
    upper[0] = 0.5;
    bend[0] = 3.0 / width * ((y[1] - y[0]) / width - first);
    for (std::size_t i = 1; i + 1 < n; i++) {
      const double pivot = 2.0 - 0.5 * upper[i - 1];
      const double right = 3.0 * (y[i + 1] - 2.0 * y[i] + y[i - 1]) / (width * width);
      upper[i] = 0.5 / pivot;
      bend[i] = (right - 0.5 * bend[i - 1]) / pivot;
    }
    const double right = 3.0 / width * (last - (y[n - 1] - y[n - 2]) / width);
    bend[n - 1] = (right - 0.5 * bend[n - 2]) / (1.0 - 0.5 * upper[n - 2]);
    for (std::size_t i = n - 1; i-- > 0;) bend[i] -= upper[i] * bend[i + 1];
    return bend;
  }
};

}  // namespace

LawTable times(LawTable table, double factor) {
  for (auto* column : {&table.energy, &table.force})
    for (double& value : *column) value *= factor;
  for (double* value : {&table.slope_from, &table.slope_to}) *value *= factor;
  for (double* value : {&table.beside, &table.usual_energy, &table.usual_force, &table.stiffness})
    *value *= std::abs(factor);
  return table;
}

LawTable make_table(LawOfDistance& law, const TableWish& wish) { return TableMaker(law, wish).make(); }

}  // namespace pantin::player
