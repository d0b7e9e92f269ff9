#pragma once
// Contacts of what sleeps: in lists of their own, which no pass reads.
#include "articulates/articulate.hpp"
#include "contacts/contact.hpp"
#include "contacts/passes.hpp"
#include "model/model.hpp"

namespace pantin {

/// Call where something fell asleep or woke, `sleepers` being right: puts contacts in the lists where they belong, and finds
/// the sums over what sleeps.
void sort_resting(const Model& model, const Articulates& articulates, Contacts& contacts);

}  // namespace pantin
