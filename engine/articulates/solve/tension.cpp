#include "articulates/solve/tension.hpp"

#include <cmath>
#include <span>

#include "articulates/articulate.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

double rate_of_tension(const Articulate& articulate) {
  const double least = 1e-12 * articulate.length * articulate.length;
  double most = 0.0;
  for (std::size_t b = 0; b < articulate.batches.size(); b++) {
    const NodeBatch& batch = articulate.batches[b];
    for (const RowEnds& end : std::span(articulate.ends).subspan(batch.first_end, batch.last_end - batch.first_end))
      for (std::size_t lane = 0; lane < batch_size; lane++) {
        if (end.to[lane] >= 2 * articulate.rows.size()) continue;
        const Row& row = articulate.rows[end.row[lane]];
        if (row.lever > 0.0 || is_soft(row)) continue;
        const bool first = end.to[lane] % 2 == 0;
        const Node& node = articulate.nodes[static_cast<std::size_t>(first ? row.a : row.b)];
        const Vec3 arm = lane_of(end.r1, lane) - row.d1 * (first ? 0.5 : -0.5);
        const double tension = dot(first ? row.f : -row.f, arm), length2 = norm2(arm);
        if (!(tension > 0.0) || length2 < least) continue;
        const Vec3 along = transposed_times(node.R1, arm);
        const Vec3& inertia = node.inertia;
        const double across = 0.5 * (inertia[0] + inertia[1] + inertia[2] - dot(along, along * inertia) / length2);
        most = std::fmax(most, tension / (node.mass * length2 + (node.turns ? across : 0.0)));
      }
  }
  return std::sqrt(2.0 * most);
}

}  // namespace pantin
