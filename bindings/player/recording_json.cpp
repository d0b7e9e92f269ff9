// Lines of a recording.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "choreography/commands.hpp"
#include "player/recording.hpp"

namespace pantin::player {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 3;

std::string hexadecimal(std::uint64_t value) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
  return digits;
}

/// Throws Error where the text is no such number.
std::uint64_t from_hexadecimal(const std::string& digits) {
  std::uint64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [rest, bad] = std::from_chars(digits.data(), end, value, 16);
  require(bad == std::errc{} && rest == end, "'", digits, "' is no hash");
  return value;
}

/// JSON is UTF-8, and what a scene or a file says need not be: each byte becomes a character.
std::string letters_of(const std::string& bytes) {
  std::string letters;
  for (const char byte : bytes) {
    const auto code = static_cast<unsigned char>(byte);
    if (code >= 0x80) letters += static_cast<char>(0xc0 | code >> 6);
    letters += static_cast<char>(code >= 0x80 ? 0x80 | (code & 0x3f) : code);
  }
  return letters;
}

/// Throws Error where the text is none of these.
std::string bytes_of(const std::string& letters) {
  std::string bytes;
  for (std::size_t i = 0; i < letters.size(); i++) {
    const auto code = static_cast<unsigned char>(letters[i]);
    if (code < 0x80) {
      bytes += letters[i];
      continue;
    }
    require((code == 0xc2 || code == 0xc3) && i + 1 < letters.size(), "a text has a letter that is no byte");
    bytes += static_cast<char>((code & 3) << 6 | (static_cast<unsigned char>(letters[++i]) & 0x3f));
  }
  return bytes;
}

/// Throws Error where it is none, or not of that type: a cast would be undefined.
template <class Whole>
Whole whole_of(const Json& json) {
  require(json.is_number_integer(), json.dump(), " is no whole number");
  const bool fits = json.is_number_unsigned() ? std::in_range<Whole>(json.get<std::uint64_t>())
                                              : std::in_range<Whole>(json.get<std::int64_t>());
  require(fits, json.dump(), " is out of range");
  return json.get<Whole>();
}

/// JSON has no infinity.
Json json_of(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0.0 ? "inf" : "-inf";
}
double number_of(const Json& json) {
  if (json.is_number()) return json;
  const std::string name = json;
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  require(name == "inf" || name == "-inf", "'", name, "' is no number");
  return name == "inf" ? infinity : -infinity;
}

Json json_of(const SceneValue& value) {
  if (const auto* letters = std::get_if<std::string>(&value)) return letters_of(*letters);
  return std::visit([](const auto& plain) { return Json(plain); }, value);
}

SceneValue value_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return bytes_of(json);
  return json.get<double>();
}

Json json_of(Vec3 v) { return Json::array({json_of(v[0]), json_of(v[1]), json_of(v[2])}); }
Vec3 vec_of(const Json& json) { return vec(number_of(json.at(0)), number_of(json.at(1)), number_of(json.at(2))); }

template <class Row>
Json json_of(Handle<Row> id) {
  return Json::array({id.slot, id.generation});
}
template <class Row>
void read(const Json& json, Handle<Row>& id) {
  id = {whole_of<std::uint32_t>(json.at(0)), whole_of<std::uint32_t>(json.at(1))};
}

constexpr std::array<const char*, 12> kinds = {"nothing", "point",      "particle",    "body",  "constraint", "group",
                                               "family",  "connection", "interaction", "field", "emitter",    "shape"};
static_assert(kinds.size() == std::variant_size_v<AnyId>);

Json json_of(const AnyId& thing) {
  return std::visit(
      [&](const auto& id) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(id)>, std::monostate>)
          return nullptr;
        else
          return Json::array({kinds[thing.index()], id.slot, id.generation});
      },
      thing);
}

AnyId thing_of(const Json& json) {
  AnyId thing;
  if (json.is_null()) return thing;
  const std::string kind = json.at(0);
  const auto slot = whole_of<std::uint32_t>(json.at(1)), generation = whole_of<std::uint32_t>(json.at(2));
  const auto find = [&]<std::size_t... k>(std::index_sequence<k...>) {
    return ((kind == kinds[k + 1] &&
             (thing.emplace<k + 1>(std::variant_alternative_t<k + 1, AnyId>{slot, generation}), true)) ||
            ...);
  };
  require(find(std::make_index_sequence<kinds.size() - 1>()), "'", kind, "' is no kind of thing");
  return thing;
}

Json json_of(const Command& c) {
  Json json{{"kind", name_of(c.kind)}, {"hand", c.hand}};
  if (c.point) json["point"] = json_of(c.point);
  if (c.other) json["other"] = json_of(c.other);
  if (!std::holds_alternative<std::monostate>(c.thing)) json["thing"] = json_of(c.thing);
  if (!std::holds_alternative<std::monostate>(c.other_thing)) json["other_thing"] = json_of(c.other_thing);
  if (c.form != MadeForm::bare) json["form"] = form_names[static_cast<std::size_t>(c.form)];
  if (norm2(c.position) != 0.0) json["place"] = json_of(c.position);
  if (norm2(c.amount) != 0.0) json["amount"] = json_of(c.amount);
  for (Vec3 point : c.points) json["points"].push_back(json_of(point));
  if (c.max_force != 0.0) json["max_force"] = json_of(c.max_force);
  if (c.mass != 0.0) json["mass"] = json_of(c.mass);
  if (c.radius != 0.0) json["radius"] = json_of(c.radius);
  if (c.energy != 0.0) json["energy"] = json_of(c.energy);
  if (c.value != 0.0) json["value"] = json_of(c.value);
  if (!c.name.empty()) json["name"] = letters_of(c.name);
  return json;
}

Command::Kind kind_of(const std::string& name) {
  const auto found = std::find(command_names.begin(), command_names.end(), name);
  require(found != command_names.end(), "there is no command '", name, "'");
  return static_cast<Command::Kind>(found - command_names.begin());
}

MadeForm form_of(const std::string& name) {
  const auto found = std::find(form_names.begin(), form_names.end(), name);
  require(found != form_names.end(), "there is no form '", name, "'");
  return static_cast<MadeForm>(found - form_names.begin());
}

Command command_of(const Json& json) {
  Command c;
  c.kind = kind_of(json.at("kind"));
  c.hand = whole_of<std::int32_t>(json.at("hand"));
  for (const auto& [name, value] : json.items()) {
    if (name == "point")
      read(value, c.point);
    else if (name == "other")
      read(value, c.other);
    else if (name == "thing")
      c.thing = thing_of(value);
    else if (name == "other_thing")
      c.other_thing = thing_of(value);
    else if (name == "form")
      c.form = form_of(value);
    else if (name == "place")
      c.position = vec_of(value);
    else if (name == "amount")
      c.amount = vec_of(value);
    else if (name == "points")
      for (const Json& point : value) c.points.push_back(vec_of(point));
    else if (name == "max_force")
      c.max_force = number_of(value);
    else if (name == "mass")
      c.mass = number_of(value);
    else if (name == "radius")
      c.radius = number_of(value);
    else if (name == "energy")
      c.energy = number_of(value);
    else if (name == "value")
      c.value = number_of(value);
    else if (name == "name")
      c.name = bytes_of(value);
    else
      require(name == "kind" || name == "hand", "a command has no '", name, "'");
  }
  return c;
}

void write(Json& line, const StepInput& input) {
  for (const HandMove& move : input.moves)
    line["moves"].push_back(
        {move.hand, json_of(move.position[0]), json_of(move.position[1]), json_of(move.position[2]), move.pressed});
  for (const Command& command : input.commands) line["commands"].push_back(json_of(command));
}
void write(Json& line, const DoneAtOnce& done) {
  for (const Command& command : done.commands) line["at_once"].push_back(json_of(command));
}
void write(Json& line, const HandCame&) { line["hand"] = true; }
void write(Json& line, const ParameterChange& change) {
  line["parameter"] = letters_of(change.name);
  line["value"] = json_of(change.value);
}
void write(Json& line, const FieldEdit& edit) {
  line["edit"] = json_of(edit.thing);
  line["field"] = letters_of(edit.field);
  if (const auto* number = std::get_if<double>(&edit.value))
    line["value"] = *number;
  else if (const auto* truth = std::get_if<bool>(&edit.value))
    line["value"] = *truth;
  else if (const auto* vector = std::get_if<Vec3>(&edit.value))
    line["value"] = json_of(*vector);
  else
    line["value"] = letters_of(std::get<std::string>(edit.value));
}
void write(Json& line, const StateKept& kept) { line["keep"] = kept.number; }
void write(Json& line, const StateRestored& restored) { line["restore"] = restored.number; }
void write(Json& line, const Restarted&) { line["restart"] = true; }
void write_opening(Json& line, const std::map<std::string, std::string>& set, const SavedValues& saved) {
  line["set"] = Json::object();
  for (const auto& [name, value] : set) line["set"][letters_of(name)] = letters_of(value);
  for (const auto& [name, value] : saved) line["saved"][letters_of(name)] = json_of(value);
}
void write(Json& line, const SceneOpened& opened) {
  line["open"] = letters_of(opened.scene);
  line["step"] = opened.step;
  write_opening(line, opened.set, opened.saved);
}
void write(Json& line, const FileFound& file) {
  line["file"] = letters_of(file.path);
  line["content"] = letters_of(file.content);
}
void write(Json& line, const GoneOn&) { line["reload"] = true; }
void write(Json& line, const StepFailed&) { line["failed"] = true; }
void write(Json& line, const StateCheck& check) {
  line["time"] = check.time;
  line["hash"] = hexadecimal(check.hash);
}
void write(Json& line, const RecordingEnd&) { line["end"] = true; }

std::vector<Command> commands_of(const Json& list) {
  std::vector<Command> commands;
  for (const Json& command : list) commands.push_back(command_of(command));
  return commands;
}

StepInput input_of(const Json& line) {
  StepInput input;
  if (line.contains("moves"))
    for (const Json& move : line["moves"])
      input.moves.push_back({whole_of<std::int32_t>(move.at(0)),
                             vec(number_of(move.at(1)), number_of(move.at(2)), number_of(move.at(3))), move.at(4)});
  if (line.contains("commands")) input.commands = commands_of(line["commands"]);
  return input;
}

FieldEdit edit_of(const Json& line) {
  FieldEdit edit{thing_of(line.at("edit")), bytes_of(line.at("field")), 0.0};
  const Json& value = line.at("value");
  if (value.is_array())
    edit.value = vec_of(value);
  else
    std::visit([&](const auto& plain) { edit.value = plain; }, value_of(value));
  return edit;
}

void read_opening(const Json& line, std::map<std::string, std::string>& set, SavedValues& saved) {
  for (const auto& [name, value] : line.at("set").items()) set.emplace(bytes_of(name), bytes_of(value));
  if (line.contains("saved"))
    for (const auto& [name, json] : line.at("saved").items()) saved.emplace(bytes_of(name), value_of(json));
}

RecordingHead read_head(const Json& line) {
  const auto found = whole_of<int>(line.at("pantin"));
  require(found == format_version, "it has the format ", found, ", and this program reads the format ", format_version);
  RecordingHead head{line.at("version"), bytes_of(line.at("scene")), {}, {}};
  read_opening(line, head.set, head.saved);
  for (const auto& [path, content] : line.at("files").items()) head.files.emplace(bytes_of(path), bytes_of(content));
  return head;
}

SceneOpened opened_of(const Json& line) {
  SceneOpened opened{bytes_of(line.at("open")), {}};
  read_opening(line, opened.set, opened.saved);
  opened.step = line.at("step");
  require(opened.step > 0.0, "a step of ", opened.step, " s is none");
  return opened;
}

RecordedAct read_act(const Json& line) {
  RecordedAct act{whole_of<std::uint64_t>(line.at("tick")), RecordingEnd{}};
  if (line.contains("moves") || line.contains("commands"))
    act.what = input_of(line);
  else if (line.contains("at_once"))
    act.what = DoneAtOnce{commands_of(line["at_once"])};
  else if (line.contains("hand"))
    act.what = HandCame{};
  else if (line.contains("parameter"))
    act.what = ParameterChange{bytes_of(line.at("parameter")), value_of(line.at("value"))};
  else if (line.contains("edit"))
    act.what = edit_of(line);
  else if (line.contains("keep"))
    act.what = StateKept{whole_of<std::uint64_t>(line.at("keep"))};
  else if (line.contains("restore"))
    act.what = StateRestored{whole_of<std::uint64_t>(line.at("restore"))};
  else if (line.contains("restart"))
    act.what = Restarted{};
  else if (line.contains("open"))
    act.what = opened_of(line);
  else if (line.contains("file"))
    act.what = FileFound{bytes_of(line.at("file")), bytes_of(line.at("content"))};
  else if (line.contains("reload"))
    act.what = GoneOn{};
  else if (line.contains("failed"))
    act.what = StepFailed{};
  else if (line.contains("hash"))
    act.what = StateCheck{line.at("time"), from_hexadecimal(line.at("hash"))};
  else
    require(line.contains("end"), "this says nothing that is known");
  return act;
}

/// Throws Error that leaves out what the JSON library calls its errors.
template <class What>
What read_line(const std::string& line, What (*read)(const Json&)) {
  const Json json = Json::parse(line, nullptr, false);
  require(!json.is_discarded(), "the line is no JSON");
  try {
    return read(json);
  } catch (const Json::exception& error) {
    const std::string_view told = error.what();
    throw Error(std::string(told.substr(std::min(told.find(']') + 2, told.size()))));
  }
}

}  // namespace

std::string line_of(const RecordingHead& head) {
  Json line{{"pantin", format_version}, {"version", head.version}, {"scene", letters_of(head.scene)}};
  write_opening(line, head.set, head.saved);
  line["files"] = Json::object();
  for (const auto& [path, content] : head.files) line["files"][letters_of(path)] = letters_of(content);
  return line.dump();
}

RecordingHead head_of(const std::string& text) { return read_line(text, read_head); }

std::string line_of(const RecordedAct& act) {
  Json line{{"tick", act.tick}};
  std::visit([&](const auto& what) { write(line, what); }, act.what);
  return line.dump();
}

RecordedAct act_of(const std::string& text_of_line) { return read_line(text_of_line, read_act); }

}  // namespace pantin::player
