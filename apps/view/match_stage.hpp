#pragma once

#include <vector>

#include "apps/view/match_editor.hpp"
#include "apps/view/view_stage.hpp"
#include "fulbito/match.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// A live match in a viewer, played while it is watched. Pictures between two ticks are interpolated, so they
/// lag by up to one tick.
class MatchStage final : public ViewStage, private MatchObserver {
 public:
  /// Observes `match`, which must outlive the stage. Create it before the first step.
  /// @param pace  of a match that keeps its own time, since clients of the league play in it: its speed over
  ///              real time, and a step takes as long as a tick. 0: the stage's time is the viewer's
  explicit MatchStage(Match& match, double pace = 0.0);

  const MatchPictureSpec& look() const override { return look_; }
  const std::string& name() const override { return name_; }
  bool live() const override { return true; }
  bool edited() const override { return edited_ || match_->edits() > 0; }
  bool over() const override { return over_; }
  double seconds() const override;
  double frameSeconds() const override { return match_->config().physics.controlPeriod(); }
  void forward(double seconds) override;
  void stepOn() override;
  MatchEditor* editor() override { return &editor_; }
  void refresh() override;
  void show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) override;

 private:
  using Poses = std::vector<std::optional<Pose2>>;

  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;
  bool wantsDrawings(Tick) const override { return true; }
  void fill(const Placement& placement, Poses& poses) const;
  void play();
  MatchBanner banner() const;
  void addTrails(const Poses& poses, MatchOverlays& overlays) const;

  Match* match_;
  double pace_;
  RecordingHeader header_;
  MatchPictureSpec look_;
  std::string name_;
  MatchEditor editor_;
  Poses before_, now_;  ///< poses of the header's bodies at the last two ticks
  double share_ = 1.0;  ///< interpolation from `before_` (0) to `now_` (1)
  std::vector<std::vector<Vec2>> paths_;
  std::vector<RecordedDrawing> drawings_;
  RecordedPlay play_;    ///< without its starts
  RecordedEvent call_;   ///< the last call with a banner
  bool called_ = false;  ///< whether there was a call with a banner
  RecordedEvent event_;  ///< reused for each event
  bool edited_ = false;
  bool over_ = false;
};

}  // namespace fulbito
