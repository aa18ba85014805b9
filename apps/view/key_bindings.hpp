#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace fulbito {

/// A key that the viewer uses.
enum class ViewKey : std::uint8_t {
  kSpace,
  kComma,
  kPeriod,
  kLeft,
  kRight,
  kHome,
  kEnd,
  kPageUp,
  kPageDown,
  kMinus,
  kPlus,
  kQuestion,
  kF1,
  kF11,
  kEscape,
  kD,
  kF,
  kH,
  kK,
  kN,
  kO,
  kP,
  kQ,
  kS,
  kT
};

struct KeyPress {
  ViewKey key = ViewKey::kSpace;
  bool shift = false;
};

/// An action of the viewer.
enum class ViewAction : std::uint8_t {
  kPlay,
  kFrameBack,
  kFrameOn,
  kSecondBack,
  kSecondOn,
  kTenBack,
  kTenOn,
  kToStart,
  kToEnd,
  kSlower,
  kFaster,
  kEventBack,
  kEventOn,
  kFileBack,
  kFileOn,
  kTrails,
  kDrawings,
  kFlip,
  kTheme,
  kFullScreen,
  kSave,
  kHelp,
  kQuit
};

/// The action of a key; empty if it has none.
std::optional<ViewAction> actionOf(KeyPress press);

/// A line of the viewer's list of keys.
struct KeyHelp {
  std::string_view keys;
  std::string_view text;
  bool replay = true;  ///< shown for a recording
  bool live = true;    ///< shown for a live match
};

std::span<const KeyHelp> keyHelp();

}  // namespace fulbito
