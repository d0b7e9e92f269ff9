#pragma once
// Tables as HDF5: the group `table` with a dataset for each column, in their order.
#include <string>
#include <vector>

#include "player/columns.hpp"

namespace pantin::player {

inline constexpr const char* hdf5_ending = ".h5";

/// Whether this program was built with HDF5.
bool has_hdf5();
/// Throws UsageError where it was not.
void need_hdf5();
/// The bytes of a file. Doubles, compressed; a column of texts, of which all that are not empty are numbers, is one of numbers;
/// else texts in UTF-8. The attribute `unit` has the unit; `name` the name where that has a slash, which HDF5 does not allow.
/// Throws Error.
std::string hdf5_content(const std::vector<Column>& columns);
/// Reads such a file. Throws UsageError.
std::vector<Column> read_hdf5(const std::string& path);

}  // namespace pantin::player
