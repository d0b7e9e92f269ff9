#include "player/sweep/bundle.hpp"

#include <chrono>
#include <string_view>

#include "player/csv.hpp"
#include "player/sweep/journal.hpp"

namespace pantin::player {
namespace {

/// Texts, each ended by the one character that no argument of a program and no line of a journal has.
void put(std::string& all, const std::string& part) { all.append(part).push_back('\0'); }

void put(std::string& all, std::size_t number) { put(all, std::to_string(number)); }

std::string take(std::string_view& rest) {
  const std::size_t end = rest.find('\0');
  std::string part(rest.substr(0, end));
  rest.remove_prefix(end + 1);
  return part;
}

std::size_t take_number(std::string_view& rest) { return std::stoull(take(rest)); }

Bundle take_bundle(std::string_view& rest) {
  Bundle bundle(take_number(rest));
  for (CaseOrder& order : bundle) {
    order.number = take_number(rest);
    order.set.resize(take_number(rest));
    for (auto& [name, value] : order.set) {
      name = take(rest);
      value = take(rest);
    }
  }
  return bundle;
}

Bundle bundle_of(std::string_view text) { return take_bundle(text); }

std::string text_of(const BundleResult& result) {
  std::string all;
  put(all, number_text(result.seconds));
  put(all, result.rows.size());
  for (const CaseRow& row : result.rows) put(all, line_of(row));
  return all + player::text_of(result.left);
}

}  // namespace

std::string text_of(const Bundle& bundle) {
  std::string all;
  put(all, bundle.size());
  for (const CaseOrder& order : bundle) {
    put(all, order.number);
    put(all, order.set.size());
    for (const auto& [name, value] : order.set) {
      put(all, name);
      put(all, value);
    }
  }
  return all;
}

std::string run_bundle(const std::string& bundle, const std::function<CaseRow(const CaseOrder&)>& run) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  BundleResult result;
  for (const CaseOrder& order : bundle_of(bundle)) {
    if (!result.left.empty() || result.seconds > bundle_time) {
      result.left.push_back(order);
      continue;
    }
    result.rows.push_back(run(order));
    result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  return text_of(result);
}

std::string result_of_dead(const std::string& bundle, const std::string& how) {
  BundleResult result{{}, bundle_of(bundle)};
  if (result.left.size() == 1) {
    result.rows.push_back({result.left[0].number, {}, {{"error", how}}, {}});
    result.left.clear();
  }
  return text_of(result);
}

BundleResult result_of(const std::string& text) {
  std::string_view rest = text;
  BundleResult result;
  result.seconds = std::stod(take(rest));
  result.rows.resize(take_number(rest));
  for (CaseRow& row : result.rows) row = row_of(take(rest));
  result.left = take_bundle(rest);
  return result;
}

}  // namespace pantin::player
