#include "view/view_keys.hpp"

#include "view/keys.hpp"

namespace pantin {

namespace {

void take(const KeyMeaning& key, Views& views, Camera& camera) {
  switch (key.use) {
    case KeyUse::view: views.toggle(static_cast<View>(key.which)); break;
    case KeyUse::see_freely: camera.look_freely(); break;
    case KeyUse::see_front: camera.look_along(Side::front); break;
    case KeyUse::see_right: camera.look_along(Side::right); break;
    case KeyUse::see_top: camera.look_along(Side::top); break;
    default: break;
  }
}

}  // namespace

void take_view_keys(const Gestures& gestures, Views& views, Camera& camera) {
  for (const std::string& key : gestures.keys)
    if (const std::optional<KeyMeaning> meaning = meaning_of(key)) take(*meaning, views, camera);
}

}  // namespace pantin
