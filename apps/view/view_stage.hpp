#pragma once

#include <optional>
#include <string>

#include "fulbito/picture.hpp"

namespace fulbito {

class MatchEditor;

/// The content of a viewer, a recording or a live match, at one moment.
class ViewStage {
 public:
  ViewStage() = default;
  ViewStage(const ViewStage&) = delete;
  ViewStage& operator=(const ViewStage&) = delete;
  virtual ~ViewStage() = default;

  /// The specification of the stage's pictures, with default size and theme.
  virtual const MatchPictureSpec& look() const = 0;
  /// The name in the window's title, such as the file's name.
  virtual const std::string& name() const = 0;
  virtual bool live() const { return false; }
  /// Whether a user has edited the match.
  virtual bool edited() const = 0;
  /// Whether the recording or match is at its end.
  virtual bool over() const = 0;
  virtual double seconds() const = 0;
  /// Length of a frame or tick [s].
  virtual double frameSeconds() const = 0;

  /// Advances by a time of play [s], at most to the end.
  virtual void forward(double seconds) = 0;
  /// Advances by one frame or tick, without interpolation.
  virtual void stepOn() { forward(frameSeconds()); }
  /// Goes to a time [s] of a recording, clamped to its range. A live match ignores it.
  virtual void seek(double) {}
  /// @{ Time [s] to seek to for the next or previous event; empty: there is none.
  virtual std::optional<double> eventAfter(double) const { return std::nullopt; }
  virtual std::optional<double> eventBefore(double) const { return std::nullopt; }
  /// @}
  /// The editor for moving bodies; null: not editable.
  virtual MatchEditor* editor() { return nullptr; }
  /// Updates the stage after an edit.
  virtual void refresh() {}

  /// Fills in the present moment and its overlays.
  virtual void show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) = 0;
};

}  // namespace fulbito
