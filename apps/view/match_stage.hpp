// Private header of apps/view: not installed.
#pragma once

#include <vector>

#include "apps/view/match_editor.hpp"
#include "apps/view/view_stage.hpp"
#include "match/play/match.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// A match in a viewer, played as it is looked at. Pictures between two ticks are interpolated, so that what
/// is shown is up to a tick old.
class MatchStage final : public ViewStage, private MatchObserver {
 public:
  /// Refers to `match` and watches it; to be made before its first step.
  explicit MatchStage(Match& match);

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

  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;
  bool wantsDrawings(Tick) const override { return true; }
  void fill(const Placement& placement, Poses& poses) const;
  void play();
  MatchBanner banner() const;
  void addTrails(const Poses& poses, MatchOverlays& overlays) const;

  Match* match_;
  RecordingHeader header_;
  MatchPictureSpec look_;
  std::string name_;
  MatchEditor editor_;
  Poses before_, now_;  ///< at the last two ticks, of the header's bodies
  double share_ = 1.0;  ///< of the way from `before_` to `now_`
  std::vector<std::vector<Vec2>> paths_;
  std::vector<RecordedDrawing> drawings_;
  RecordedPlay play_;    ///< without its starts
  RecordedEvent call_;   ///< the last that is worth a banner
  bool called_ = false;  ///< whether there was one
  RecordedEvent event_;  ///< reused
  bool edited_ = false;
  bool over_ = false;
};

}  // namespace fulbito
