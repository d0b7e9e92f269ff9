#include "player/hdf5_table.hpp"

#include "scene/errors.hpp"

#ifdef PANTIN_HDF5
#include <hdf5.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#endif

namespace pantin::player {

void need_hdf5() {
  if (!has_hdf5())
    throw UsageError(
        "this program was built without HDF5, which .h5 needs. Type: apt-get install -y libhdf5-dev, and build it "
        "again "
        "from nothing; or write .csv");
}

#ifdef PANTIN_HDF5

namespace {

constexpr hsize_t chunk_rows = 65536;
constexpr unsigned compression = 1;
constexpr std::size_t grows_by = std::size_t{1} << 20;  // [bytes] of the file in memory
const char* const group_name = "table";

/// What HDF5 gave, closed in the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
    require(id >= 0, "HDF5: ", what, " cannot be made or read");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void check(herr_t result, const char* what) { require(result >= 0, "HDF5: ", what); }

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  check(H5Tset_size(type, H5T_VARIABLE), "no texts");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "no UTF-8");
  return type;
}

/// One that no column before it has, and that HDF5 takes.
std::string link_name(std::string name, std::size_t column, std::set<std::string>& taken) {
  for (std::size_t at; (at = name.find('/')) != std::string::npos;) name.replace(at, 1, "∕");
  if (name.empty() || name == ".") name = "column " + std::to_string(column + 1);
  while (!taken.insert(name).second) name += " again";
  return name;
}

void write_attribute(hid_t data, const char* name, const std::string& value) {
  const Handle type(text_type(), H5Tclose, "a type"), space(H5Screate(H5S_SCALAR), H5Sclose, "a space");
  const Handle attribute(H5Acreate2(data, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "an attribute");
  const char* const text = value.c_str();
  check(H5Awrite(attribute, type, &text), "an attribute cannot be written");
}

std::string read_attribute(hid_t data, const char* name) {
  if (H5Aexists(data, name) <= 0) return "";
  const Handle type(text_type(), H5Tclose, "a type");
  const Handle attribute(H5Aopen(data, name, H5P_DEFAULT), H5Aclose, "an attribute");
  char* text = nullptr;
  check(H5Aread(attribute, type, &text), "an attribute cannot be read");
  const std::string value = text ? text : "";
  H5free_memory(text);
  return value;
}

/// Without times of its making, so that the same table has the same bytes.
hid_t data_options(std::size_t rows, bool compressed) {
  const hid_t options = H5Pcreate(H5P_DATASET_CREATE);
  check(H5Pset_obj_track_times(options, false), "no options");
  if (!compressed || rows == 0) return options;
  const hsize_t chunk = std::min<hsize_t>(rows, chunk_rows);
  check(H5Pset_chunk(options, 1, &chunk), "no chunks");
  check(H5Pset_shuffle(options), "no shuffling");
  check(H5Pset_deflate(options, compression), "no compression");
  return options;
}

/// Where all cells are numbers or empty.
std::optional<std::vector<double>> as_numbers(const Column& column) {
  if (column.text_alone) return {};
  const auto& texts = std::get<std::vector<std::string>>(column.cells);
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    double number = std::numeric_limits<double>::quiet_NaN();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && !std::isnan(number);
    if (!text.empty() && !whole) return {};
    numbers.push_back(number);
  }
  return numbers;
}

void write_data(hid_t group, const Column& column, const std::string& link, hid_t type, const void* data,
                std::size_t rows, bool compressed) {
  const hsize_t size = rows;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "a space");
  const Handle options(data_options(rows, compressed), H5Pclose, "options");
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "options");
  check(H5Pset_char_encoding(links, H5T_CSET_UTF8), "no UTF-8");
  const Handle set(H5Dcreate2(group, link.c_str(), type, space, links, options, H5P_DEFAULT), H5Dclose, "a dataset");
  if (rows > 0) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "a column cannot be written");
  if (link != column.name) write_attribute(set, "name", column.name);
  if (!column.unit.empty()) write_attribute(set, "unit", column.unit);
}

void write_column(hid_t group, const Column& column, const std::string& link) {
  const auto* texts = std::get_if<std::vector<std::string>>(&column.cells);
  const auto found = texts ? as_numbers(column) : std::nullopt;
  if (!texts || found) {
    const std::vector<double>& numbers = found ? *found : std::get<std::vector<double>>(column.cells);
    return write_data(group, column, link, H5T_IEEE_F64LE, numbers.data(), numbers.size(), true);
  }
  std::vector<const char*> pointers;
  for (const std::string& text : *texts) pointers.push_back(text.c_str());
  const Handle type(text_type(), H5Tclose, "a type");
  write_data(group, column, link, type, pointers.data(), pointers.size(), false);
}

Column read_column(hid_t group, hsize_t number) {
  char link[1024] = "";
  require(H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, number, link, sizeof link, H5P_DEFAULT) >= 0,
          "HDF5: the columns have no order");
  const Handle set(H5Dopen2(group, link, H5P_DEFAULT), H5Dclose, "a column");
  const Handle space(H5Dget_space(set), H5Sclose, "a space"), kind(H5Dget_type(set), H5Tclose, "a type");
  const auto rows = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  Column column{read_attribute(set, "name"), read_attribute(set, "unit"), std::vector<double>(rows), false};
  if (column.name.empty()) column.name = link;
  if (H5Tget_class(kind) != H5T_STRING) {
    auto& numbers = std::get<std::vector<double>>(column.cells);
    check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), "a column cannot be read");
    return column;
  }
  const Handle type(text_type(), H5Tclose, "a type");
  std::vector<char*> pointers(rows);
  check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), "a column cannot be read");
  std::vector<std::string> texts;
  for (const char* text : pointers) texts.emplace_back(text ? text : "");
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  column.cells = std::move(texts);
  return column;
}

}  // namespace

bool has_hdf5() { return true; }

std::string hdf5_content(const std::vector<Column>& columns) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "options");
  check(H5Pset_fapl_core(access, grows_by, false), "no file in memory");
  const Handle file(H5Fcreate("table.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "a file in memory");
  const Handle options(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "options");
  check(H5Pset_link_creation_order(options, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "no order");
  check(H5Pset_obj_track_times(options, false), "no options");
  {
    const Handle group(H5Gcreate2(file, group_name, H5P_DEFAULT, options, H5P_DEFAULT), H5Gclose, "a group");
    std::set<std::string> taken;
    for (std::size_t i = 0; i < columns.size(); i++)
      write_column(group, columns[i], link_name(columns[i].name, i, taken));
  }
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "a file cannot be finished");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "HDF5: a file cannot be finished");
  std::string content(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, content.data(), content.size()) == size, "HDF5: a file cannot be finished");
  return content;
}

std::vector<Column> read_hdf5(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  try {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    const Handle group(H5Gopen2(file, group_name, H5P_DEFAULT), H5Gclose, "the group 'table'");
    H5G_info_t info{};
    check(H5Gget_info(group, &info), "the group 'table' cannot be read");
    std::vector<Column> columns;
    for (hsize_t i = 0; i < info.nlinks; i++) columns.push_back(read_column(group, i));
    return columns;
  } catch (const Error& error) { throw UsageError(text(path, " is no table as Pantin writes it: ", error.what())); }
}

#else

bool has_hdf5() { return false; }

std::string hdf5_content(const std::vector<Column>&) {
  need_hdf5();
  return "";
}
std::vector<Column> read_hdf5(const std::string&) {
  need_hdf5();
  return {};
}

#endif

}  // namespace pantin::player
