#include "player/columns.hpp"

#include <cmath>

#include "player/csv.hpp"
#include "player/hdf5_table.hpp"

namespace pantin::player {
namespace {

std::size_t rows_of(const Column& column) {
  return std::visit([](const auto& cells) { return cells.size(); }, column.cells);
}

std::string cell_text(const Column& column, std::size_t row) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.cells)) return csv_cell((*texts)[row]);
  const double number = std::get<std::vector<double>>(column.cells)[row];
  return std::isnan(number) ? "" : number_text(number);
}

}  // namespace

std::string csv_text(const std::vector<Column>& columns) {
  std::string out;
  for (const Column& column : columns) out += (&column == columns.data() ? "" : ",") + csv_cell(column.name);
  out += "\n";
  for (std::size_t row = 0; row < rows_of(columns.front()); row++) {
    for (const Column& column : columns) {
      if (&column != columns.data()) out += ',';
      out += cell_text(column, row);
    }
    out += '\n';
  }
  return out;
}

std::string table_content(const std::string& path, const std::vector<Column>& columns) {
  return path.ends_with(hdf5_ending) ? hdf5_content(columns) : csv_text(columns);
}

}  // namespace pantin::player
