#include "player/sweep/course.hpp"

#include <algorithm>

#include "player/csv.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {

std::uint64_t failures(const Rows& rows) {
  return static_cast<std::uint64_t>(std::ranges::count_if(rows, [](const auto& row) { return failed(row.second); }));
}

void CaseProgress::show(std::uint64_t done, std::uint64_t failed) {
  const double part = static_cast<double>(done) / static_cast<double>(all_);
  if (done <= before_ || !line_.is_due(part)) return;
  const double of_these = static_cast<double>(done - before_) / static_cast<double>(all_ - before_);
  line_.show(part, text(done, " of ", all_, " cases, ", failed, " failed, ", line_.time_left(of_these)));
}

Course::Course(const Cases& cases, Journal& journal, Best* best, int hands)
    : cases_(cases),
      journal_(journal),
      best_(best),
      hands_(static_cast<std::uint64_t>(hands)),
      progress_(journal.rows().size(), cases.count()),
      bad_(failures(journal.rows())) {
  for (const auto& [path, hash] : journal.files()) {
    note_file(path, hash);
    kept_.insert(path);
  }
  for (const auto& [path, hash] : files_)
    if (hash_text(file_content(path).value_or("")) != hash)
      throw UsageError(
          text(path, " was changed since the sweep was begun: put it back as it was, or delete the journal"));
}

std::optional<std::uint64_t> Course::next_number() {
  if (best_) return best_->next(journal_.rows());
  while (next_ < cases_.count() && journal_.rows().contains(next_)) next_++;
  if (next_ == cases_.count()) return {};
  return next_++;
}

std::optional<CaseOrder> Course::next_order() {
  if (!left_.empty()) {
    CaseOrder order = std::move(left_.front());
    left_.pop_front();
    return order;
  }
  const auto number = next_number();
  if (!number) return {};
  return CaseOrder{*number, cases_.settings(*number)};
}

/// So many that none waits long for another at the end; a search asks for what it knows.
std::size_t Course::bundle_size() const {
  if (best_) return 1;
  const auto in_time = static_cast<std::uint64_t>(bundle_time / std::max(case_time_, 0.001 * bundle_time));
  const std::uint64_t share = (cases_.count() - next_ + left_.size()) / (4 * hands_);
  return std::max<std::uint64_t>(1, std::min(in_time, share));
}

std::optional<std::string> Course::next() {
  Bundle bundle;
  if (!suspects_.empty()) {
    bundle.push_back(std::move(suspects_.front()));
    suspects_.pop_front();
    return text_of(bundle);
  }
  for (std::size_t left = bundle_size(); left > 0; left--) {
    auto order = next_order();
    if (!order) break;
    bundle.push_back(std::move(*order));
  }
  if (bundle.empty()) return {};
  return text_of(bundle);
}

void Course::keep(const std::string& text) {
  BundleResult result = result_of(text);
  std::deque<CaseOrder>& again = result.rows.empty() ? suspects_ : left_;
  again.insert(again.end(), result.left.begin(), result.left.end());
  if (!result.rows.empty()) case_time_ = result.seconds / static_cast<double>(result.rows.size());
  for (CaseRow& row : result.rows) keep(std::move(row));
}

void Course::keep(CaseRow row) {
  const std::uint64_t number = row.number;
  for (const auto& [path, hash] : row.files) note_file(path, hash);
  std::erase_if(row.files, [&](const auto& file) { return !kept_.insert(file.first).second; });
  bad_ += failed(row) ? 1u : 0u;
  journal_.add(std::move(row));
  progress_.show(journal_.rows().size(), bad_);
  if (!best_) return;
  try {
    best_->kept(journal_.rows(), number);
  } catch (const UsageError&) {
    journal_.remove();  // no other command goes on with these
    throw;
  }
}

void Course::note_file(const std::string& path, const std::string& hash) {
  require(files_.try_emplace(path, hash).first->second == hash, path,
          " was changed while the sweep runs: put it back as it was, and the same command goes on with the rest; or "
          "delete the journal and begin anew");
}

}  // namespace pantin::player
