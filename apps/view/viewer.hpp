#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/view/key_bindings.hpp"
#include "apps/view/view_stage.hpp"

namespace fulbito {

/// Speeds that the keys - and + select; 1 is real time.
inline constexpr double kViewSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

/// Settings of the viewer.
struct ViewSettings {
  double speed = 1.0;  ///< one of `kViewSpeeds`
  bool paused = false;
  PictureTheme theme = PictureTheme::kDark;
  bool trails = true;
  bool drawings = false;
  bool flipped = false;  ///< the field is shown rotated by 180 degrees
  bool help = false;
  bool full_screen = false;
};

/// A mouse event, with the position in the picture.
struct PointerEvent {
  enum class Kind : std::uint8_t { kDown, kMove, kUp, kWheel };
  Kind kind = Kind::kMove;
  bool right = false;        ///< true: right button, false: left button
  Vec2 place;                ///< [m] on the field as shown
  bool on_bar = false;       ///< on the time bar
  double bar_seconds = 0.0;  ///< [s] time at that position of the bar
  double wheel = 0.0;        ///< notches of the wheel, positive away from the user
};

/// The player behind a window: what it shows, its speed, and the effects of keys and mouse. Uses no toolkit
/// and reads no clock.
class Viewer {
 public:
  /// Takes at least one stage and shows the first. A hidden stage keeps its time.
  Viewer(std::vector<std::unique_ptr<ViewStage>> stages, const ViewSettings& settings);

  void press(KeyPress press);
  void act(ViewAction action);
  void point(const PointerEvent& event);
  /// Advances to a wall time [ns]. A longer gap, as when the machine slept, counts as a tenth of a second.
  void advance(std::int64_t now);

  /// Whether the picture will change by itself: play is running, or a notice will disappear.
  bool moving() const;
  /// Whether the picture must be redrawn.
  bool stale() const { return stale_; }
  /// Requests a redraw, for example after a change of the window's size.
  void spoil() { stale_ = true; }
  /// Fills in the moment and overlays to draw, flipped if set, and marks the picture as drawn.
  void show(ReplayMoment& moment, MatchOverlays& overlays);

  /// Shows a notice for a few seconds.
  void notify(std::string text);
  /// True once per request to save a picture.
  bool takeSave();
  bool quits() const { return quits_; }

  const ViewSettings& settings() const { return settings_; }
  ViewStage& stage() const { return *stages_[current_]; }
  std::size_t current() const { return current_; }
  std::size_t count() const { return stages_.size(); }
  /// E.g. "libero 2 : 1 classic - game.fbr".
  std::string title() const;
  /// The state of play and the last notice, e.g. "saved a.png - paused".
  std::string note() const;
  /// The line that is always visible: speed and the key for help.
  std::string hint() const;

 private:
  bool playing() const;
  void changeSpeed(int by);
  void togglePlay();
  void goBy(double seconds);
  void goTo(std::optional<double> seconds);
  void goToFile(std::size_t index);
  void look(ViewAction action);
  void press(const PointerEvent& event, Vec2 place);
  void letGo();
  Vec2 onField(Vec2 place) const { return settings_.flipped ? -place : place; }
  void edited();
  void flip(ReplayMoment& moment, MatchOverlays& overlays);

  std::vector<std::unique_ptr<ViewStage>> stages_;
  std::size_t current_ = 0;
  ViewSettings settings_;
  std::optional<std::int64_t> now_;  ///< [ns] time of the last `advance`
  std::string notice_;
  std::optional<std::int64_t> notice_until_;  ///< [ns]; empty: the time starts with the next `advance`
  PerTeam<int> score_{};
  std::vector<RecordedDrawing> turned_;  ///< drawings of the flipped field
  bool scrubbing_ = false;
  bool stale_ = true;
  bool save_ = false;
  bool quits_ = false;
};

}  // namespace fulbito
