#include "apps/view/view_window.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <SDL.h>
#include <fmt/format.h>

#include "apps/view/view_screen.hpp"

namespace fulbito {
namespace {

constexpr int kWidth = 900;                           // [px]
constexpr int kLeastWidth = 320, kLeastHeight = 240;  // [px]
constexpr std::int64_t kFrame = 1'000'000'000 / 60;   // [ns]
constexpr std::int64_t kLook = 100'000'000;           // [ns] between checks of conditions that send no event
constexpr double kRoom = 0.9;                         // largest share of the display for a new window

struct WindowFree {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
};

struct SurfaceFree {
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};

Error sdlError(const std::string& what) {
  return {ErrorCode::kIo, fmt::format("{}: {}", what, SDL_GetError())};
}

bool isSet(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

/// Whether SDL fell back to an invisible window although none was requested.
bool invisible() {
  if (isSet("SDL_VIDEODRIVER")) return false;
  const char* driver = SDL_GetCurrentVideoDriver();
  const std::string_view name = driver != nullptr ? driver : "";
  return name == "offscreen" || name == "dummy" || name == "evdev";
}

Error noDisplay() {
  std::string why = "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)";
  if (isSet("DISPLAY")) why = fmt::format("the display '{}' cannot be used", std::getenv("DISPLAY"));
  if (isSet("WAYLAND_DISPLAY")) {
    why = fmt::format("the display '{}' cannot be used", std::getenv("WAYLAND_DISPLAY"));
  }
  if (isSet("SDL_VIDEODRIVER")) why = SDL_GetError();
  return {ErrorCode::kIo,
          fmt::format("cannot open a window: {}. fulbito replay export makes pictures and films without one.",
                      why)};
}

struct KeyName {
  SDL_Keycode code;
  ViewKey key;
};

constexpr std::array kKeys{
    KeyName{SDLK_SPACE, ViewKey::kSpace},
    KeyName{SDLK_COMMA, ViewKey::kComma},
    KeyName{SDLK_PERIOD, ViewKey::kPeriod},
    KeyName{SDLK_LEFT, ViewKey::kLeft},
    KeyName{SDLK_RIGHT, ViewKey::kRight},
    KeyName{SDLK_HOME, ViewKey::kHome},
    KeyName{SDLK_END, ViewKey::kEnd},
    KeyName{SDLK_PAGEUP, ViewKey::kPageUp},
    KeyName{SDLK_PAGEDOWN, ViewKey::kPageDown},
    KeyName{SDLK_MINUS, ViewKey::kMinus},
    KeyName{SDLK_KP_MINUS, ViewKey::kMinus},
    KeyName{SDLK_PLUS, ViewKey::kPlus},
    KeyName{SDLK_EQUALS, ViewKey::kPlus},
    KeyName{SDLK_KP_PLUS, ViewKey::kPlus},
    KeyName{SDLK_QUESTION, ViewKey::kQuestion},
    KeyName{SDLK_F1, ViewKey::kF1},
    KeyName{SDLK_F11, ViewKey::kF11},
    KeyName{SDLK_ESCAPE, ViewKey::kEscape},
    KeyName{SDLK_d, ViewKey::kD},
    KeyName{SDLK_f, ViewKey::kF},
    KeyName{SDLK_h, ViewKey::kH},
    KeyName{SDLK_k, ViewKey::kK},
    KeyName{SDLK_n, ViewKey::kN},
    KeyName{SDLK_o, ViewKey::kO},
    KeyName{SDLK_p, ViewKey::kP},
    KeyName{SDLK_q, ViewKey::kQ},
    KeyName{SDLK_s, ViewKey::kS},
    KeyName{SDLK_t, ViewKey::kT},
};

std::optional<KeyPress> keyOf(const SDL_Keysym& symbol) {
  if ((symbol.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0) return std::nullopt;
  const bool shift = (symbol.mod & KMOD_SHIFT) != 0;
  if (symbol.sym == SDLK_SLASH && shift) return KeyPress{ViewKey::kQuestion, true};
  const auto* const found = std::find_if(kKeys.begin(), kKeys.end(),
                                         [&symbol](const KeyName& name) { return name.code == symbol.sym; });
  if (found == kKeys.end()) return std::nullopt;
  return KeyPress{found->key, shift};
}

/// A file name that does not exist yet: "libero-classic-12.3s.png", then with "-2" and so on.
std::string freeName(const Viewer& viewer) {
  std::string stem = std::filesystem::path(viewer.stage().name()).stem().string();
  const std::string base =
      fmt::format("{}-{:.1f}s", stem.empty() ? "fulbito" : stem, viewer.stage().seconds());
  std::string name = base + ".png";
  for (int i = 2; std::filesystem::exists(name); ++i) name = fmt::format("{}-{}.png", base, i);
  return name;
}

}  // namespace

struct ViewWindow::Impl {
  explicit Impl(const WindowOptions& from) : options(from) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    window.reset();
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }

  Result<void> open(const FieldGeometry& field);
  Result<void> draw(Viewer& viewer);
  Result<void> present();
  void take(const SDL_Event& event, Viewer& viewer);
  void takePointer(const SDL_Event& event, Viewer& viewer) const;
  void takeAll(Viewer& viewer, std::int64_t wait);
  void follow(Viewer& viewer);
  void save(Viewer& viewer) const;
  bool ends(const Viewer& viewer) const;

  WindowOptions options;
  std::unique_ptr<SDL_Window, WindowFree> window;
  ViewScreen screen;
  std::string title;
  std::int64_t frames = 0;
  bool full_screen = false;
  bool closed = false;
};

ViewWindow::ViewWindow(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ViewWindow::ViewWindow(ViewWindow&&) noexcept = default;
ViewWindow& ViewWindow::operator=(ViewWindow&&) noexcept = default;
ViewWindow::~ViewWindow() = default;

bool ViewWindow::available() { return true; }

Result<ViewWindow> ViewWindow::create(const WindowOptions& options) {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // the program handles Ctrl-C itself
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  // Without a display, SDL would try its other drivers and print an error for each. A console screen must be
  // requested.
  if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY") && !isSet("SDL_VIDEODRIVER")) {
    return tl::unexpected<Error>(noDisplay());
  }
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return tl::unexpected<Error>(noDisplay());
  if (invisible()) {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return tl::unexpected<Error>(noDisplay());
  }
  return ViewWindow(std::make_unique<Impl>(options));
}

Result<void> ViewWindow::Impl::open(const FieldGeometry& field) {
  int width = options.width > 0 ? options.width : kWidth;
  int height = options.height > 0 ? options.height : matchPictureHeight(field, width);
  SDL_Rect room;
  if (options.width == 0 && SDL_GetDisplayUsableBounds(0, &room) == 0 && room.h > 0) {
    const double most =
        kRoom * std::min(static_cast<double>(room.w) / width, static_cast<double>(room.h) / height);
    if (most < 1.0) {
      width = std::max(kLeastWidth, static_cast<int>(width * most));
      height = std::max(kLeastHeight, static_cast<int>(height * most));
    }
  }
  window.reset(SDL_CreateWindow("fulbito", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
  if (!window) return tl::unexpected<Error>(sdlError("cannot open a window"));
  SDL_SetWindowMinimumSize(window.get(), kLeastWidth, kLeastHeight);
  return {};
}

/// Copies the picture to the window.
Result<void> ViewWindow::Impl::present() {
  SDL_Surface* target = SDL_GetWindowSurface(window.get());
  if (target == nullptr) return tl::unexpected<Error>(sdlError("cannot draw in the window"));
  const Canvas& canvas = *screen.canvas();
  // SDL only reads the pixels, although its parameter is not const.
  auto* pixels = const_cast<std::uint32_t*>(canvas.row(0).data());
  const std::ptrdiff_t pitch = canvas.height() > 1 ? 4 * (canvas.row(1).data() - canvas.row(0).data())
                                                   : 4 * static_cast<std::ptrdiff_t>(canvas.width());
  const std::unique_ptr<SDL_Surface, SurfaceFree> source(SDL_CreateRGBSurfaceWithFormatFrom(
      pixels, canvas.width(), canvas.height(), 32, static_cast<int>(pitch), SDL_PIXELFORMAT_RGB888));
  if (!source || SDL_BlitSurface(source.get(), nullptr, target, nullptr) != 0 ||
      SDL_UpdateWindowSurface(window.get()) != 0) {
    return tl::unexpected<Error>(sdlError("cannot draw in the window"));
  }
  return {};
}

Result<void> ViewWindow::Impl::draw(Viewer& viewer) {
  SDL_Surface* target = SDL_GetWindowSurface(window.get());
  if (target == nullptr) return tl::unexpected<Error>(sdlError("cannot draw in the window"));
  if (auto drawn = screen.draw(viewer, target->w, target->h); !drawn) return drawn;
  ++frames;
  if (std::string now = viewer.title(); now != title) {
    title = std::move(now);
    SDL_SetWindowTitle(window.get(), title.c_str());
  }
  return present();
}

void ViewWindow::Impl::takePointer(const SDL_Event& event, Viewer& viewer) const {
  PointerEvent pointer;
  int x = 0, y = 0;
  if (event.type == SDL_MOUSEMOTION) {
    pointer.kind = PointerEvent::Kind::kMove;
    x = event.motion.x, y = event.motion.y;
  } else if (event.type == SDL_MOUSEWHEEL) {
    pointer.kind = PointerEvent::Kind::kWheel;
    pointer.wheel = event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.wheel.y : event.wheel.y;
    SDL_GetMouseState(&x, &y);
  } else {
    if (event.button.button != SDL_BUTTON_LEFT && event.button.button != SDL_BUTTON_RIGHT) return;
    const bool down = event.type == SDL_MOUSEBUTTONDOWN;
    pointer.kind = down ? PointerEvent::Kind::kDown : PointerEvent::Kind::kUp;
    pointer.right = event.button.button == SDL_BUTTON_RIGHT;
    x = event.button.x, y = event.button.y;
    SDL_CaptureMouse(down ? SDL_TRUE : SDL_FALSE);
  }
  // The mouse reports desktop points; a high-resolution display has several pixels per point.
  int width = 0, height = 0;
  SDL_GetWindowSize(window.get(), &width, &height);
  const Canvas* canvas = screen.canvas();
  if (canvas == nullptr || width < 1 || height < 1) return;
  screen.aim(pointer, {static_cast<double>(x) * canvas->width() / width,
                       static_cast<double>(y) * canvas->height() / height});
  viewer.point(pointer);
}

void ViewWindow::Impl::take(const SDL_Event& event, Viewer& viewer) {
  switch (event.type) {
    case SDL_QUIT:
      closed = true;
      break;
    case SDL_KEYDOWN:
      if (const auto key = keyOf(event.key.keysym)) viewer.press(*key);
      break;
    case SDL_WINDOWEVENT:
      viewer.spoil();
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEMOTION:
    case SDL_MOUSEWHEEL:
      takePointer(event, viewer);
      break;
    default:
      break;
  }
}

/// Handles all pending events; waits for the first one for at most this long [ns]. Does not use
/// SDL_WaitEvent: on X11 it messages the window over a second connection, which ends the program with
/// BadWindow if the window is already gone.
void ViewWindow::Impl::takeAll(Viewer& viewer, std::int64_t wait) {
  constexpr std::int64_t kLook = 4;  // [ms] between checks
  SDL_Event event;
  bool there = SDL_PollEvent(&event) == 1;
  for (std::int64_t left = (wait + 999'999) / 1'000'000; !there && left > 0; left -= kLook) {
    SDL_Delay(static_cast<Uint32>(std::min(left, kLook)));
    there = SDL_PollEvent(&event) == 1;
  }
  for (; there && !closed; there = SDL_PollEvent(&event) == 1) take(event, viewer);
}

/// Carries out the viewer's requests to its window.
void ViewWindow::Impl::follow(Viewer& viewer) {
  if (viewer.settings().full_screen != full_screen) {
    full_screen = viewer.settings().full_screen;
    SDL_SetWindowFullscreen(window.get(), full_screen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    viewer.spoil();
  }
  if (viewer.takeSave()) save(viewer);
}

void ViewWindow::Impl::save(Viewer& viewer) const {
  const std::string name = freeName(viewer);
  const auto written = screen.save(viewer, name);
  viewer.notify(written ? "saved " + name : written.error().message);
}

bool ViewWindow::Impl::ends(const Viewer& viewer) const {
  const bool still = frames > 0 && !viewer.stale() && !viewer.moving();
  return closed || viewer.quits() || (options.frames > 0 && (frames >= options.frames || still)) ||
         (options.interrupted && options.interrupted());
}

Result<void> ViewWindow::run(Viewer& viewer) {
  Impl& w = *impl_;
  if (auto opened = w.open(viewer.stage().look().field); !opened) return opened;
  std::int64_t due = w.options.now();
  while (!w.ends(viewer)) {
    const std::int64_t now = w.options.now();
    w.takeAll(viewer, viewer.stale() || viewer.moving() ? std::max<std::int64_t>(0, due - now) : kLook);
    w.follow(viewer);
    const std::int64_t then = w.options.now();
    if (then < due) continue;
    viewer.advance(then);
    if (!viewer.stale()) continue;
    // After a late frame, the next ones keep their distance instead of catching up.
    due = std::max(due + kFrame, then);
    if (auto drawn = w.draw(viewer); !drawn) return drawn;
  }
  if (w.options.screenshot.empty()) return {};
  if (w.screen.canvas() == nullptr) {
    if (auto drawn = w.draw(viewer); !drawn) return drawn;
  }
  return w.screen.canvas()->writePng(w.options.screenshot);
}

std::int64_t ViewWindow::frames() const { return impl_->frames; }

}  // namespace fulbito
