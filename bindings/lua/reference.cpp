#include "lua/reference.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include "lua/annotations.hpp"

namespace pantin::lua {
namespace {

/// A field, parameter or result: "name? type [unit] meaning".
struct Item {
  std::string name, type, meaning;
};

struct Function {
  std::string call, doc;  // "body:kick(impulse, at)"
  std::vector<Item> parameters;
  std::vector<std::string> results;
};

struct Section {
  std::string name, doc;
  std::vector<Item> fields;
  std::vector<Function> functions;
};

/// Where the type at the start of a text ends: at the first space that is in no bracket and not within "fun(…): type".
std::size_t end_of_type(std::string_view s) {
  int depth = 0;
  for (std::size_t i = 0; i < s.size(); i++) {
    if (std::string_view("({<[").find(s[i]) != std::string_view::npos && (s[i] != '[' || s.substr(i, 2) == "[]"))
      depth++;
    if (std::string_view(")}>]").find(s[i]) != std::string_view::npos) depth--;
    if (s[i] == ' ' && depth == 0 && (i == 0 || s[i - 1] != ':')) return i;
  }
  return s.size();
}

/// What comes before the first space, which is taken off.
std::string word(std::string_view& s) {
  const std::size_t end = std::min(s.find(' '), s.size());
  std::string first(s.substr(0, end));
  s.remove_prefix(std::min(end + 1, s.size()));
  return first;
}

Item item(std::string_view s) {
  std::string name = s.starts_with('[') ? std::string(s.substr(0, s.find(']') + 1)) : word(s);
  if (name.starts_with('[')) s.remove_prefix(std::min(name.size() + 1, s.size()));
  const std::size_t end = end_of_type(s);
  return {name, std::string(s.substr(0, end)), std::string(s.substr(std::min(end + 1, s.size())))};
}

/// In a cell of a table.
std::string cell(std::string_view s) {
  std::string out;
  for (const char c : s) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string code(const std::string& s) { return s.empty() ? "" : "`" + s + "`"; }

/// Reads the annotations line by line: what is said before a class or function belongs to it.
class Reader {
 public:
  Reader() { sections_.push_back({"Functions", "Global functions of a scene and of a test.", {}, {}}); }

  void read(std::string_view line) {
    if (line.starts_with("function ")) return end_function(line.substr(9));
    if (!line.starts_with("---") || line.starts_with("---@meta")) return;
    line.remove_prefix(3);
    if (!line.starts_with('@')) {
      doc_ += (doc_.empty() ? "" : " ") + std::string(line);
      return;
    }
    const std::string tag = word(line);
    if (tag == "@class") return begin_class(line);
    if (tag == "@alias") return add_alias(line);
    if (tag == "@field") sections_[open_].fields.push_back(item(line));
    if (tag == "@operator") sections_[open_].fields.push_back({"operator", std::string(line), ""});
    if (tag == "@param") function_.parameters.push_back(item(line));
    if (tag == "@return") function_.results.push_back(std::string(line));
  }
  /// The scene, then what has functions, then plain tables.
  std::vector<Section> sections() const {
    std::vector<Section> sorted = sections_;
    const auto rank = [](const Section& s) { return s.name == "Scene" ? 0 : s.functions.empty() ? 2 : 1; };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Section& a, const Section& b) { return rank(a) < rank(b); });
    return sorted;
  }
  const std::vector<Item>& aliases() const { return aliases_; }

 private:
  void begin_class(std::string_view line) {
    std::string name = word(line);
    if (name.ends_with(':')) {
      name.pop_back();
      std::string bases = word(line);
      while (bases.ends_with(',')) bases += " " + word(line);
      doc_ += (doc_.empty() ? "Also all of " : " Also all of ") + bases + ".";
    }
    if (!line.empty()) doc_ += (doc_.empty() ? "" : " ") + std::string(line);
    open_ = sections_.size();
    index_[name] = open_;
    sections_.push_back({name, doc_, {}, {}});
    doc_.clear();
  }

  void add_alias(std::string_view line) {
    const Item alias = item(line);
    aliases_.push_back(alias);
    doc_.clear();
  }

  /// `header` is "Body:kick(impulse, at) end".
  void end_function(std::string_view header) {
    function_.call = std::string(header.substr(0, header.rfind(')') + 1));
    function_.doc = doc_;
    const std::size_t dot = header.find_first_of(":.(");
    const std::string owner(header.substr(0, dot));
    std::size_t into = 0;
    if (header[dot] != '(') {
      const auto [found, added] =
          index_.try_emplace(owner.ends_with("_methods") ? owner.substr(0, owner.size() - 8) : owner, sections_.size());
      if (added) sections_.push_back({owner, "", {}, {}});
      into = found->second;
    }
    if (owner.ends_with("_methods")) function_.call.replace(0, owner.size(), owner.substr(0, owner.size() - 8));
    sections_[into].functions.push_back(std::move(function_));
    function_ = {};
    doc_.clear();
  }

  std::vector<Section> sections_;
  std::map<std::string, std::size_t> index_;
  std::size_t open_ = 0;
  std::vector<Item> aliases_;
  std::string doc_;
  Function function_;
};

void write_items(std::ostringstream& out, const char* what, const std::vector<Item>& items) {
  if (items.empty()) return;
  out << "\n| " << what << " | type | meaning |\n| --- | --- | --- |\n";
  for (const Item& i : items)
    out << "| " << code(cell(i.name)) << " | " << code(cell(i.type)) << " | " << cell(i.meaning) << " |\n";
}

void write_function(std::ostringstream& out, const Function& f) {
  out << "\n**`" << f.call << "`**";
  for (std::size_t i = 0; i < f.results.size(); i++) {
    const std::size_t end = end_of_type(f.results[i]);
    out << (i == 0 ? " → " : ", ") << code(f.results[i].substr(0, end)) << f.results[i].substr(end);
  }
  out << (f.doc.empty() ? "" : "  \n") << f.doc << "\n";
  for (const Item& p : f.parameters)
    out << "- " << code(p.name) << ": " << code(p.type) << (p.meaning.empty() ? "" : " ") << p.meaning << "\n";
}

}  // namespace

std::string reference() {
  Reader reader;
  std::istringstream in(annotations());
  for (std::string line; std::getline(in, line);) reader.read(line);
  std::ostringstream out;
  out << "# Reference\n\nWritten by `pantin meta reference` from the tables of the bindings; do not edit. In brackets: "
         "units; a name with `?` may be left out.\n\n";
  const std::vector<Section> sections = reader.sections();
  for (const Section& s : sections) out << "[" << s.name << "](#" << s.name << ") ";
  out << "\n\n## Types\n";
  write_items(out, "name", reader.aliases());
  for (const Section& s : sections) {
    out << "\n<a id=\"" << s.name << "\"></a>\n## " << s.name << "\n";
    if (!s.doc.empty()) out << "\n" << s.doc << "\n";
    write_items(out, "field", s.fields);
    for (const Function& f : s.functions) write_function(out, f);
  }
  return out.str();
}

}  // namespace pantin::lua
