#include "lua/meta/reference.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "lua/meta/annotations.hpp"
#include "lua/thing/fields.hpp"

namespace pantin::lua {
namespace {

/// A field or parameter: "name? type [unit] meaning (default value)".
struct Item {
  std::string name, type, unit, usual, meaning;
};

struct Function {
  std::string name, arguments, doc, example;  // "Body:kick", "(impulse, at)"
  std::vector<Item> parameters;
  std::vector<std::string> results;
};

struct Section {
  std::string name, doc;
  std::vector<std::string> bases;  // whose fields and functions it has, too
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

/// Takes "(default …)" out of a meaning.
std::string take_default(std::string& meaning) {
  const std::string_view begin = "(default ";
  const std::size_t from = meaning.find(begin);
  if (from == meaning.npos) return "";
  std::size_t end = from + 1;
  for (int depth = 1; depth > 0 && end < meaning.size(); end++)
    depth += (meaning[end] == '(' ? 1 : 0) - (meaning[end] == ')' ? 1 : 0);
  const std::string usual = meaning.substr(from + begin.size(), end - 1 - from - begin.size());
  meaning.erase(from > 0 ? from - 1 : 0, end - from + 1);
  return usual;
}

Item item(std::string_view s) {
  Item item;
  item.name = s.starts_with('[') ? std::string(s.substr(0, s.find(']') + 1)) : word(s);
  if (item.name.starts_with('[')) s.remove_prefix(std::min(item.name.size() + 1, s.size()));
  const std::size_t end = end_of_type(s);
  item.type = s.substr(0, end);
  item.meaning = s.substr(std::min(end + 1, s.size()));
  item.usual = take_default(item.meaning);
  if (!item.meaning.starts_with('[')) return item;
  const std::size_t close = item.meaning.find(']');
  item.unit = item.meaning.substr(1, close - 1);
  item.meaning.erase(0, std::min(close + 2, item.meaning.size()));
  return item;
}

/// In a cell of a table.
std::string cell(std::string_view s) {
  std::string out;
  for (const char c : s) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string code(const std::string& s) { return s.empty() ? "" : "`" + s + "`"; }

/// Whether it is a type that things have, or have in common, and no plain table.
bool of_things(const Section& s) {
  const auto is_it = [&](const Type* type) { return s.name == type->name; };
  const auto types = all_types(), bases = base_types();
  return std::any_of(types.begin(), types.end(), is_it) || std::any_of(bases.begin(), bases.end(), is_it);
}

/// Reads the annotations line by line: what is said before a class or function belongs to it.
class Reader {
 public:
  Reader() { sections_.push_back({"Functions", "Global functions of a scene and of a test.", {}, {}, {}}); }

  void read(std::string_view line) {
    if (line.starts_with("function ")) return end_function(line.substr(9));
    if (!line.starts_with("---") || line.starts_with("---@meta")) return;
    line.remove_prefix(3);
    if (line.starts_with("```")) {
      in_example_ = !in_example_;
      return;
    }
    if (in_example_) {
      function_.example += std::string(line) + "\n";
    } else if (!line.starts_with('@')) {
      doc_ += (doc_.empty() ? "" : " ") + std::string(line);
    } else {
      read_tag(line);
    }
  }
  /// The scene, then what has functions or something in common with others, then plain tables.
  std::vector<Section> sections() const {
    std::vector<Section> sorted = sections_;
    const auto rank = [](const Section& s) {
      return s.name == "Scene" ? 0 : s.functions.empty() && !of_things(s) ? 2 : 1;
    };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Section& a, const Section& b) { return rank(a) < rank(b); });
    return sorted;
  }
  const std::vector<Item>& aliases() const { return aliases_; }

 private:
  void read_tag(std::string_view line) {
    const std::string tag = word(line);
    if (tag == "@class") return begin_class(line);
    if (tag == "@alias") return add_alias(line);
    if (tag == "@field") sections_[open_].fields.push_back(item(line));
    if (tag == "@operator") sections_[open_].fields.push_back({"operator", std::string(line), "", "", ""});
    if (tag == "@param") function_.parameters.push_back(item(line));
    if (tag == "@return") function_.results.push_back(std::string(line));
  }

  void begin_class(std::string_view line) {
    std::string name = word(line);
    std::vector<std::string> bases;
    for (bool more = name.ends_with(':'); more;) {
      std::string base = word(line);
      more = base.ends_with(',');
      if (more) base.pop_back();
      bases.push_back(base);
    }
    if (name.ends_with(':')) name.pop_back();
    open_ = sections_.size();
    index_[name] = open_;
    sections_.push_back({name, doc_, bases, {}, {}});
    doc_.clear();
  }

  void add_alias(std::string_view line) {
    const Item alias = item(line);
    aliases_.push_back(alias);
    doc_.clear();
  }

  /// `header` is "Body:kick(impulse, at) end".
  void end_function(std::string_view header) {
    const std::size_t open = header.find('('), dot = header.find_first_of(":.(");
    function_.doc = doc_;
    function_.arguments = header.substr(open, header.rfind(')') + 1 - open);
    std::string owner(header.substr(0, dot));
    if (owner.ends_with("_methods")) owner.resize(owner.size() - 8);
    function_.name = owner + std::string(header.substr(dot, open - dot));
    std::size_t into = 0;
    if (dot != open) {
      const auto [found, added] = index_.try_emplace(owner, sections_.size());
      if (added) sections_.push_back({owner, "", {}, {}, {}});
      into = found->second;
    }
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
  bool in_example_ = false;
};

/// Writes pages, in which what has an entry is linked to it.
class Writer {
 public:
  explicit Writer(const Reader& reader) : sections_(reader.sections()), aliases_(reader.aliases()) {
    for (const Section& s : sections_) entries_.insert(s.name);
    for (const Item& alias : aliases_) entries_.insert(alias_name(alias));
    for (const ReferenceTasks& tasks : reference_tasks())
      for (const ReferenceTask& task : tasks.tasks) wanted_.insert(task.entries.begin(), task.entries.end());
  }

  std::string page() {
    out_ << "# Reference\n\nWritten by `pantin meta reference` from the tables of the bindings; do not edit. Units are "
            "SI "
            "and radians; 1 is that of a plain number. A name with `?` may be left out: then the default holds.\n\n## "
            "By "
            "task\n";
    write_tasks();
    write_what_examples_have();
    out_ << "\n## All types\n\n";
    for (const Section& s : sections_) out_ << link(s.name) << " ";
    out_ << "\n\n";
    write_aliases();
    for (const Section& s : sections_) write_section(s);
    return out_.str();
  }

 private:
  static std::string alias_name(const Item& alias) { return alias.name.substr(0, alias.name.find('<')); }
  std::string link(const std::string& entry) const { return "[" + code(entry) + "](#" + entry + ")"; }
  static std::string anchor(const std::string& entry) { return "<a id=\"" + entry + "\"></a>"; }

  /// A type, which may have an entry.
  std::string type(const std::string& name) const {
    return entries_.contains(name) && name != "vec" && name != "quat" ? link(name) : code(name);
  }
  /// "every constraint", or another table of options.
  std::string like(const std::string& base) const {
    for (const Type* type : base_types())
      if (base == type->name) return text("every [", type->word, "](#", base, ")");
    return link(base);
  }

  void write_tasks() {
    for (const ReferenceTasks& tasks : reference_tasks()) {
      out_ << "\n### " << tasks.title << "\n\n";
      for (const ReferenceTask& task : tasks.tasks) {
        out_ << "- " << task.wanted << ":";
        for (std::size_t i = 0; i < task.entries.size(); i++) out_ << (i == 0 ? " " : ", ") << link(task.entries[i]);
        out_ << "\n";
      }
    }
  }

  void write_what_examples_have() {
    out_ << "\n## What the examples have\n\nEach example is run by a test, after these lines:\n\n```lua\n"
         << example_scene << "```\n\nand where it is one of a test, after these:\n\n```lua\n"
         << example_test << "```\n";
  }

  void write_aliases() {
    out_ << "| name | type | meaning |\n| --- | --- | --- |\n";
    for (const Item& i : aliases_)
      out_ << "| " << code(cell(i.name)) << anchor(alias_name(i)) << " | " << code(cell(i.type)) << " | "
           << cell(i.meaning) << " |\n";
  }

  void write_section(const Section& s) {
    out_ << "\n" << anchor(s.name) << "\n## " << s.name << "\n";
    if (!s.doc.empty()) out_ << "\n" << s.doc << "\n";
    for (std::size_t i = 0; i < s.bases.size(); i++) out_ << (i == 0 ? "\nAs " : " and ") << like(s.bases[i]);
    if (!s.bases.empty()) out_ << (s.fields.empty() && s.functions.empty() ? ".\n" : ", and:\n");
    write_fields(s);
    for (const Function& f : s.functions) write_function(f);
  }

  /// Columns that are empty are left out.
  void write_fields(const Section& s) {
    if (s.fields.empty()) return;
    bool units = false, defaults = false;
    for (const Item& i : s.fields) {
      units = units || !i.unit.empty();
      defaults = defaults || !i.usual.empty();
    }
    out_ << "\n| field | type |" << (units ? " unit |" : "") << (defaults ? " default |" : "")
         << " meaning |\n| --- | --- |" << (units ? " --- |" : "") << (defaults ? " --- |" : "") << " --- |\n";
    for (const Item& i : s.fields) {
      const std::string entry = s.name + "." + i.name;
      out_ << "| " << code(cell(i.name)) << (wanted_.contains(entry) ? anchor(entry) : "") << " | "
           << cell(type(i.type)) << " |";
      if (units) out_ << " " << i.unit << " |";
      if (defaults) out_ << " " << cell(i.usual) << " |";
      out_ << " " << cell(i.meaning) << " |\n";
    }
  }

  void write_function(const Function& f) {
    out_ << "\n" << (entries_.contains(f.name) ? "" : anchor(f.name)) << "**`" << f.name << f.arguments << "`**";
    for (std::size_t i = 0; i < f.results.size(); i++) {
      const std::size_t end = end_of_type(f.results[i]);
      out_ << (i == 0 ? " → " : ", ") << type(f.results[i].substr(0, end)) << f.results[i].substr(end);
    }
    out_ << (f.doc.empty() ? "" : "  \n") << f.doc << "\n";
    for (const Item& p : f.parameters) {
      out_ << "- " << code(p.name) << ": " << type(p.type);
      if (!p.unit.empty()) out_ << " [" << p.unit << "]";
      if (!p.meaning.empty()) out_ << " " << p.meaning;
      if (!p.usual.empty()) out_ << " (default " << p.usual << ")";
      out_ << "\n";
    }
    out_ << "\n```lua\n" << f.example << "```\n";
  }

  std::vector<Section> sections_;
  std::vector<Item> aliases_;
  std::set<std::string> entries_, wanted_;
  std::ostringstream out_;
};

Reader read_annotations() {
  Reader reader;
  std::istringstream in(annotations());
  for (std::string line; std::getline(in, line);) reader.read(line);
  return reader;
}

}  // namespace

std::string reference() { return Writer(read_annotations()).page(); }

std::vector<Example> reference_examples() {
  std::vector<Example> examples;
  for (const Section& s : read_annotations().sections())
    for (const Function& f : s.functions) {
      const bool testing = f.name == "test" || f.name == "expect" || f.name == "open" || f.name == "open_text";
      examples.push_back({f.name, f.example, testing || s.name == "OpenedScene" || s.name == "Expectation"});
    }
  return examples;
}

}  // namespace pantin::lua
