#include <cmath>

#include "choreography/choreography.hpp"
#include "fields/measures.hpp"

namespace pantin::fields {

const char* name_of(EventState state) {
  static constexpr const char* names[] = {"waiting", "fired", "dropped", "cancelled"};
  return names[static_cast<std::size_t>(state)];
}

namespace {

const char* word_of(EventKind kind) {
  static constexpr const char* names[] = {"at", "every", "over", "when", "play"};
  return names[static_cast<std::size_t>(kind)];
}

Table table_of(const TimelineEntry& entry) {
  Table table = {{"kind", word_of(entry.kind)}, {"state", name_of(entry.state)}};
  const auto set_text = [&](const char* name, const std::string& value) {
    if (!value.empty()) table.push_back({name, value});
  };
  if (!std::isnan(entry.time)) table.push_back({"time", entry.time});
  if (entry.kind == EventKind::over) {
    table.push_back({"from", entry.from});
    table.push_back({"to", entry.until});
  }
  if (entry.kind == EventKind::every) table.push_back({"period", entry.period});
  table.push_back({"fired", static_cast<std::int64_t>(entry.fired)});
  set_text("label", entry.label);
  set_text("target", entry.target);
  return table;
}

}  // namespace

Table timeline_of(const World& world) {
  Table list;
  for (const TimelineEntry& entry : timeline(world)) list.push_back({"", table_of(entry)});
  return list;
}

}  // namespace pantin::fields
