#pragma once
// For what writes or reads JSON alone: the library's header takes longer to compile than most of the sources.
#include <nlohmann/json.hpp>

#include "fields/value.hpp"

namespace pantin::player {

using Json = nlohmann::ordered_json;

/// Of numbers, truths, texts, vecs and tables of them; null of anything else.
Json json_of(const fields::Value& value);

/// With line breaks. A name that is not UTF-8 does not lose the rest.
std::string text_of(const Json& json);

}  // namespace pantin::player
