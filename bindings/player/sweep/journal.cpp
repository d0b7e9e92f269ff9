#include "player/sweep/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "player/csv.hpp"
#include "player/json.hpp"
#include "player/message.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

const std::string finished = "finished", table_is = "table ";

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

std::string line_of(const CaseRow& row) {
  const Json json = {{"case", row.number},
                     {"told", json_of_cells(row.told)},
                     {"probes", json_of_cells(row.probes)},
                     {"measured", json_of_cells(row.measured)},
                     {"files", json_of_cells(row.files)}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

CaseRow row_of(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {json.at("case").get<std::uint64_t>(), cells_of(json.at("told")), cells_of(json.at("measured")),
            cells_of(json.at("files")), cells_of(json.value("probes", Json::array()))};
  } catch (const Json::exception& error) { throw Error(text("that is no row of a sweep: ", error.what())); }
}

Journal::Journal(std::string table, const std::string& sweep, JournalWish wish)
    : table_(std::move(table)), path_(table_ + ".journal"), wish_(wish) {
  open();
  try {
    begin(sweep);
  } catch (...) {
    struct stat now {};
    if (fstat(file_, &now) == 0 && now.st_size == 0) remove();
    ::close(file_);
    throw;
  }
}

Journal::~Journal() { ::close(file_); }

/// Locked, and still the file of that name: a sweep that is refused takes it away.
void Journal::open() {
  while (true) {
    file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | (wish_.retry ? 0 : O_CREAT), 0666);
    if (file_ < 0 && errno == ENOENT && wish_.retry)
      throw UsageError(text("there is nothing to run again: ", path_,
                            ", which a sweep leaves, is not there. Without --retry-failed all cases are run"));
    if (file_ < 0) throw UsageError(text("cannot write ", path_, ": ", std::strerror(errno)));
    const int failed = flock(file_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    struct stat locked {
    }, named{};
    const bool is_it = fstat(file_, &locked) == 0 && stat(path_.c_str(), &named) == 0 &&
                       locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
    if (failed == 0 && is_it) return;
    if (failed != 0 && failed != EWOULDBLOCK) {
      say(text(path_, ": this disk has no locks (", std::strerror(failed),
               "), so see to it that no other sweep writes ", table_));
      return;
    }
    ::close(file_);
    if (failed != 0)
      throw UsageError(text("another sweep is writing ", path_,
                            ": if it is this one, whose processes are still ending, wait until "
                            "they have, some seconds, and start it again; else give this one a table of its own with "
                            "--out"));
  }
}

void Journal::begin(const std::string& sweep) {
  std::string content = file_content(path_).value_or("");
  finished_ = content.ends_with(checked(finished));
  if (finished_ && wish_.overwrite && !wish_.retry) {
    finished_ = false;
    content.clear();
    cut_off_at(0);
  }
  read(content, sweep);
  check_table();
  if (content.find('\n') == std::string::npos) write_line(sweep);
  if (wish_.retry && std::erase_if(rows_, [](const auto& row) { return failed(row.second); }) > 0) finished_ = false;
}

void Journal::read(const std::string& content, const std::string& sweep) {
  std::size_t from = 0, line = 0;
  for (std::size_t end; (end = content.find('\n', from)) != std::string::npos; from = end + 1) {
    const std::string text_ = content.substr(from, end - from);
    line++;
    const auto refuse = [&](const char* why) {
      throw UsageError(
          text(path_, ", line ", line, ": ", why, "; delete the file to begin the sweep anew, or give another --out"));
    };
    if (text_.size() < 17 || hash_text(text_.substr(17)) != text_.substr(0, 16)) refuse("this line was changed");
    if (line == 1 && text_.substr(17) != sweep && wish_.retry)
      throw UsageError(text(path_,
                            ": what failed there is of another sweep, or its scene was changed since; with "
                            "--overwrite in place of --retry-failed all cases are run anew"));
    if (line == 1 && text_.substr(17) != sweep && finished_)
      throw UsageError(text(path_,
                            " is of another sweep, or its scene was changed since: give another --out, or lose it and "
                            "its table with --overwrite"));
    if (line == 1 && text_.substr(17) != sweep)
      refuse("what is begun here is another sweep, or its scene was changed since");
    if (line > 1) read_line(text_.substr(17));
  }
  if (from < content.size()) cut_off_at(from);
}

void Journal::read_line(const std::string& line) {
  if (line == finished) return;
  if (line.starts_with(table_is)) {
    tables_.insert(line.substr(table_is.size()));
    return;
  }
  CaseRow row = row_of(line);
  files_.insert(files_.end(), row.files.begin(), row.files.end());
  rows_[row.number] = std::move(row);
}

void Journal::check_table() const {
  if (wish_.overwrite) return;
  const auto there = file_content(table_);
  if (!there || tables_.contains(hash_text(*there)) || (there->empty() && tables_.empty())) return;
  const char* const kept = "move it away and start again, what is done is kept; or lose it with --overwrite";
  if (!tables_.empty()) throw UsageError(text(table_, " was changed since this sweep wrote it: ", kept));
  throw UsageError(text(table_, " is there already",
                        rows_.empty() ? ": give another --out, or lose it with --overwrite"
                                      : text(", and this sweep did not write it: ", kept)));
}

void Journal::cut_off_at(std::size_t size) {
  if (ftruncate(file_, static_cast<off_t>(size)) != 0)
    throw UsageError(text("cannot write ", path_, ": ", std::strerror(errno)));
}

void Journal::write_line(const std::string& content) {
  const std::string line = checked(content);
  const ssize_t written = write(file_, line.data(), line.size());
  require(written == static_cast<ssize_t>(line.size()), "cannot write ", path_, ": ",
          written < 0 ? std::strerror(errno) : "there is no space left",
          "; once it can be the same command goes on with the rest");
}

void Journal::add(CaseRow row) {
  write_line(line_of(row));
  rows_[row.number] = std::move(row);
}

void Journal::remove() { unlink(path_.c_str()); }

void Journal::finish(const std::function<void()>& keep_table, const std::string& content) {
  const std::string hash = hash_text(content);
  write_line(table_is + hash);
  tables_.insert(hash);
  keep_table();
  write_line(finished);
  finished_ = true;
}

}  // namespace pantin::player
