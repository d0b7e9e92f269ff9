#include "laws/within_cutoff.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace pantin {

namespace {

const Input of_pair{Role::distance2, 0, 0, {}};

/// A called law that is asked for its pairs' distances too.
class CalledWithin : public Called {
 public:
  CalledWithin(std::shared_ptr<Called> whole, double cutoff) : whole_(std::move(whole)), cutoff2_(cutoff * cutoff) {}

  void run(const Block& block) override {
    Block inner = block;
    inner.inputs = block.inputs.first(block.inputs.size() - 1);
    whole_->run(inner);
    const double* square = block.inputs.back();
    for (double* output : block.outputs)
      for (int k = 0; k < block.n; k++)
        if (!(square[k] < cutoff2_)) output[k] = 0.0;
  }

 private:
  std::shared_ptr<Called> whole_;
  double cutoff2_;
};

void cut_expressions(Law& law) {
  Expressions& g = law.graph;
  const Expr near = g.apply(Function::less, g.input(of_pair), g.constant(law.cutoff * law.cutoff));
  const Expr none = g.constant(0.0);
  std::vector<Expr> outputs = law.force;
  const std::size_t forces = outputs.size();
  for (Expr more : {law.energy, law.stiffness})
    if (more != no_expression) outputs.push_back(more);
  for (Expr& e : outputs) e = g.select(near, e, none);
  g.put_in_order(outputs);
  std::size_t next = forces;
  for (Expr* more : {&law.energy, &law.stiffness})
    if (*more != no_expression) *more = outputs[next++];
  outputs.resize(forces);
  law.force = std::move(outputs);
}

std::shared_ptr<const Law> cut(const Law& law) {
  auto made = std::make_shared<Law>(law);
  if (law.called) {
    made->called = std::make_shared<CalledWithin>(law.called, law.cutoff);
    made->inputs_wanted.push_back(of_pair);
  } else {
    cut_expressions(*made);
  }
  made->cutoff = std::numeric_limits<double>::infinity();
  return made;
}

}  // namespace

std::shared_ptr<const Law> within_cutoff(const std::shared_ptr<const Law>& law) {
  if (!law || !std::isfinite(law->cutoff) || law->remade) return law;
  if (!law->within) {
    const auto made = std::const_pointer_cast<Law>(cut(*law));
    made->also = within_cutoff(law->also);
    law->within = made;
  }
  return law->within;
}

}  // namespace pantin
