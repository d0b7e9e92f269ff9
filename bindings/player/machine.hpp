#pragma once

namespace pantin::player {

/// Processor time of this thread, which others on the machine do not lengthen, [ns].
double thread_time();

/// A measure of the machine's present speed: one of many dependent 3 × 3 matrix products, best of ten windows, [ns].
double product_time();

}  // namespace pantin::player
