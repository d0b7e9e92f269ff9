#include "player/sweep/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "player/csv.hpp"
#include "player/json.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

const std::string finished = "finished";

std::string checked(const std::string& content) { return hash_text(content) + " " + content + "\n"; }

Json json_of_cells(const Cells& cells) {
  Json list = Json::array();
  for (const auto& [name, value] : cells) list.push_back({name, value});
  return list;
}

Cells cells_of(const Json& list) {
  Cells cells;
  for (const Json& cell : list) cells.emplace_back(cell.at(0).get<std::string>(), cell.at(1).get<std::string>());
  return cells;
}

}  // namespace

std::string text_of(const CaseOrder& order) {
  std::string all = std::to_string(order.number);
  for (const auto& [name, value] : order.set) all += '\0' + name + '\0' + value;
  return all;
}

CaseOrder order_of(const std::string& text) {
  std::istringstream in(text);
  CaseOrder order;
  std::string part;
  std::getline(in, part, '\0');
  order.number = std::stoull(part);
  for (std::string name, value; std::getline(in, name, '\0');) {
    if (!std::getline(in, value, '\0')) value.clear();
    order.set.emplace_back(name, value);
  }
  return order;
}

std::string line_of(const CaseRow& row) {
  const Json json = {{"case", row.number},
                     {"told", json_of_cells(row.told)},
                     {"measured", json_of_cells(row.measured)},
                     {"files", json_of_cells(row.files)}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

CaseRow row_of(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {json.at("case").get<std::uint64_t>(), cells_of(json.at("told")), cells_of(json.at("measured")),
            cells_of(json.at("files"))};
  } catch (const Json::exception& error) { throw Error(text("that is no row of a sweep: ", error.what())); }
}

Journal::Journal(std::string path, const std::string& sweep, bool retry) : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | (retry ? 0 : O_CREAT), 0666);
  if (file_ < 0 && errno == ENOENT && retry)
    throw UsageError(
        text("there is nothing to run again: ", path_,
             ", which stays where cases fail, is not there. Without --retry-failed the sweep begins anew"));
  if (file_ < 0) throw UsageError(text("cannot write ", path_, ": ", std::strerror(errno)));
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw UsageError(text("another sweep is writing ", path_, "; give this one a table of its own with --out"));
    read(sweep, retry);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() { ::close(file_); }

void Journal::read(const std::string& sweep, bool retry) {
  std::string content = file_content(path_).value_or("");
  if (!retry && content.ends_with(checked(finished))) {
    content.clear();
    cut_off_at(0);
  }
  std::size_t from = 0, line = 0;
  for (std::size_t end; (end = content.find('\n', from)) != std::string::npos; from = end + 1) {
    const std::string text_ = content.substr(from, end - from);
    line++;
    const auto refuse = [&](const char* why) {
      throw UsageError(
          text(path_, ":", line, ": ", why, "; delete the file to begin the sweep anew, or give another --out"));
    };
    if (text_.size() < 17 || hash_text(text_.substr(17)) != text_.substr(0, 16)) refuse("this line was changed");
    if (line == 1 && text_.substr(17) != sweep && retry)
      throw UsageError(text(path_,
                            ": what failed there is of another sweep, or its scene was changed since; without "
                            "--retry-failed all cases are run anew"));
    if (line == 1 && text_.substr(17) != sweep)
      refuse("what is begun here is another sweep, or its scene was changed since");
    if (line > 1 && text_.substr(17) != finished) read_row(text_.substr(17));
  }
  if (from < content.size()) cut_off_at(from);
  if (line == 0) write_line(sweep);
  if (retry) std::erase_if(rows_, [](const auto& row) { return failed(row.second); });
}

void Journal::read_row(const std::string& line) {
  CaseRow row = row_of(line);
  files_.insert(files_.end(), row.files.begin(), row.files.end());
  rows_[row.number] = std::move(row);
}

void Journal::cut_off_at(std::size_t size) {
  if (ftruncate(file_, static_cast<off_t>(size)) != 0)
    throw UsageError(text("cannot write ", path_, ": ", std::strerror(errno)));
}

void Journal::write_line(const std::string& content) {
  const std::string line = checked(content);
  const ssize_t written = write(file_, line.data(), line.size());
  require(written == static_cast<ssize_t>(line.size()), "cannot write ", path_, ": ",
          written < 0 ? std::strerror(errno) : "there is no space left");
}

void Journal::add(CaseRow row) {
  write_line(line_of(row));
  rows_[row.number] = std::move(row);
}

void Journal::remove() { unlink(path_.c_str()); }

void Journal::finish() { write_line(finished); }

}  // namespace pantin::player
