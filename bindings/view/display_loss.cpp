#include "view/display_loss.hpp"

#include <SDL.h>
#include <SDL_syswm.h>
#include <dlfcn.h>

namespace pantin {

void note_display_loss(SDL_Window* window, bool& lost) {
#ifdef SDL_VIDEO_DRIVER_X11
  using Note = void (*)(Display*, void*);
  using SetHandler = void (*)(Display*, Note, void*);
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) return;
  // SDL has loaded the library; it has this since 1.7.
  void* library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  using SetErrorHandler = void* (*)(int (*)(Display*, XErrorEvent*));
  using SetIoErrorHandler = void* (*)(int (*)(Display*));
  const auto function = [&](const char* name) { return library ? dlsym(library, name) : nullptr; };
  const auto set_error_handler = reinterpret_cast<SetErrorHandler>(function("XSetErrorHandler"));
  const auto set_io_error_handler = reinterpret_cast<SetIoErrorHandler>(function("XSetIOErrorHandler"));
  const auto set_handler = reinterpret_cast<SetHandler>(function("XSetIOErrorExitHandler"));
  if (set_handler && set_io_error_handler && set_error_handler) {
    set_error_handler([](Display*, XErrorEvent*) { return 0; });  // a server that goes down takes windows away first
    set_io_error_handler([](Display*) { return 0; });
    set_handler(
        info.info.x11.display, [](Display*, void* told) { *static_cast<bool*>(told) = true; }, &lost);
  }
  if (library) dlclose(library);
#else
  (void)window;
  (void)lost;
#endif
}

}  // namespace pantin
