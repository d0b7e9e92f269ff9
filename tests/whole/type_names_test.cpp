// Two types of one name in one namespace, in files that end in one program, are an error that no compiler sees.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/sources.hpp"

namespace {

using pantin::sources::Files;
using Tokens = std::vector<std::string>;

bool is_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where what begins at `at` and is not code ends: a comment, a text, a line for the preprocessor; `at` itself for code.
std::size_t skip(const std::string& text, std::size_t at) {
  const auto behind = [&](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    return found == std::string::npos ? text.size() : found + end.size();
  };
  const char c = text[at], next = at + 1 < text.size() ? text[at + 1] : '\0';
  const bool after_part = at > 0 && is_part(text[at - 1]);
  if (c == '/' && next == '/') return behind("\n", at);
  if (c == '/' && next == '*') return behind("*/", at + 2);
  if (c == 'R' && next == '"' && !after_part) {
    const std::size_t open = text.find('(', at);
    return behind(")" + text.substr(at + 2, open - at - 2) + "\"", open);
  }
  if (c == '#') {
    std::size_t end = behind("\n", at);
    while (end < text.size() && text[end - 2] == '\\') end = behind("\n", end);
    return end;
  }
  if (c != '"' && (c != '\'' || after_part)) return at;  // ' within a number parts its digits
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != c) end += text[end] == '\\' ? 2u : 1u;
  return end + 1;
}

Tokens tokens_of(const std::string& text) {
  Tokens tokens;
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = skip(text, at); end != at) {
      at = end;
    } else if (is_part(text[at])) {
      const std::size_t start = at;
      while (at < text.size() && is_part(text[at])) at++;
      tokens.push_back(text.substr(start, at - start));
    } else if (text.compare(at, 2, "::") == 0) {
      tokens.emplace_back("::");
      at += 2;
    } else {
      if (std::isspace(static_cast<unsigned char>(text[at])) == 0) tokens.emplace_back(1, text[at]);
      at++;
    }
  }
  return tokens;
}

/// Index behind the bracket that closes the one at `at`.
std::size_t behind_bracket(const Tokens& t, std::size_t at, const char* open, const char* close) {
  for (int depth = 0; at < t.size(); at++) {
    depth += (t[at] == open) - (t[at] == close);
    if (depth == 0) return at + 1;
  }
  return at;
}

/// The name of the type that a statement before its `{` defines, or empty.
std::string defined_type(const Tokens& t) {
  std::size_t at = 0;
  const auto is = [&](const char* word) { return at < t.size() && t[at] == word; };
  while (is("template")) at = behind_bracket(t, at + 1, "<", ">");
  if (!is("struct") && !is("class") && !is("union") && !is("enum")) return {};
  for (at++; is("struct") || is("class") || is("alignas") || is("[");) {
    if (is("["))
      at = behind_bracket(t, at, "[", "]");
    else
      at = is("alignas") ? behind_bracket(t, at + 1, "(", ")") : at + 1;
  }
  if (at >= t.size() || !is_part(t[at][0])) return {};
  const std::string name = t[at++];
  return at == t.size() || is(":") || is("final") ? name : std::string();
}

/// The namespace that a statement before its `{` opens, "" for one without a name; none where it opens something else.
std::optional<std::string> opened_namespace(const Tokens& t) {
  const std::size_t at = !t.empty() && t[0] == "inline" ? 1 : 0;
  if (at >= t.size() || t[at] != "namespace") return {};
  std::string name;
  for (std::size_t i = at + 1; i < t.size(); i++) name += t[i];
  return name;
}

/// "pantin::World" for each type of a namespace that has a name.
std::set<std::string> types_in(const std::string& text) {
  std::set<std::string> types;
  std::vector<std::optional<std::string>> scopes;  // namespaces, and what else braces enclose
  Tokens statement;
  for (const std::string& token : tokens_of(text)) {
    if (token == "{") {
      const bool shared = std::all_of(scopes.begin(), scopes.end(), [](const auto& s) { return s && !s->empty(); });
      if (const std::string name = defined_type(statement); shared && !name.empty()) {
        std::string full;
        for (const auto& scope : scopes) full += *scope + "::";
        types.insert(full + name);
      }
      scopes.push_back(opened_namespace(statement));
    } else if (token == "}" && !scopes.empty()) {
      scopes.pop_back();
    } else if (token != ";" && token != "}") {
      statement.push_back(token);
      continue;
    }
    statement.clear();
  }
  return types;
}

std::vector<std::string> clashes(const Files& files) {
  std::map<std::string, std::vector<std::string>> positions;
  for (const auto& [path, text] : files)
    for (const std::string& type : types_in(text)) positions[type].push_back(path);
  std::vector<std::string> wrong;
  for (const auto& [type, paths] : positions) {
    if (paths.size() < 2) continue;
    wrong.push_back(type + " in");
    for (const std::string& path : paths) wrong.back() += " " + path;
  }
  return wrong;
}

}  // namespace

TEST_CASE("no two types have one name") {
  const Files files = pantin::sources::read({"engine", "bindings", "tests"});
  REQUIRE(types_in(files.at("engine/world/world.hpp")).contains("pantin::World"));
  CHECK(clashes(files) == std::vector<std::string>());
}

TEST_CASE("two types of one name are found") {
  const std::string known = "namespace pantin {\nstruct Two : One { enum Kind { a }; };\n}\n";
  const auto [text, clash] = GENERATE(table<std::string, bool>({
      {"namespace pantin { struct Two {}; }", true},
      {"namespace pantin { template <class T> class alignas(8) Two final {}; }", true},
      {"inline namespace pantin { enum class Two : int { b }; }", true},
      {"namespace pantin { void f() { g(1'000, '{', \"{\"); } /* { */ struct Two {}; }", true},
      {"#define OPEN {\nnamespace pantin { const auto t = R\"x({\")x\"; struct Two {}; }", true},
      {"namespace pantin { namespace { struct Two {}; } }", false},
      {"namespace pantin { struct Two; Two f(); }", false},
      {"namespace pantin { void f() { struct Two {}; } struct Three { struct Two {}; }; }", false},
      {"namespace pantin { struct Three::Two {}; template <> struct Two<int> {}; enum Kind { a }; }", false},
      {"namespace pantin::lua { struct Two {}; }\nstruct Two {};", false},
      {"// namespace pantin { struct Two {}; }\n", false},
  }));
  INFO(text);
  const auto wrong = clashes({{"a.hpp", known}, {"b.cpp", text}});
  CHECK(wrong.size() == (clash ? 1 : 0));
  if (clash) CHECK(wrong[0] == "pantin::Two in a.hpp b.cpp");
}
