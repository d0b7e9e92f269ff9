#include "player/plot_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>

#include "player/csv.hpp"
#include "player/hdf5_table.hpp"
#include "player/heat_map.hpp"
#include "player/message.hpp"
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
    const auto column = static_cast<std::size_t>(error - names_.begin());
    const auto bad =
        std::stable_partition(rows_.begin(), rows_.end(), [&](const auto& row) { return row[column].empty(); });
    failed_.assign(std::make_move_iterator(bad), std::make_move_iterator(rows_.end()));
    rows_.erase(bad, rows_.end());
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
  /// Those.
  const std::vector<std::vector<std::string>>& failed() const { return failed_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_, failed_;
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
  std::size_t count = 0;
  void add(double x) {
    sum += x;
    count++;
  }
  double value() const { return sum / static_cast<double>(count); }  ///< NaN: of none
};

[[noreturn]] void refuse_without_numbers() { throw UsageError("no row has numbers in all of these columns"); }

bool is_log(const PlotOptions& options, const std::string& column) {
  return std::ranges::find(options.log, column) != options.log.end();
}

/// What is not drawn of the rows that tell no error.
struct LeftOut {
  std::size_t rows = 0;
  std::size_t hatched = 0;  ///< of a heat map, with those that tell an error
};

struct DrawnLine {
  std::string value;  ///< of the column `by`
  std::map<double, Mean> means;
};

/// Those of numbers in rising order, others after them in the order of the table.
std::vector<DrawnLine> lines_of(const PlotOptions& options, const NamedTable& table, LeftOut& left_out) {
  const std::size_t x = table.column(options.x), y = table.column(options.y);
  const std::size_t by = options.by.empty() ? x : table.column(options.by);
  std::map<std::string, std::size_t> places;
  std::vector<DrawnLine> lines;
  for (const auto& row : table.rows()) {
    const auto px = number_in(row[x], is_log(options, options.x)), py = number_in(row[y], is_log(options, options.y));
    if (!px || !py) {
      left_out.rows++;
      continue;
    }
    const std::string value = options.by.empty() ? "" : row[by];
    const auto [place, is_new] = places.try_emplace(value, lines.size());
    if (is_new) lines.push_back({value, {}});
    lines[place->second].means[*px].add(*py);
  }
  std::ranges::stable_sort(lines, {}, [](const DrawnLine& line) {
    const auto number = number_in(line.value, false);
    return std::pair(!number, number.value_or(0.0));
  });
  return lines;
}

/// More lines than a legend can tell apart, by their colours.
void use_bar(const PlotOptions& options, Plot& plot, std::vector<DrawnLine>& lines, LeftOut& left_out) {
  plot.bar_name = options.by;
  plot.logarithmic_bar = is_log(options, options.by);
  const std::size_t count = lines.size();
  std::erase_if(lines, [&](const DrawnLine& line) {
    if (number_in(line.value, plot.logarithmic_bar)) return false;
    if (!line.value.empty() && !number_in(line.value, false))
      throw UsageError(text("--by ", options.by, ": ", count, " different values, '", line.value, "' among them, and ",
                            most_in_legend(plot.joined),
                            " can be told apart: take a column with fewer, or with numbers"));
    for (const auto& [at, mean] : line.means) left_out.rows += mean.count;
    return true;
  });
}

std::string draw_lines(const PlotOptions& options, const NamedTable& table, LeftOut& left_out) {
  Plot plot{options.title, options.x, options.y, {}};
  plot.linear_x = !is_log(options, options.x);
  plot.linear_y = !is_log(options, options.y);
  plot.joined = !options.points;
  std::vector<DrawnLine> lines = lines_of(options, table, left_out);
  if (lines.size() > most_in_legend(plot.joined))
    use_bar(options, plot, lines, left_out);
  else if (!options.by.empty() && options.by != options.x && options.by != options.y && is_log(options, options.by))
    throw UsageError(text("--log ", options.by, ": so few lines have a legend, and no scale of colours"));
  std::map<std::string, int> short_names;
  for (const DrawnLine& line : lines) short_names[short_number(line.value)]++;
  for (const auto& [value, means] : lines) {
    const std::string few = short_number(value);
    Series series{options.by.empty() ? "" : options.by + " = " + (short_names[few] > 1 ? value : few), {}};
    series.number = number_in(value, false).value_or(0.0);
    for (const auto& [at, mean] : means) series.points.emplace_back(at, mean.value());
    plot.series.push_back(std::move(series));
  }
  if (plot.series.empty()) refuse_without_numbers();
  return draw_plots({plot}, 1);
}

std::string draw_map(const PlotOptions& options, const NamedTable& table, LeftOut& left_out) {
  const std::size_t x = table.column(options.x), y = table.column(options.y), color = table.column(options.color);
  HeatMap map{options.title, options.x, options.y, options.color, {}};
  map.logarithmic_x = is_log(options, options.x);
  map.logarithmic_y = is_log(options, options.y);
  map.logarithmic_value = is_log(options, options.color);
  std::map<std::pair<double, double>, Mean> means;
  const auto place_of = [&](const std::vector<std::string>& row) -> Mean* {
    const auto px = number_in(row[x], map.logarithmic_x), py = number_in(row[y], map.logarithmic_y);
    return px && py ? &means[{*px, *py}] : nullptr;
  };
  for (const auto& row : table.rows()) {
    const auto value = number_in(row[color], map.logarithmic_value);
    Mean* const place = place_of(row);
    if (place && value)
      place->add(*value);
    else
      (place ? left_out.hatched : left_out.rows)++;
  }
  for (const auto& row : table.failed()) left_out.hatched += place_of(row) ? 1u : 0u;
  bool has_one = false;
  for (const auto& [at, mean] : means) {
    map.values.push_back({at.first, at.second, mean.value()});
    has_one = has_one || mean.count > 0;
  }
  if (!has_one) refuse_without_numbers();
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
    if (name != options.x && name != options.y && name != options.color && name != options.by)
      throw UsageError(text("--log ", name, ": that is no axis of this picture"));
  }
  keep_apart(options.out, options.table);
  Output file(options.out);
  LeftOut left_out;
  file.write(options.color.empty() ? draw_lines(told, table, left_out) : draw_map(told, table, left_out));
  file.keep();
  const std::size_t rows = table.rows().size(), failed = table.failed().size();
  if (left_out.hatched > 0)
    std::printf("%zu of %zu rows have no number '%s', or tell an error: a place where none has one is hatched\n",
                left_out.hatched, rows + failed, options.color.c_str());
  else if (failed > 0)
    std::printf("%s left out\n", amount(failed, "row tells an error and is", "rows tell an error and are").c_str());
  if (left_out.rows > 0) std::printf("%zu of %zu rows have no such numbers and are left out\n", left_out.rows, rows);
  return 0;
}

}  // namespace pantin::player
