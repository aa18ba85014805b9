#include "apps/view/key_bindings.hpp"

#include <array>

namespace fulbito {
namespace {

struct Binding {
  ViewKey key;
  std::optional<bool> shift;  ///< empty: with or without shift
  ViewAction action;
};

constexpr std::array kBindings{
    Binding{ViewKey::kSpace, {}, ViewAction::kPlay},
    Binding{ViewKey::kK, {}, ViewAction::kPlay},
    Binding{ViewKey::kComma, {}, ViewAction::kFrameBack},
    Binding{ViewKey::kPeriod, {}, ViewAction::kFrameOn},
    Binding{ViewKey::kLeft, false, ViewAction::kSecondBack},
    Binding{ViewKey::kRight, false, ViewAction::kSecondOn},
    Binding{ViewKey::kLeft, true, ViewAction::kTenBack},
    Binding{ViewKey::kRight, true, ViewAction::kTenOn},
    Binding{ViewKey::kHome, {}, ViewAction::kToStart},
    Binding{ViewKey::kEnd, {}, ViewAction::kToEnd},
    Binding{ViewKey::kMinus, {}, ViewAction::kSlower},
    Binding{ViewKey::kPlus, {}, ViewAction::kFaster},
    Binding{ViewKey::kP, {}, ViewAction::kEventBack},
    Binding{ViewKey::kN, {}, ViewAction::kEventOn},
    Binding{ViewKey::kPageUp, {}, ViewAction::kFileBack},
    Binding{ViewKey::kPageDown, {}, ViewAction::kFileOn},
    Binding{ViewKey::kT, {}, ViewAction::kTrails},
    Binding{ViewKey::kO, {}, ViewAction::kDrawings},
    Binding{ViewKey::kF, {}, ViewAction::kFlip},
    Binding{ViewKey::kD, {}, ViewAction::kTheme},
    Binding{ViewKey::kF11, {}, ViewAction::kFullScreen},
    Binding{ViewKey::kS, {}, ViewAction::kSave},
    Binding{ViewKey::kH, {}, ViewAction::kHelp},
    Binding{ViewKey::kF1, {}, ViewAction::kHelp},
    Binding{ViewKey::kQuestion, {}, ViewAction::kHelp},
    Binding{ViewKey::kQ, {}, ViewAction::kQuit},
    Binding{ViewKey::kEscape, {}, ViewAction::kQuit},
};

constexpr std::array kHelp{
    KeyHelp{"Space, K", "play or pause"},
    KeyHelp{",  .", "one frame back, forward", true, false},
    KeyHelp{".", "one tick forward", false, true},
    KeyHelp{"Left, Right", "1 s back, forward (Shift: 10 s)", true, false},
    KeyHelp{"Right", "1 s forward (Shift: 10 s)", false, true},
    KeyHelp{"Home, End", "to the start, to the end", true, false},
    KeyHelp{"P, N", "previous, next event", true, false},
    KeyHelp{"PgUp, PgDn", "previous, next file", true, false},
    KeyHelp{"-  +", "slower, faster"},
    KeyHelp{"T", "trails"},
    KeyHelp{"O", "drawings of the teams"},
    KeyHelp{"F", "flip sides"},
    KeyHelp{"D", "dark or light theme"},
    KeyHelp{"F11", "full screen"},
    KeyHelp{"S", "save the picture as PNG"},
    KeyHelp{"H, ?", "this list"},
    KeyHelp{"Q, Esc", "close this list, or quit"},
    KeyHelp{"Time bar", "click or drag to seek", true, false},
    KeyHelp{"Left drag", "move the ball or a robot", false, true},
    KeyHelp{"Right drag", "turn a robot (or wheel)", false, true},
};

}  // namespace

std::optional<ViewAction> actionOf(KeyPress press) {
  for (const Binding& binding : kBindings) {
    if (binding.key == press.key && binding.shift.value_or(press.shift) == press.shift) return binding.action;
  }
  return std::nullopt;
}

std::span<const KeyHelp> keyHelp() { return kHelp; }

}  // namespace fulbito
