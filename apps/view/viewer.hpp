// Private header of apps/view: not installed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/view/key_bindings.hpp"
#include "apps/view/view_stage.hpp"

namespace fulbito {

/// Speeds that - and + go through, in real time's.
inline constexpr double kViewSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

/// What a user can set.
struct ViewSettings {
  double speed = 1.0;  ///< one of `kViewSpeeds`
  bool paused = false;
  PictureTheme theme = PictureTheme::kDark;
  bool trails = true;
  bool drawings = false;
  bool flipped = false;  ///< the field is shown from its other side
  bool help = false;
  bool full_screen = false;
};

/// What a mouse does, in terms of the picture that it points at.
struct PointerEvent {
  enum class Kind : std::uint8_t { kDown, kMove, kUp, kWheel };
  Kind kind = Kind::kMove;
  bool right = false;        ///< button; else the left one
  Vec2 place;                ///< [m] as the picture shows the field
  bool on_bar = false;       ///< on the bar of time
  double bar_seconds = 0.0;  ///< that its column stands for
  double wheel = 0.0;        ///< notches, away from the user
};

/// The player behind a window: what it shows, how fast, and what keys and mouse do. Knows no toolkit and
/// reads no clock.
class Viewer {
 public:
  /// Shows the first of at least one stage; each is left where it stands when another is shown.
  Viewer(std::vector<std::unique_ptr<ViewStage>> stages, const ViewSettings& settings);

  void press(KeyPress press);
  void act(ViewAction action);
  void point(const PointerEvent& event);
  /// Goes on to a wall time [ns]. A gap of more than a tenth of a second, as when the machine slept, counts
  /// as one.
  void advance(std::int64_t now);

  /// Whether the picture changes by itself: play goes on, or a notice will go.
  bool moving() const;
  /// Whether the picture is not what was drawn last.
  bool stale() const { return stale_; }
  /// The picture is to be drawn anew, as after a change of the window's size.
  void spoil() { stale_ = true; }
  /// Fills in what is to be drawn, flipped if so wished, and takes it as drawn.
  void show(ReplayMoment& moment, MatchOverlays& overlays);

  /// Tells the user something for a few seconds.
  void notify(std::string text);
  /// Once after each wish to save a picture.
  bool takeSave();
  bool quits() const { return quits_; }

  const ViewSettings& settings() const { return settings_; }
  ViewStage& stage() const { return *stages_[current_]; }
  std::size_t current() const { return current_; }
  std::size_t count() const { return stages_.size(); }
  /// E.g. "libero 2 : 1 classic - game.fbr".
  std::string title() const;
  /// How play stands and what was done last, e.g. "saved a.png - paused".
  std::string note() const;
  /// What is always to be seen: the speed of play, and where help is.
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
  std::optional<std::int64_t> now_;  ///< [ns]
  std::string notice_;
  std::optional<std::int64_t> notice_until_;  ///< [ns]; empty: from the next `advance` on
  PerTeam<int> score_{};
  std::vector<RecordedDrawing> turned_;  ///< drawings, flipped
  bool scrubbing_ = false;
  bool stale_ = true;
  bool save_ = false;
  bool quits_ = false;
};

}  // namespace fulbito
