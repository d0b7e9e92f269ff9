#pragma once
// Edges and faces of shapes that lie flush.
#include <vector>

#include "contacts/find.hpp"

namespace pantin {

/// Leaves out contacts with faces and edges of a shape that another one of its body, or of the world, covers: what touches there
/// would have met that one first.
void drop_hidden(const ThingsNow& where, const ContactFinder& finder, std::vector<Contact>& list);

}  // namespace pantin
