#pragma once

#include <memory>
#include <vector>

#include "apps/view/view_stage.hpp"

namespace fulbito {

/// A recording in a viewer.
class ReplayStage final : public ViewStage {
 public:
  /// Seeking to an event goes this long before it, to show what led to it.
  static constexpr double kLead = 1.0;  // [s]

  /// Errors: as `pictureSpecOf`.
  static Result<std::unique_ptr<ReplayStage>> create(ReplayTimeline timeline, std::string name);

  const MatchPictureSpec& look() const override { return look_; }
  const std::string& name() const override { return name_; }
  bool edited() const override { return edited_; }
  bool over() const override { return seconds_ >= timeline_.seconds(); }
  double seconds() const override { return seconds_; }
  double frameSeconds() const override;
  void forward(double seconds) override { seek(seconds_ + seconds); }
  void seek(double seconds) override;
  std::optional<double> eventAfter(double seconds) const override;
  std::optional<double> eventBefore(double seconds) const override;
  void show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) override;

 private:
  ReplayStage(ReplayTimeline timeline, std::string name, MatchPictureSpec look);

  ReplayTimeline timeline_;
  std::string name_;
  MatchPictureSpec look_;
  std::vector<double> events_;  ///< [s] where seeking to each event goes, ascending
  bool edited_ = false;
  double seconds_ = 0.0;
};

}  // namespace fulbito
