// Fingers: one is the pointer, two move the view, and panels hear of them.
#include "view/fingers.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "window/played_chain.hpp"

using namespace pantin;

namespace {

using Kind = PointerEvent::Kind;
using Button = PointerEvent::Button;

constexpr int width = 960, height = 540;

/// Fingers over a picture in which there is a thing left of x = 100.
struct Touched {
  Fingers fingers;
  Gestures gestures;
  Camera camera;
  bool draws = false;

  void tell(Kind kind, PointerId id, double x, double y) {
    PointerEvent event;
    event.kind = kind;
    event.button = kind == Kind::move ? Button::none : Button::left;
    event.pointer = id;
    event.dx = x - gestures.pointers[id].x;
    event.dy = y - gestures.pointers[id].y;
    event.x = x;
    event.y = y;
    gestures.pointers[id] = {x, y, kind != Kind::release, false, false};
    if (kind == Kind::release) gestures.pointers.erase(id);
    gestures.events.push_back(event);
  }
  /// What is left for others.
  Gestures frame(double time = 0.016) {
    Gestures left = gestures;
    fingers.take(left, {time, [](double x, double) { return x < 100.0; }, draws, width, height, camera});
    gestures.events.clear();
    return left;
  }
};

}  // namespace

TEST_CASE("fingers: two that hold nothing zoom and shift, and what is between them stays there", "[view]") {
  Touched touched;
  touched.tell(Kind::press, 1, 400, 300);
  CHECK(touched.frame().events.size() == 1);
  touched.tell(Kind::press, 2, 500, 300);
  Gestures left = touched.frame();
  CHECK(left.events.empty());
  CHECK(left.pointers.empty());  // hands let go
  const Camera before = touched.camera;
  const Vec3 middle = before.place(450, 300, before.distance, width, height);
  touched.tell(Kind::move, 1, 350, 300);
  touched.tell(Kind::move, 2, 550, 300);
  touched.frame();
  CHECK(touched.camera.distance == Approx(0.5 * before.distance));
  CHECK(touched.camera.yaw == before.yaw);
  const Camera near = touched.camera;
  CHECK(norm(near.place(450, 300, near.distance, width, height) - middle) < 1e-9 * before.distance);
  touched.tell(Kind::move, 1, 350, 350);
  touched.tell(Kind::move, 2, 550, 350);
  touched.frame();
  CHECK(touched.camera.distance == Approx(near.distance));
  CHECK(norm(touched.camera.place(450, 350, near.distance, width, height) - middle) < 1e-6 * before.distance);
  touched.tell(Kind::release, 2, 550, 350);
  touched.tell(Kind::move, 1, 300, 300);
  left = touched.frame();
  CHECK(left.events.empty());  // the other one is nobody's until it goes up
  CHECK(left.pointers.empty());
  touched.tell(Kind::release, 1, 300, 300);
  touched.frame();
  touched.tell(Kind::press, 1, 300, 300);
  CHECK(touched.frame().events.size() == 1);
}

TEST_CASE("fingers: a twist turns the view, a slight one does not", "[view]") {
  Touched touched;
  touched.tell(Kind::press, 1, 400, 300);
  touched.tell(Kind::press, 2, 600, 300);
  touched.frame();
  const double yaw = touched.camera.yaw;
  const auto twist = [&](double angle) {
    touched.tell(Kind::move, 1, 500 - 100 * std::cos(angle), 300 - 100 * std::sin(angle));
    touched.tell(Kind::move, 2, 500 + 100 * std::cos(angle), 300 + 100 * std::sin(angle));
    touched.frame();
  };
  twist(0.2);
  CHECK(touched.camera.yaw == yaw);
  for (int i = 1; i <= 8; i++) twist(0.2 + 0.1 * i);
  CHECK(std::fabs(touched.camera.yaw - yaw) > 0.5);
}

TEST_CASE("fingers: two that hold things are hands, and so is a second that comes while one drags", "[view]") {
  Touched touched;
  touched.tell(Kind::press, 1, 50, 300);
  touched.tell(Kind::press, 2, 80, 400);
  Gestures left = touched.frame();
  CHECK(left.events.size() == 2);
  CHECK(left.pointers.size() == 2);
  touched.tell(Kind::release, 2, 80, 400);
  touched.frame();
  touched.tell(Kind::move, 1, 300, 300);
  touched.frame(1.0);
  touched.tell(Kind::press, 2, 500, 400);
  left = touched.frame();
  CHECK(left.events.size() == 1);
  CHECK(left.pointers.at(1).left);
}

TEST_CASE("fingers: one that rests beside all is the right button, and a double tap a double click", "[view]") {
  Touched touched;
  touched.tell(Kind::press, 1, 400, 300);
  touched.frame();
  for (int i = 0; i < 40; i++) touched.frame();
  const Gestures resting = touched.frame();
  CHECK(resting.pointers.at(1).right);
  CHECK_FALSE(resting.pointers.at(1).left);
  touched.tell(Kind::release, 1, 400, 300);
  CHECK(touched.frame().events.at(0).button == Button::right);

  touched.tell(Kind::press, 1, 50, 300);  // upon a thing
  for (int i = 0; i < 40; i++) touched.frame();
  CHECK(touched.frame().pointers.at(1).left);
  touched.tell(Kind::release, 1, 50, 300);
  touched.frame();

  touched.draws = true;
  touched.tell(Kind::press, 1, 400, 300);
  for (int i = 0; i < 40; i++) touched.frame();
  CHECK(touched.frame().pointers.at(1).left);
  touched.tell(Kind::release, 1, 400, 300);
  touched.frame();
  touched.frame(1.0);

  touched.tell(Kind::press, 1, 400, 300);
  CHECK(touched.frame().events.at(0).clicks == 1);
  touched.tell(Kind::release, 1, 400, 300);
  touched.tell(Kind::press, 1, 405, 300);
  CHECK(touched.frame().events.at(1).clicks == 2);
}

namespace {

/// What the mouse points at, which is pushed once, tells of the camera.
struct Seen : PlayedChain {
  explicit Seen(const std::string& more = "")
      : PlayedChain(PlayedChain::text() + R"(
          scene:on("step", function()
            local at = scene.mouse.position
            if at then scene:result("x", at.x) scene:result("z", at.z) end
          end))" + more,
                    5.0, {width, height}) {
    pushed::move(880, 270);
    frames(3);
  }
  void finger(Uint32 type, SDL_FingerID id, double x, double y) {
    pushed::finger(type, id, x / width, y / height);
    frames(2);
  }
};

}  // namespace

TEST_CASE("fingers: in the window two zoom, and one that rested turns the view", "[window]") {
  Seen seen;
  const double x = seen.result("x") - 3.0;
  CHECK(x > 1.0);
  CHECK(seen.result("z") == Approx(0.0).margin(1e-9));
  seen.finger(SDL_FINGERDOWN, 1, 700, 400);
  seen.finger(SDL_FINGERDOWN, 2, 780, 400);
  seen.finger(SDL_FINGERMOTION, 1, 660, 400);
  seen.finger(SDL_FINGERMOTION, 2, 820, 400);
  seen.finger(SDL_FINGERUP, 1, 660, 400);
  seen.finger(SDL_FINGERUP, 2, 820, 400);
  CHECK(seen.result("x") - 3.0 == Approx(0.825 * x).margin(0.01 * x));  // 740 px stay where they are
  CHECK(seen.result("z") == Approx(0.0).margin(1e-9));
  seen.finger(SDL_FINGERDOWN, 1, 740, 400);
  for (int i = 0; i < 200 && seen.player->told() != "the finger turns the view"; i++) seen.frames(1);
  CHECK(seen.player->told() == "the finger turns the view");
  seen.finger(SDL_FINGERMOTION, 1, 860, 400);
  seen.finger(SDL_FINGERUP, 1, 860, 400);
  CHECK(std::fabs(seen.result("z")) > 0.1);
  CHECK(seen.world().log.empty());
}

TEST_CASE("fingers: one that drags is a hand, and what SDL makes of it is not heard twice", "[window]") {
  Seen seen("scene.gravity = vec(0, 0, 0)");  // it stays there however long a frame takes
  const Projected tail = seen.seen(vec(5.9, 4, 0));
  seen.finger(SDL_FINGERDOWN, 1, tail.x, tail.y);
  SDL_Event event = {};
  event.type = SDL_MOUSEBUTTONDOWN;
  event.button.which = SDL_TOUCH_MOUSEID;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = static_cast<Sint32>(tail.x);
  event.button.y = static_cast<Sint32>(tail.y);
  SDL_PushEvent(&event);
  seen.frames(3);
  const auto holds = [&] {
    return std::ranges::count_if(seen.world().hands, [](const Hand& hand) { return static_cast<bool>(hand.grab); });
  };
  CHECK(holds() == 1);
  seen.finger(SDL_FINGERMOTION, 1, tail.x - 60, tail.y + 60);
  CHECK(holds() == 1);
  seen.finger(SDL_FINGERUP, 1, tail.x - 60, tail.y + 60);
  CHECK(holds() == 0);
}

TEST_CASE("fingers: a tap presses a button of the scene, however short", "[window]") {
  Seen seen(R"(local n = 0 scene:button("kick", function() n = n + 1 scene:result("pressed", n) end))");
  constexpr double x = 40, y = 53;
  seen.finger(SDL_FINGERDOWN, 1, x, y);
  seen.finger(SDL_FINGERUP, 1, x, y);
  seen.frames(3);
  CHECK(seen.result("pressed") == 1.0);
  pushed::finger(SDL_FINGERDOWN, 1, x / width, y / height);
  pushed::finger(SDL_FINGERUP, 1, x / width, y / height);
  seen.frames(5);
  CHECK(seen.result("pressed") == 2.0);
  CHECK(seen.world().hands.size() <= 1);
}

TEST_CASE("fingers: a drag scrolls the browser and opens nothing, a tap opens", "[window]") {
  const auto opened = [](bool scrolled) {
    Played played("");
    const auto finger = [&](Uint32 type, double x, double y) {
      pushed::finger(type, 1, x / 640, y / 360);
      played.frames(2);
    };
    for (int drag = 0; scrolled && drag < 3; drag++) {
      finger(SDL_FINGERDOWN, 150, 300);
      for (int i = 1; i <= 12; i++) finger(SDL_FINGERMOTION, 150, 300 - 20 * i);
      finger(SDL_FINGERUP, 150, 60);
      played.frames(3);
      CHECK(played.player->browsing());
    }
    finger(SDL_FINGERDOWN, 150, 150);
    finger(SDL_FINGERUP, 150, 150);
    played.frames(3);
    CHECK_FALSE(played.player->browsing());
    return played.player->scene().title();
  };
  CHECK(opened(false) != opened(true));
}
