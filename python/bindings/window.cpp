#include <memory>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <SDL.h>

#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

using Pixels = nb::ndarray<const std::uint8_t, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

struct WindowFree {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};

/// A window that shows pictures. One thread uses all windows.
class Window {
 public:
  explicit Window(std::string title) : title_(std::move(title)) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Python handles Ctrl-C itself
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) throwError("no window");
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window() {
    window_.reset();
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }

  /// Shows a picture and handles what the user did. @return false once the user has closed the window
  bool show(const Pixels& pixels) {
    const int height = static_cast<int>(pixels.shape(0)), width = static_cast<int>(pixels.shape(1));
    if (closed_) return false;
    if (!window_) {
      window_.reset(
          SDL_CreateWindow(title_.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, 0));
      if (!window_) throwError("no window");
    }
    const std::unique_ptr<SDL_Surface, WindowFree> picture(SDL_CreateRGBSurfaceWithFormatFrom(
        const_cast<std::uint8_t*>(pixels.data()), width, height, 24, 3 * width, SDL_PIXELFORMAT_RGB24));
    SDL_Surface* target = SDL_GetWindowSurface(window_.get());
    if (!picture || target == nullptr || SDL_BlitSurface(picture.get(), nullptr, target, nullptr) != 0 ||
        SDL_UpdateWindowSurface(window_.get()) != 0) {
      throwError("cannot draw in the window");
    }
    SDL_Event event;
    while (SDL_PollEvent(&event) == 1) closed_ = closed_ || event.type == SDL_QUIT;
    if (closed_) window_.reset();
    return !closed_;
  }

 private:
  [[noreturn]] static void throwError(const char* what) {
    raise(ErrorCode::kIo, std::string(what) + ": " + SDL_GetError());
  }

  std::string title_;
  std::unique_ptr<SDL_Window, WindowFree> window_;
  bool closed_ = false;
};

}  // namespace

void bindWindow(nb::module_& m) {
  nb::class_<Window>(m, "Window", "A window that shows pictures, for render_mode \"human\".")
      .def(nb::init<std::string>(), nb::arg("title"))
      .def("show", &Window::show, nb::arg("pixels").noconvert(),
           "Shows uint8 pixels of shape (height, width, 3). Returns False once the user has closed the "
           "window.");
}

}  // namespace fulbito::python
