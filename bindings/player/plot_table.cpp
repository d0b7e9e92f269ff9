#include "player/plot_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include "player/csv.hpp"
#include "player/hdf5_table.hpp"
#include "player/heat_map.hpp"
#include "player/output.hpp"
#include "player/plot.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

constexpr double largest_drawn = 1e300;  ///< so that what lies between two numbers is one

/// The names first.
std::vector<std::vector<std::string>> rows_in(const std::string& path) {
  const auto content = path.ends_with(hdf5_ending) ? csv_text(read_hdf5(path)) : file_content(path);
  if (!content) throw UsageError(text("cannot read ", path));
  return read_csv(*content);
}

/// A table whose columns have names.
class NamedTable {
 public:
  explicit NamedTable(const std::string& path) : path_(path) {
    rows_ = rows_in(path);
    if (rows_.size() < 2) throw UsageError(text(path, " has no rows"));
    names_ = rows_.front();
    rows_.erase(rows_.begin());
    if (names_[0].starts_with("\xef\xbb\xbf")) names_[0].erase(0, 3);  // as some programs begin a text
    for (std::size_t i = 0; i < rows_.size(); i++)
      if (rows_[i].size() != names_.size())
        throw UsageError(
            text(path, ": row ", i + 2, " has ", rows_[i].size(), " cells, the first row ", names_.size()));
    const auto error = std::ranges::find(names_, "error");
    if (error == names_.end()) return;
    const std::size_t before = rows_.size();
    std::erase_if(rows_,
                  [&](const auto& row) { return !row[static_cast<std::size_t>(error - names_.begin())].empty(); });
    failed_ = before - rows_.size();
  }

  std::size_t column(const std::string& name) const {
    const auto found = std::ranges::find(names_, name);
    if (std::ranges::count(names_, name) > 1) throw UsageError(text(path_, " has more than one column '", name, "'"));
    if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    std::string all;
    for (const std::string& other : names_) all += (all.empty() ? "" : ", ") + other;
    throw UsageError(text(path_, " has no column '", name, "'. It has ", all));
  }
  /// But for those that tell an error.
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }
  std::size_t failed() const { return failed_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t failed_ = 0;
};

std::optional<double> number_in(const std::string& cell, bool logarithmic) {
  double x = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
  if (error != std::errc{} || end != cell.data() + cell.size() || !(std::fabs(x) <= largest_drawn)) return {};
  if (logarithmic && x <= 0.0) return {};
  return x;
}

/// A number with four digits; another text as it is.
std::string short_number(const std::string& cell) {
  const auto number = number_in(cell, false);
  if (!number) return cell;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g", *number);
  return digits;
}

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double x) {
    sum += x;
    count++;
  }
  double value() const { return sum / count; }
};

[[noreturn]] void refuse_without_numbers() { throw UsageError("no row has numbers in all of these columns"); }

bool is_log(const PlotOptions& options, const std::string& column) {
  return std::ranges::find(options.log, column) != options.log.end();
}

std::string draw_lines(const PlotOptions& options, const NamedTable& table, std::size_t& left_out) {
  const std::size_t x = table.column(options.x), y = table.column(options.y);
  const std::size_t by = options.by.empty() ? x : table.column(options.by);
  Plot plot{options.title, options.x, options.y, {}};
  plot.linear_x = !is_log(options, options.x);
  plot.linear_y = !is_log(options, options.y);
  plot.joined = !options.points;
  std::vector<std::pair<std::string, std::map<double, Mean>>> lines;  // in the order of the table
  for (const auto& row : table.rows()) {
    const auto px = number_in(row[x], !plot.linear_x), py = number_in(row[y], !plot.linear_y);
    if (!px || !py) {
      left_out++;
      continue;
    }
    const std::string value = options.by.empty() ? "" : row[by];
    auto line = std::ranges::find(lines, value, [](const auto& l) { return l.first; });
    if (line == lines.end()) line = lines.insert(lines.end(), {value, {}});
    line->second[*px].add(*py);
  }
  std::map<std::string, int> short_names;
  for (const auto& line : lines) short_names[short_number(line.first)]++;
  for (const auto& [value, means] : lines) {
    const std::string few = short_number(value);
    Series series{options.by.empty() ? "" : options.by + " = " + (short_names[few] > 1 ? value : few), {}};
    for (const auto& [at, mean] : means) series.points.emplace_back(at, mean.value());
    plot.series.push_back(std::move(series));
  }
  if (plot.series.empty()) refuse_without_numbers();
  return draw_plots({plot}, 1);
}

std::string draw_map(const PlotOptions& options, const NamedTable& table, std::size_t& left_out) {
  const std::size_t x = table.column(options.x), y = table.column(options.y), color = table.column(options.color);
  HeatMap map{options.title, options.x, options.y, options.color, {}};
  map.logarithmic_x = is_log(options, options.x);
  map.logarithmic_y = is_log(options, options.y);
  map.logarithmic_value = is_log(options, options.color);
  std::map<std::pair<double, double>, Mean> means;
  for (const auto& row : table.rows()) {
    const auto px = number_in(row[x], map.logarithmic_x), py = number_in(row[y], map.logarithmic_y);
    const auto value = number_in(row[color], map.logarithmic_value);
    if (px && py && value)
      means[{*px, *py}].add(*value);
    else
      left_out++;
  }
  for (const auto& [at, mean] : means) map.values.push_back({at.first, at.second, mean.value()});
  if (map.values.empty()) refuse_without_numbers();
  return draw_heat_map(map);
}

}  // namespace

int plot_table(const PlotOptions& options) {
  const NamedTable table(options.table);
  PlotOptions told = options;
  if (told.title.empty()) told.title = std::filesystem::path(options.table).stem();
  if (!options.by.empty() && !options.color.empty())
    throw UsageError("--by is of lines, --color of a heat map: give one of them");
  if (options.points && !options.color.empty())
    throw UsageError("--points is of lines, --color of a heat map: give one of them");
  for (const std::string& name : options.log) {
    table.column(name);
    if (name != options.x && name != options.y && name != options.color)
      throw UsageError(text("--log ", name, ": that is no axis of this picture"));
  }
  Output file(options.out);
  std::size_t left_out = 0;
  file.write(options.color.empty() ? draw_lines(told, table, left_out) : draw_map(told, table, left_out));
  file.keep();
  if (table.failed() > 0) std::printf("%zu rows tell an error and are left out\n", table.failed());
  if (left_out > 0)
    std::printf("%zu of %zu rows have no such numbers and are left out\n", left_out, table.rows().size());
  return 0;
}

}  // namespace pantin::player
