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
  using SetErrorHandler = int (*(*)(int (*)(Display*)))(Display*);
  const auto set_error_handler =
      library ? reinterpret_cast<SetErrorHandler>(dlsym(library, "XSetIOErrorHandler")) : nullptr;
  const auto set_handler = library ? reinterpret_cast<SetHandler>(dlsym(library, "XSetIOErrorExitHandler")) : nullptr;
  if (set_handler && set_error_handler) {
    set_error_handler([](Display*) { return 0; });
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
