// Programs give the same bits as code of the processor and by kernels.
#include "laws/machine_code.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "support/library_laws.hpp"

using namespace pantin;

namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

double some_number(Random& random) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double special[] = {0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 1e-310, 1e300, -1e300, infinity, -infinity, std::nan("")};
  const double which = random.uniform();
  if (which < 0.1) return special[static_cast<std::size_t>(random.uniform() * 12.0)];
  if (which < 0.2) return std::bit_cast<double>(random.bits());
  return (random.uniform() - 0.3) * 4.0;
}

/// How many values differ between the two ways, over some numbers for each input, of n values.
int differences(const Program& program, Random& random, int n) {
  Machine kernels(program), code(program);
  const std::shared_ptr<const MachineCode> made = MachineCode::of(program);
  REQUIRE(made);
  code.use(made);
  for (const Input& input : program.inputs) {
    const int i = kernels.input(input);
    const bool uniform = input.role == Role::time || input.role == Role::parameter;
    const double all = some_number(random);
    for (Machine* machine : {&kernels, &code}) machine->fill(i, all);
    for (int k = 0; k < n && !uniform; k++) kernels.column(i)[k] = code.column(i)[k] = some_number(random);
  }
  for (Machine* machine : {&kernels, &code}) {
    machine->run_uniform();
    machine->run(n);
  }
  int found = 0;
  for (std::size_t output = 0; output < program.outputs.size(); output++)
    for (int k = 0; k < n; k++) {
      const int o = static_cast<int>(output);
      found += same(kernels.output(o)[k], code.output(o)[k]) ? 0 : 1;
    }
  return found;
}

Expr random_node(Expressions& g, const std::vector<Expr>& known, Random& random) {
  const auto below = [&](int n) { return static_cast<int>(random.uniform() * n); };
  // What came last, or anything: deep graphs, some of whose values wait for long.
  const auto any = [&] {
    const auto n = static_cast<int>(known.size());
    return known[static_cast<std::size_t>(random.uniform() < 0.5 ? below(n) : n - 1 - below(std::min(n, 6)))];
  };
  const double knots[] = {0.2, 0.7, 1.6, 2.4, 4.0}, values[] = {1.0, 0.2, -0.4, 0.3, 0.5};
  switch (below(10)) {
    case 0: return g.constant(some_number(random));
    case 1: return g.add(any(), any());
    case 2: return g.subtract(any(), any());
    case 3: return g.multiply(any(), any());
    case 4: return g.divide(any(), any());
    case 5: return g.power(any(), 0.5 * (below(17) - 8));
    case 6: return g.scale(any(), some_number(random));
    case 7: return g.select(any(), any(), any());
    case 8: return g.spline(std::make_shared<Spline>(knots, values), any());
    default: break;
  }
  const auto function = static_cast<Function>(below(static_cast<int>(Function::select)));
  const bool of_two = function == Function::atan2 || function == Function::power ||
                      (function >= Function::minimum && function <= Function::less_or_equal);
  return g.apply(function, any(), of_two ? any() : no_expression);
}

Program random_program(Random& random, Uniform uniform) {
  Expressions g;
  std::vector<Expr> known;
  for (const char* name : {"x", "y", "z", "w"})
    for (const std::uint8_t who : {std::uint8_t{0}, std::uint8_t{1}})
      known.push_back(g.input({Role::attribute, who, 0, name}));
  for (const char* name : {"k", "l"}) known.push_back(g.input({Role::parameter, 0, 0, name}));
  known.push_back(g.input({Role::time, 0, 0, {}}));
  const int nodes = 1 + static_cast<int>(random.uniform() * 60.0);
  for (int i = 0; i < nodes; i++) known.push_back(random_node(g, known, random));
  std::vector<Expr> outputs;
  const int count = 1 + static_cast<int>(random.uniform() * 8.0);
  for (int i = 0; i < count; i++)
    outputs.push_back(known[known.size() - 1 - static_cast<std::size_t>(random.uniform() * nodes)]);
  return lower(g, outputs, uniform);
}

/// A sum of products of all pairs of twenty roots, which no processor has registers for.
Program wide_program() {
  Expressions g;
  std::vector<Expr> roots;
  for (int i = 0; i < 20; i++)
    roots.push_back(g.square_root(g.input({Role::attribute, 0, 0, "x" + std::to_string(i)})));
  Expr sum = g.constant(0.0);
  for (const Expr a : roots)
    for (const Expr b : roots) sum = g.apply(Function::maximum, g.multiply(a, b), sum);
  return lower(g, {&sum, 1});
}

/// Mappings of this process whose permissions have all of these letters.
int mappings(const std::string& letters) {
  std::ifstream file("/proc/self/maps");
  int count = 0;
  for (std::string range, permissions, rest; file >> range >> permissions && std::getline(file, rest);)
    count += permissions.find(letters[0]) != std::string::npos && permissions.find(letters[1]) != std::string::npos;
  return count;
}

bool have_machine_code() {
  Expressions g;
  const Expr e = g.input({Role::distance2, 0, 0, {}});
  return MachineCode::of(lower(g, {&e, 1})) != nullptr;
}

}  // namespace

TEST_CASE("machine code: random expressions have the bits of the kernels") {
  if (!have_machine_code()) return;
  Random random{11, 0};
  for (int round = 0; round < 1500; round++) {
    const Program program = random_program(random, {.parameters = round % 2 == 0});
    CAPTURE(round, program.code.size());
    REQUIRE(differences(program, random, round % 50) == 0);
  }
}

TEST_CASE("machine code: values that no register is left for wait in memory") {
  if (!have_machine_code()) return;
  Random random{5, 0};
  const Program program = wide_program();
  CHECK(program.slots > 20);
  CHECK(differences(program, random, 500) == 0);
}

TEST_CASE("machine code: all laws of the library have the bits of the kernels") {
  if (!have_machine_code()) return;
  Random random{3, 0};
  for (const auto& parts : testing::one_of_each())
    for (const Law& law : parts)
      for (const bool parameters : {true, false}) {
        std::vector<Expr> outputs = law.force;
        for (const Expr e : {law.energy, law.stiffness})
          if (e != no_expression) outputs.push_back(e);
        CAPTURE(law.name, parameters);
        CHECK(differences(lower(law.graph, outputs, {parameters}), random, 512) == 0);
      }
}

TEST_CASE("machine code: no page is written to and run at once, and none is kept") {
  if (!have_machine_code()) return;
  const int before = mappings("wx"), run = mappings("rx");
  {
    const std::shared_ptr<const MachineCode> code = MachineCode::of(wide_program());
    CHECK(mappings("wx") == before);
    CHECK(mappings("rx") == run + 1);
  }
  CHECK(mappings("rx") == run);
}

TEST_CASE("machine code: a system that lets no page become one that is run is asked once") {
  if (!have_machine_code()) return;
  const pid_t child = fork();
  if (child == 0) {
    constexpr int set_refusal = 65, no_gain = 1;  // PR_SET_MDWE, of Linux 6.3
    if (prctl(set_refusal, no_gain, 0, 0, 0) != 0) _exit(0);
    const bool none = MachineCode::of(wide_program()) == nullptr && MachineCode::of(wide_program()) == nullptr;
    _exit(none && machine_code_refused() ? 0 : 1);
  }
  int status = -1;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(!machine_code_refused());
}

TEST_CASE("machine code: there is none where it is not allowed") {
  allow_machine_code(false);
  CHECK(!MachineCode::of(wide_program()));
  allow_machine_code(true);
}
