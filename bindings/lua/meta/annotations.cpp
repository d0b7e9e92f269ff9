#include "lua/meta/annotations.hpp"

#include <sstream>
#include <string_view>
#include <vector>

#include "lua/meta/force_annotations.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/thing/structure_type.hpp"

namespace pantin::lua {
namespace {

struct Parameter {
  std::string name, type, unit;
};

std::string_view trimmed(std::string_view s) {
  while (s.starts_with(' ')) s.remove_prefix(1);
  while (s.ends_with(' ')) s.remove_suffix(1);
  return s;
}

/// Splits at commas outside of brackets.
std::vector<std::string_view> split(std::string_view s) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= s.size(); i++) {
    if (i == s.size() || (s[i] == ',' && depth == 0)) {
      if (const auto part = trimmed(s.substr(from, i - from)); !part.empty()) parts.push_back(part);
      from = i + 1;
    } else if (s[i] == '(' || s[i] == '{') {
      depth++;
    } else if (s[i] == ')' || s[i] == '}') {
      depth--;
    }
  }
  return parts;
}

/// "force: vec [N]" into its parts.
std::vector<Parameter> parameters_of(const Method& method) {
  std::vector<Parameter> parameters;
  for (std::string_view part : split(method.parameters)) {
    const auto colon = part.find(':');
    std::string_view type = trimmed(part.substr(colon + 1));
    Parameter p{std::string(trimmed(part.substr(0, colon))), "", ""};
    if (const auto bracket = type.rfind(" ["); bracket != type.npos && type.ends_with(']')) {
      p.unit = type.substr(bracket);
      type = type.substr(0, bracket);
    }
    p.type = type;
    parameters.push_back(p);
  }
  return parameters;
}

bool has(const Type* base, const Field& field) {
  for (; base; base = base->base)
    for (const Field& of_base : base->fields)
      if (of_base.read == field.read && of_base.property == field.property &&
          std::string_view(of_base.name) == field.name)
        return true;
  return false;
}

bool has(const Type* base, const Method& method) {
  for (; base; base = base->base)
    for (const Method& of_base : base->methods)
      if (of_base.function == method.function) return true;
  return false;
}

/// All kinds of things.
std::string alias_of_things() {
  std::string names;
  for (const Type* type : all_types())
    for (const Type* base = type->base; base; base = base->base)
      if (base == &any_thing_type()) names += (names.empty() ? "" : "|") + std::string(type->name);
  return "---@alias Thing " + names + "\n\n";
}

/// `owner` is what it is called on: "Body:" or "structure.".
void write_method(std::ostringstream& out, const std::string& owner, const Method& method) {
  out << "---" << method.doc << "\n";
  write_example(out, method.example);
  std::string names;
  for (const Parameter& p : parameters_of(method)) {
    out << "---@param " << p.name << " " << p.type << p.unit << "\n";
    std::string name = p.name;
    if (name.ends_with('?')) name.pop_back();
    names += (names.empty() ? "" : ", ") + name;
  }
  for (std::string_view returned : split(method.returns)) out << "---@return " << returned << "\n";
  out << "function " << owner << method.name << "(" << names << ") end\n";
}

void write_type(std::ostringstream& out, const Type& type) {
  out << "---" << type.doc << "\n---@class " << type.name;
  if (type.base) out << ": " << type.base->name;
  out << "\n";
  for (const Field& field : type.fields) {
    if (has(type.base, field)) continue;
    out << "---@field " << field.name << " " << field.type << " ";
    if (*field.unit) out << "[" << field.unit << "] ";
    out << field.doc << (writable(field) ? "" : " (read only)") << "\n";
  }
  if (type.more) out << "---@field [string] " << type.more_doc << "\n";
  out << "local " << type.name << " = {}\n";
  for (const Method& method : type.methods)
    if (!has(type.base, method)) write_method(out, text(type.name, ":"), method);
  out << "\n";
}

}  // namespace

void write_example(std::ostream& out, std::string_view example) {
  if (example.empty()) return;
  out << "---```lua\n---";
  for (const char c : example) out << (c == '\n' ? "\n---" : std::string(1, c));
  out << "\n---```\n";
}

std::string annotations() {
  std::ostringstream out;
  out << annotations_head << alias_of_things();
  for (const Type* type : base_types()) write_type(out, *type);
  for (const Type* type : all_types()) write_type(out, *type);
  out << annotations_options;
  for (const ConstraintCall* call : constraint_calls())
    if (*call->options) out << call->options << "\n";
  out << annotations_shapes;
  out << force_annotations();
  out << "structure = {}\n";
  for (const Method& maker : structure_makers()) write_method(out, "structure.", maker);
  out << "\nshape = {}\n";
  for (const Method& maker : shape_makers()) write_method(out, "shape.", maker);
  out << "\n" << annotations_tail;
  return out.str();
}

}  // namespace pantin::lua
