// Private header of apps/view: not installed.
#pragma once

#include <optional>
#include <string>

#include "replays/render/match/match_picture.hpp"
#include "replays/render/match/replay_scene.hpp"

namespace fulbito {

class MatchEditor;

/// What a viewer shows: a recording, or a match while it is played. It stands at one moment.
class ViewStage {
 public:
  ViewStage() = default;
  ViewStage(const ViewStage&) = delete;
  ViewStage& operator=(const ViewStage&) = delete;
  virtual ~ViewStage() = default;

  /// What its pictures need; size and theme are left at their defaults.
  virtual const MatchPictureSpec& look() const = 0;
  /// For the window's title, e.g. the file's name.
  virtual const std::string& name() const = 0;
  virtual bool live() const { return false; }
  /// Whether a user changed the course of the match.
  virtual bool edited() const = 0;
  /// Whether nothing follows.
  virtual bool over() const = 0;
  virtual double seconds() const = 0;
  /// [s] of one frame, or tick.
  virtual double frameSeconds() const = 0;

  /// Goes on by a time of play [s], at most to the end.
  virtual void forward(double seconds) = 0;
  /// Goes on by one frame or tick, and shows that exactly.
  virtual void stepOn() { forward(frameSeconds()); }
  /// Goes to a time of a recording; out of range: to the nearest end. A live match stays where it is.
  virtual void seek(double) {}
  /// @{ Where the neighbouring event is looked at from; empty: there is none.
  virtual std::optional<double> eventAfter(double) const { return std::nullopt; }
  virtual std::optional<double> eventBefore(double) const { return std::nullopt; }
  /// @}
  /// For moving what stands on the field; null: nobody may.
  virtual MatchEditor* editor() { return nullptr; }
  /// Looks at all anew, after an edit.
  virtual void refresh() {}

  /// Fills in the present moment and what is shown over it.
  virtual void show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) = 0;
};

}  // namespace fulbito
