#include "lua/scene/kept_functions.hpp"

#include "lua/law/captured.hpp"
#include "lua/thing/script_functions.hpp"

namespace pantin::lua {
namespace {

template <class... F>
struct Kinds {};

/// What a number is kept in: a kind of constraint, or none.
std::uint8_t kind_that_keeps(const KeptNumber& kept) {
  for (std::uint8_t kind = 0; kind < constraint_names.size(); kind++) {
    const KeptNumber& known = rule_of(static_cast<ConstraintKind>(kind)).keeps;
    if (known.name == kept.name && known.range == kept.range) return kind;
  }
  return constraint_names.size();
}

/// Both directions of each kind of function: its own fields, with its callback.
template <class Heap, class A>
class FunctionFields {
 public:
  FunctionFields(Heap& heap, A& a, Script& script) : heap_(heap), a_(a), script_(script) {}

  Callback either(const Callback* callback) {
    if constexpr (A::reads) {
      return heap_.function();
    } else {
      heap_.function(*callback);
      return *callback;
    }
  }
  template <class T>
  T with_text(const T* f, std::string T::*text, auto... rest) {
    std::string said = f ? f->*text : "";
    visit(a_, said);
    return {either(f ? &f->function : nullptr), said, rest...};
  }
  CalledPosition go(const CalledPosition* f) { return with_text(f, &CalledPosition::what); }
  CalledTurn go(const CalledTurn* f) { return with_text(f, &CalledTurn::what); }
  CalledProbe go(const CalledProbe* f) { return with_text(f, &CalledProbe::name); }
  CalledNumber go(const CalledNumber* f) {
    std::uint8_t kind = f ? kind_that_keeps(f->kept) : std::uint8_t{0};
    visit(a_, kind);
    const bool known = kind < constraint_names.size();
    return with_text(f, &CalledNumber::what, known ? rule_of(static_cast<ConstraintKind>(kind)).keeps : KeptNumber{});
  }
  CalledRate go(const CalledRate* f) { return {either(f ? &f->function : nullptr)}; }
  CalledCondition go(const CalledCondition* f) { return {either(f ? &f->function : nullptr)}; }
  CalledOnMet go(const CalledOnMet* f) { return {either(f ? &f->function : nullptr), &script_}; }
  CalledAction go(const CalledAction* f) { return with_target(f); }
  CalledProgress go(const CalledProgress* f) { return with_target(f); }
  template <class T>
  T with_target(const T* f) {
    AnyId target = f ? f->target : AnyId();
    visit(a_, target);
    return {either(f ? &f->function : nullptr), &script_, target};
  }
  WatchedBond go(const WatchedBond* f) {
    WatchedBond made = f ? *f : WatchedBond{&script_.laws, {}};
    visit_law(heap_, a_, made.law);
    return made;
  }

 private:
  Heap& heap_;
  A& a_;
  Script& script_;
};

template <class Signature, class... F>
void keep_one(HeapWriter& heap, Writer& to, Script& script, const std::function<Signature>& function, Kinds<F...>) {
  FunctionFields<HeapWriter, Writer> fields(heap, to, script);
  std::uint8_t number = 0;
  bool done = false;
  const auto attempt = [&]<class T>(const T* held) {
    if (held && !done) {
      visit(to, number);
      fields.go(held);
      done = true;
    }
    number++;
  };
  (attempt(function.template target<F>()), ...);
  require(done, "a function of the program, not of the scene, cannot be kept in a file");
}

template <class Signature, class... F>
void make_one(HeapReader& heap, Reader& from, Script& script, std::function<Signature>& function, Kinds<F...>) {
  FunctionFields<HeapReader, Reader> fields(heap, from, script);
  std::uint8_t wanted = 0, number = 0;
  visit(from, wanted);
  const auto attempt = [&]<class T>(const T* none) {
    if (number++ == wanted) function = fields.go(none);
  };
  (attempt(static_cast<const F*>(nullptr)), ...);
  require(static_cast<bool>(function), "a function in it is of a kind that there is not");
}

[[noreturn]] void refuse_play() { throw Error("the scene's script waits in a play, which cannot be kept in a file"); }

}  // namespace

#define KEEP(Signature, ...)                                                       \
  void KeptFunctions::keep(Writer& to, const std::function<Signature>& function) { \
    keep_one(*to_, to, script_, function, Kinds<__VA_ARGS__>{});                   \
  }                                                                                \
  void KeptFunctions::make(Reader& from, std::function<Signature>& function) {     \
    make_one(*from_, from, script_, function, Kinds<__VA_ARGS__>{});               \
  }
KEEP(void(), CalledAction)
KEEP(void(double), CalledProgress)
KEEP(double(), CalledCondition, CalledProbe)
KEEP(double(double), CalledNumber, CalledRate)
KEEP(Vec3(double), CalledPosition)
KEEP(Quat(double), CalledTurn)
KEEP(void(ParticleId), CalledOnMet)
KEEP(void(ConnectionId), WatchedBond)
#undef KEEP
void KeptFunctions::keep(Writer&, const std::function<bool()>&) { refuse_play(); }
void KeptFunctions::make(Reader&, std::function<bool()>&) { refuse_play(); }
void KeptFunctions::keep(Writer&, const std::function<std::optional<Wait>()>&) { refuse_play(); }
void KeptFunctions::make(Reader&, std::function<std::optional<Wait>()>&) { refuse_play(); }

namespace {

/// A called law, which several may have.
template <class Heap, class A>
void visit_called(Heap& heap, A& a, std::shared_ptr<CalledLaw>& called) {
  std::uint32_t number = 0;
  bool is_new = false;
  if constexpr (!A::reads)
    if (called) std::tie(number, is_new) = a.number_of(called.get(), typeid(CalledLaw));
  visit(a, number);
  if constexpr (A::reads) {
    is_new = number == a.known.size() + 1;
    require(is_new || number <= a.known.size(), "it names a law that is not in it");
    if (!is_new && number > 0) {
      const Reader::Shared& shared = a.known[number - 1];
      require(shared.thing && shared.type == typeid(CalledLaw), "it names something of another kind");
      called = std::static_pointer_cast<CalledLaw>(shared.thing);
    }
    if (is_new) a.known.push_back({nullptr, typeid(CalledLaw)});
  }
  if (!is_new) return;
  const auto rest = [&](LawFunction f, int noises) {
    visit(a, f.form);
    visit(a, f.count);
    visit(a, f.def);
    visit(a, f.known);
    visit(a, f.exact);
    visit(a, noises);
    if constexpr (A::reads) {
      require(f.count >= 1 && f.count <= 4 && noises >= 0 && noises < 256, "a law in it contradicts itself");
      called = std::make_shared<CalledLaw>(f);
      called->noises = noises;
      a.known[number - 1].thing = called;
    }
  };
  if constexpr (A::reads) {
    rest(LawFunction{heap.function(), {}, 0, {}, {}, true}, 0);
  } else {
    heap.function(called->law().function);
    rest(called->law(), called->noises);
  }
}

template <class Heap, class A>
void visit_resolved(Heap& heap, A& a, ResolvedLaw& law) {
  const std::size_t size = visit_size(a, law.laws.size());
  if constexpr (A::reads) law.laws.resize(size);
  for (std::shared_ptr<const Law>& part : law.laws) {
    pantin::visit_law(a, part);
    require(part != nullptr, "a law is missing");
  }
  visit(a, law.values);
  visit(a, law.solve);
  visit_called(heap, a, law.function);
  std::uint64_t captured = !A::reads && law.function && !has_changed(law) ? 1 : 0;
  visit(a, captured);
  if constexpr (A::reads) law.captured = captured;
}

template <class Heap, class A>
void visit_law_spec(Heap& heap, A& a, LawSpec& spec) {
  visit(a, spec.word);
  visit(a, spec.kind);
  visit(a, spec.count);
  visit(a, spec.form);
  visit(a, spec.def);
  visit(a, spec.strict);
  visit(a, spec.exact);
  visit(a, spec.solve);
  visit(a, spec.warned);
  bool library = spec.library.has_value();
  visit(a, library);
  if constexpr (A::reads)
    if (library) spec.library.emplace();
  if (library) visit_resolved(heap, a, *spec.library);
  const std::size_t size = visit_size(a, spec.ready.size());
  if constexpr (A::reads) spec.ready.resize(size);
  for (LawSpec::Ready& ready : spec.ready) {
    visit(a, ready.known);
    visit(a, ready.exchangeable);
    visit_resolved(heap, a, ready.law);
  }
}

}  // namespace

void KeptFunctions::keep_called(Writer& to, const std::shared_ptr<Called>& called) {
  std::shared_ptr<CalledLaw> law = std::dynamic_pointer_cast<CalledLaw>(called);
  require(law != nullptr, "a law of the program, not of the scene, cannot be kept in a file");
  visit_called(*to_, to, law);
}

std::shared_ptr<Called> KeptFunctions::make_called(Reader& from) {
  std::shared_ptr<CalledLaw> law;
  visit_called(*from_, from, law);
  return law;
}

void visit_law(HeapWriter& heap, Writer& to, ResolvedLaw& law) { visit_resolved(heap, to, law); }
void visit_law(HeapReader& heap, Reader& from, ResolvedLaw& law) { visit_resolved(heap, from, law); }
void visit_spec(HeapWriter& heap, Writer& to, LawSpec& spec) { visit_law_spec(heap, to, spec); }
void visit_spec(HeapReader& heap, Reader& from, LawSpec& spec) { visit_law_spec(heap, from, spec); }

void find_captured(ResolvedLaw& law) {
  if (law.captured != 0u && law.function) law.captured = captured_values(law.function->law().function);
}

}  // namespace pantin::lua
