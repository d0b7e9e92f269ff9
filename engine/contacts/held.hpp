#pragma once
#include <span>
#include <vector>

#include "contacts/gather.hpp"

namespace pantin {

/// Whether contacts and ties hold at rest what the contacts that are `used` join, against gravity and `pulls` ([N], [N m] of laws;
/// by body, then by point where some are solid): from rest no step would move it. False, too, where one of `things` is in none of
/// these contacts. Nothing is changed.
bool held_at_rest(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates,
                  const Contacts& contacts, const TouchSettings& settings, const std::vector<char>& used,
                  std::span<const BodyLoad> pulls, std::span<const std::size_t> things);

}  // namespace pantin
