#include "player/lua_rows.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/check.hpp"
#include "base/shortened.hpp"

namespace pantin::player {
namespace {

bool leads_to(double at, const LuaOfBody& body, int k) {
  return at == body.at[k] || at + body.arm[k] == body.centre[k];
}

/// A line between those numbers in brackets that may count.
struct Counted {
  std::vector<std::string> between;
  std::vector<std::size_t> numbers;
};

Counted counted(const std::string& line) {
  Counted found;
  std::size_t begin = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); i++) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) in_quotes = !in_quotes;
    if (line[i] != '[' || in_quotes || std::string_view(line).substr(0, i).ends_with(".points")) continue;
    std::size_t end = i + 1;
    while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end])) != 0) end++;
    if (end == i + 1 || end == line.size() || line[end] != ']') continue;
    found.between.push_back(line.substr(begin, i + 1 - begin));
    found.numbers.push_back(std::stoul(line.substr(i + 1, end - i - 1)));
    begin = end;
  }
  found.between.push_back(line.substr(begin));
  return found;
}

bool counts_on(const Counted& first, const Counted& next, std::size_t by) {
  if (first.numbers.empty() || first.between != next.between) return false;
  for (std::size_t i = 0; i < first.numbers.size(); i++)
    if (first.numbers[i] + by != next.numbers[i]) return false;
  return true;
}

void add_loop(const Counted& first, std::size_t count, std::vector<std::string>& lines) {
  const std::size_t from = *std::min_element(first.numbers.begin(), first.numbers.end());
  std::string body = "  ";
  for (std::size_t i = 0; i < first.numbers.size(); i++) {
    body += first.between[i] + "i";
    if (first.numbers[i] > from) body += text(" + ", first.numbers[i] - from);
  }
  lines.push_back(text("for i = ", from, ", ", from + count - 1, " do"));
  lines.push_back(body + first.between.back());
  lines.push_back("end");
}

}  // namespace

std::string RowOfBodies::Coordinate::text() const {
  if (step == 0.0) return lua_of(first / divisor);
  const std::string count = std::fabs(step) == 1.0 ? "i" : lua_of(std::fabs(step)) + " * i";
  std::string sum = step < 0.0 ? "-" + count : count;
  if (first != 0.0) sum = lua_of(first) + (step < 0.0 ? " - " : " + ") + count;
  if (divisor == 1.0) return sum;
  return (first != 0.0 ? "(" + sum + ")" : sum) + " / " + lua_of(divisor);
}

RowOfBodies::RowOfBodies(const LuaOfBody& first) : bodies_{first} {}

RowOfBodies::Ways RowOfBodies::ways_to(const LuaOfBody& second) const {
  Ways ways;
  for (int k = 0; k < 3; k++) {
    const double from = bodies_[0].at[k], way = second.at[k] - from;
    std::vector<Coordinate>& all = ways[static_cast<std::size_t>(k)];
    all.push_back({from, shortened(way, largest(second.at - bodies_[0].at)), 1.0});
    for (const double divisor : {10.0, 100.0, 1000.0})
      all.push_back({std::round(from * divisor), std::round(way * divisor), divisor});
    all.push_back({from, shortened(way, std::fmax(largest(second.at), largest(bodies_[0].at))), 1.0});
    std::erase_if(
        all, [&](const Coordinate& c) { return !leads_to(c.at(0), bodies_[0], k) || !leads_to(c.at(1), second, k); });
  }
  return ways;
}

bool RowOfBodies::take(const LuaOfBody& next) {
  if (next.call != bodies_[0].call || next.options != bodies_[0].options) return false;
  Ways ways = bodies_.size() == 1 ? ways_to(next) : ways_;
  for (int k = 0; k < 3; k++) {
    std::vector<Coordinate>& all = ways[static_cast<std::size_t>(k)];
    std::erase_if(all, [&](const Coordinate& c) { return !leads_to(c.at(bodies_.size()), next, k); });
    if (all.empty()) return false;
  }
  ways_ = std::move(ways);
  bodies_.push_back(next);
  return true;
}

std::vector<std::string> RowOfBodies::lines(const std::string& table) const {
  std::string at, colors;
  for (const std::vector<Coordinate>& ways : ways_) at += (at.empty() ? "vec(" : ", ") + ways[0].text();
  for (const LuaOfBody& body : bodies_) colors += (colors.empty() ? "" : ", ") + quoted(body.color);
  const bool alike = std::ranges::all_of(bodies_, [&](const LuaOfBody& b) { return b.color == bodies_[0].color; });
  std::vector<std::string> lines = {text("for i = 0, ", bodies_.size() - 1, " do")};
  if (!alike) lines.push_back(text("  local color = ({ ", colors, " })[i + 1]"));
  lines.push_back(text("  ", table.empty() ? "" : table + "[i + 1] = ",
                       bodies_[0].with(at + ")", alike ? quoted(bodies_[0].color) : "color")));
  lines.push_back("end");
  return lines;
}

std::vector<std::string> with_loops(const std::vector<std::string>& lines) {
  std::vector<std::string> folded;
  for (std::size_t i = 0; i < lines.size();) {
    const Counted first = counted(lines[i]);
    std::size_t count = 1;
    while (i + count < lines.size() && counts_on(first, counted(lines[i + count]), count)) count++;
    if (count < RowOfBodies::least)
      folded.insert(folded.end(), lines.begin() + static_cast<std::ptrdiff_t>(i),
                    lines.begin() + static_cast<std::ptrdiff_t>(i + count));
    else
      add_loop(first, count, folded);
    i += count;
  }
  return folded;
}

}  // namespace pantin::player
