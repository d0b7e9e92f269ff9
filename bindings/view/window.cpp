#include "view/window.hpp"

#include <SDL.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "view/display_loss.hpp"
#include "view/gamepads.hpp"
#include "view/renderer.hpp"

namespace pantin {

namespace {

using Kind = PointerEvent::Kind;
using Button = PointerEvent::Button;

Button button_of(Uint8 button) {
  return button == SDL_BUTTON_LEFT     ? Button::left
         : button == SDL_BUTTON_MIDDLE ? Button::middle
         : button == SDL_BUTTON_RIGHT  ? Button::right
                                       : Button::none;
}

std::string key_name(SDL_Keycode key) {
  std::string name = SDL_GetKeyName(key);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name;
}

bool start_video() {
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
  return SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
}

/// SDL takes a driver that shows nothing where it finds no other.
bool driver_is_seen() {
  const char* name = SDL_GetCurrentVideoDriver();
  const std::string_view driver = name ? name : "";
  return driver != "offscreen" && driver != "dummy" && driver != "evdev" && !driver.empty();
}

void set_button(Pointer& pointer, Button button, bool down) {
  if (button == Button::left) pointer.left = down;
  if (button == Button::middle) pointer.middle = down;
  if (button == Button::right) pointer.right = down;
}

}  // namespace

struct Window::Parts {
  SDL_Window* window = nullptr;
  SDL_GLContext context = nullptr;
  int width = 0, height = 0;             // [px] in which SDL tells where the pointer is
  int pixels_wide = 0, pixels_high = 0;  // of the drawable
  std::map<PointerId, Pointer> pointers;
  std::vector<std::string> held;
  std::map<std::pair<SDL_TouchID, SDL_FingerID>, PointerId> fingers;
  PointerId next_finger = 1;
  std::optional<Gamepads> gamepads;
  bool shift = false, control = false, closed = false, lost = false;

  ~Parts() {
    gamepads.reset();
    if (context) SDL_GL_DeleteContext(context);
    if (window) SDL_DestroyWindow(window);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }
  void measure() {
    SDL_GetWindowSize(window, &width, &height);
    SDL_GL_GetDrawableSize(window, &pixels_wide, &pixels_high);
  }
  void take(const SDL_Event& event, Gestures& gestures);
  void take_mouse(const SDL_Event& event, Gestures& gestures);
  void take_finger(const SDL_TouchFingerEvent& event, Gestures& gestures);
  void take_key(const SDL_KeyboardEvent& event, Gestures& gestures);
  void tell(Gestures& gestures, PointerEvent event, double x, double y);
  void let_go(Gestures& gestures);
};

Window::Window(const std::string& title, int width, int height, bool hidden) : parts_(std::make_unique<Parts>()) {
  require(width > 0 && height > 0, "a window's size must be > 0 pixels, got ", width, " x ", height);
  if (hidden) SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
  require(start_video(), "no window can be opened: ", SDL_GetError());
  const char* asked_for = SDL_GetHint(SDL_HINT_VIDEODRIVER);
  require(driver_is_seen() || (asked_for && *asked_for), "no window can be opened: there is no display");
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  const Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI |
                       static_cast<Uint32>(hidden ? SDL_WINDOW_HIDDEN : SDL_WINDOW_SHOWN);
  Parts& p = *parts_;
  p.window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, flags);
  require(p.window != nullptr, "no window can be opened: ", SDL_GetError());
  if (!hidden) SDL_SetWindowMinimumSize(p.window, 480, 320);
  p.context = SDL_GL_CreateContext(p.window);
  require(p.context != nullptr, "OpenGL 3.3 is not to be had here: ", SDL_GetError());
  if (!hidden) SDL_GL_SetSwapInterval(1);
  note_display_loss(p.window, p.lost);
  p.measure();
  p.gamepads.emplace();
}

Window::~Window() = default;

int Window::width() const { return parts_->width; }
int Window::height() const { return parts_->height; }
double Window::scale() const {
  return parts_->width > 0 && parts_->pixels_wide > 0 ? static_cast<double>(parts_->pixels_wide) / parts_->width : 1.0;
}
void Window::toggle_fullscreen() {
  const bool full = (SDL_GetWindowFlags(parts_->window) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
  SDL_SetWindowFullscreen(parts_->window, full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(parts_->window, title.c_str()); }

bool Window::software() const {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name ? name : "";
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

Display::Display() : open_(start_video()) {}

Display::~Display() {
  if (open_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

bool Display::seen() const { return open_ && driver_is_seen(); }

bool Window::lost() const { return parts_->lost; }

void Window::present(Renderer& renderer) {
  if (parts_->lost) return;
  SDL_GL_MakeCurrent(parts_->window, parts_->context);
  renderer.show(parts_->pixels_wide, parts_->pixels_high);
  SDL_GL_SwapWindow(parts_->window);
}

bool Window::poll(Gestures& gestures) {
  Parts& p = *parts_;
  gestures.events.clear();
  gestures.keys.clear();
  gestures.notes.clear();
  gestures.text.clear();
  gestures.resized = false;
  SDL_Event event;
  while (SDL_PollEvent(&event)) p.take(event, gestures);
  gestures.pointers = p.pointers;
  gestures.held = p.held;
  gestures.sticks = p.gamepads->sticks();
  gestures.pad = p.gamepads->held();
  gestures.shift = p.shift;
  gestures.control = p.control;
  gestures.width = p.width;
  gestures.height = p.height;
  gestures.quit = p.closed || p.lost;
  return !gestures.quit;
}

void Window::Parts::take(const SDL_Event& event, Gestures& gestures) {
  switch (event.type) {
    case SDL_QUIT: closed = true; break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
        measure();
        gestures.resized = true;
      }
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) let_go(gestures);
      if (event.window.event == SDL_WINDOWEVENT_CLOSE) closed = true;
      break;
    case SDL_MOUSEMOTION:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEWHEEL:
      if (event.motion.which != SDL_TOUCH_MOUSEID) take_mouse(event, gestures);
      break;
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP: take_finger(event.tfinger, gestures); break;
    case SDL_KEYDOWN:
    case SDL_KEYUP: take_key(event.key, gestures); break;
    case SDL_TEXTINPUT: gestures.text += event.text.text; break;
    default: gamepads->take(event, gestures); break;
  }
}

/// The window is no longer listened to: who holds something would hold it for ever.
void Window::Parts::let_go(Gestures& gestures) {
  for (const auto& [id, pointer] : std::map(pointers)) {
    PointerEvent event;
    event.kind = Kind::release;
    event.pointer = id;
    for (const auto& [button, down] :
         {std::pair{Button::left, pointer.left}, {Button::middle, pointer.middle}, {Button::right, pointer.right}})
      if (event.button = button; down) tell(gestures, event, pointer.x, pointer.y);
    if (id != 0) pointers.erase(id);
  }
  fingers.clear();
  held.clear();
  next_finger = 1;
  shift = control = false;
}

void Window::Parts::tell(Gestures& gestures, PointerEvent event, double x, double y) {
  Pointer& pointer = pointers[event.pointer];
  event.dx = event.kind == Kind::move ? x - pointer.x : event.dx;
  event.dy = event.kind == Kind::move ? y - pointer.y : event.dy;
  event.x = pointer.x = x;
  event.y = pointer.y = y;
  if (event.kind == Kind::press || event.kind == Kind::release)
    set_button(pointer, event.button, event.kind == Kind::press);
  event.shift = shift;
  event.control = control;
  event.keys = gestures.keys.size();
  gestures.events.push_back(event);
}

void Window::Parts::take_mouse(const SDL_Event& event, Gestures& gestures) {
  PointerEvent out;
  if (event.type == SDL_MOUSEMOTION) {
    tell(gestures, out, event.motion.x, event.motion.y);
  } else if (event.type == SDL_MOUSEWHEEL) {
    out.kind = Kind::wheel;
    const double sign = event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0 : 1.0;
    out.dx = sign * static_cast<double>(event.wheel.preciseX);
    out.dy = sign * static_cast<double>(event.wheel.preciseY);
    if (event.wheel.preciseX == 0.0f && event.wheel.preciseY == 0.0f) {  // of a pushed event
      out.dx = sign * event.wheel.x;
      out.dy = sign * event.wheel.y;
    }
    tell(gestures, out, pointers[0].x, pointers[0].y);
  } else {
    out.kind = event.type == SDL_MOUSEBUTTONDOWN ? Kind::press : Kind::release;
    out.button = button_of(event.button.button);
    out.clicks = std::max(1, static_cast<int>(event.button.clicks));
    if (out.button != Button::none) tell(gestures, out, event.button.x, event.button.y);
  }
}

void Window::Parts::take_finger(const SDL_TouchFingerEvent& event, Gestures& gestures) {
  const auto key = std::pair{event.touchId, event.fingerId};
  const auto found = fingers.find(key);
  if (found == fingers.end() && event.type != SDL_FINGERDOWN) return;
  PointerEvent out;
  out.pointer = found != fingers.end() ? found->second : (fingers[key] = next_finger++);
  const double x = static_cast<double>(event.x) * width, y = static_cast<double>(event.y) * height;
  if (event.type != SDL_FINGERMOTION) {
    out.kind = event.type == SDL_FINGERDOWN ? Kind::press : Kind::release;
    out.button = Button::left;
  }
  tell(gestures, out, x, y);
  if (event.type != SDL_FINGERUP) return;
  pointers.erase(out.pointer);
  fingers.erase(key);
  if (fingers.empty()) next_finger = 1;
}

void Window::Parts::take_key(const SDL_KeyboardEvent& event, Gestures& gestures) {
  const SDL_Keycode key = event.keysym.sym;
  const bool down = event.type == SDL_KEYDOWN;
  const std::string modifiers = control ? shift ? "ctrl+shift+" : "ctrl+" : "";
  if (key == SDLK_LSHIFT || key == SDLK_RSHIFT) shift = down;
  if (key == SDLK_LCTRL || key == SDLK_RCTRL) control = down;
  const std::string name = key_name(key);
  std::erase(held, name);
  if (down) held.push_back(name);
  if (down && (event.repeat == 0 || key == SDLK_PERIOD)) gestures.keys.push_back(modifiers + name);
}

}  // namespace pantin
