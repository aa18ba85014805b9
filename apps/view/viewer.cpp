#include "apps/view/viewer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "apps/view/match_editor.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kLongestGap = 0.1;              // [s] longest time that one frame may advance
constexpr std::int64_t kNotice = 2'500'000'000;  // [ns] time for which a notice is shown
constexpr double kBackSlack = 0.5;  // [s] after seeking to an event, going back within this time skips it
constexpr double kNotch = math::kPi / 12;  // [rad] turn of a robot per notch of the wheel

std::string speedText(double speed) {
  if (speed == 0.25) return "1/4x";
  if (speed == 0.5) return "1/2x";
  return fmt::format("{:g}x", speed);
}

}  // namespace

Viewer::Viewer(std::vector<std::unique_ptr<ViewStage>> stages, const ViewSettings& settings)
    : stages_(std::move(stages)), settings_(settings) {}

bool Viewer::playing() const {
  const MatchEditor* editor = stage().editor();
  const bool held = scrubbing_ || (editor != nullptr && editor->holding());
  return !settings_.paused && !held && !stage().over();
}

bool Viewer::moving() const { return playing() || !notice_.empty(); }

void Viewer::advance(std::int64_t now) {
  const double gap = now_ ? static_cast<double>(now - *now_) * 1e-9 : 0.0;
  now_ = now;
  if (!notice_.empty() && !notice_until_) notice_until_ = now + kNotice;
  if (notice_until_ && now >= *notice_until_) {
    notice_.clear();
    notice_until_.reset();
    stale_ = true;
  }
  if (!playing()) return;
  stage().forward(std::clamp(gap, 0.0, kLongestGap) * settings_.speed);
  if (stage().over() && current_ + 1 < stages_.size()) goToFile(current_ + 1);
  stale_ = true;
}

void Viewer::notify(std::string text) {
  notice_ = std::move(text);
  notice_until_.reset();
  stale_ = true;
}

bool Viewer::takeSave() { return std::exchange(save_, false); }

void Viewer::press(KeyPress press) {
  if (const auto action = actionOf(press)) act(*action);
}

void Viewer::togglePlay() {
  if (stage().over() && !stage().live()) {
    stage().seek(0.0);
    settings_.paused = false;
  } else {
    settings_.paused = !settings_.paused;
  }
}

void Viewer::changeSpeed(int by) {
  const auto* const at = std::find(std::begin(kViewSpeeds), std::end(kViewSpeeds), settings_.speed);
  const auto last = static_cast<int>(std::size(kViewSpeeds)) - 1;
  const int next = std::clamp(static_cast<int>(at - std::begin(kViewSpeeds)) + by, 0, last);
  settings_.speed = kViewSpeeds[next];
  notify("speed " + speedText(settings_.speed));
}

void Viewer::goBy(double seconds) {
  if (!stage().live()) {
    stage().seek(stage().seconds() + seconds);
  } else if (seconds > 0.0) {
    stage().forward(seconds);
  } else {
    notify("a live match cannot go back");
  }
}

void Viewer::goTo(std::optional<double> seconds) {
  if (stage().live()) return;
  if (seconds) {
    stage().seek(*seconds);
  } else {
    notify("no more events");
  }
}

void Viewer::goToFile(std::size_t index) {
  if (index >= stages_.size() || index == current_) return;
  letGo();
  current_ = index;
  if (stage().over()) stage().seek(0.0);
  notify(stage().name());
}

void Viewer::look(ViewAction action) {
  const auto toggle = [](bool& setting) { setting = !setting; };
  if (action == ViewAction::kTrails) toggle(settings_.trails);
  if (action == ViewAction::kDrawings) toggle(settings_.drawings);
  if (action == ViewAction::kFlip && !stage().look().layout) toggle(settings_.flipped);
  if (action == ViewAction::kFullScreen) toggle(settings_.full_screen);
  if (action == ViewAction::kHelp) toggle(settings_.help);
  if (action == ViewAction::kTheme) {
    const bool dark = settings_.theme == PictureTheme::kDark;
    settings_.theme = dark ? PictureTheme::kLight : PictureTheme::kDark;
  }
}

void Viewer::act(ViewAction action) {
  stale_ = true;
  const double now = stage().seconds(), frame = stage().frameSeconds();
  switch (action) {
    case ViewAction::kPlay:
      return togglePlay();
    case ViewAction::kFrameBack:
      settings_.paused = true;
      return goBy(-frame);
    case ViewAction::kFrameOn:
      settings_.paused = true;
      return stage().stepOn();
    case ViewAction::kSecondBack:
      return goBy(-1.0);
    case ViewAction::kSecondOn:
      return goBy(1.0);
    case ViewAction::kTenBack:
      return goBy(-10.0);
    case ViewAction::kTenOn:
      return goBy(10.0);
    case ViewAction::kToStart:
      return goTo(0.0);
    case ViewAction::kToEnd:
      return goTo(stage().look().seconds);
    case ViewAction::kSlower:
      return changeSpeed(-1);
    case ViewAction::kFaster:
      return changeSpeed(1);
    case ViewAction::kEventBack:
      return goTo(stage().eventBefore(now - (playing() ? kBackSlack : 0.0)));
    case ViewAction::kEventOn:
      return goTo(stage().eventAfter(now));
    case ViewAction::kFileBack:
      return goToFile(current_ - std::min<std::size_t>(current_, 1));
    case ViewAction::kFileOn:
      return goToFile(current_ + 1);
    case ViewAction::kSave:
      save_ = true;
      return;
    case ViewAction::kQuit:
      // Escape and Q first close the help.
      quits_ = !std::exchange(settings_.help, false);
      return;
    default:
      return look(action);
  }
}

void Viewer::edited() {
  stage().refresh();
  notify("edited: play continues from here");
}

void Viewer::press(const PointerEvent& event, Vec2 place) {
  if (event.on_bar && !event.right) {
    scrubbing_ = !stage().live();
    if (scrubbing_) stage().seek(event.bar_seconds);
  } else if (MatchEditor* editor = stage().editor()) {
    editor->grab(place, event.right);
  }
}

void Viewer::letGo() {
  scrubbing_ = false;
  MatchEditor* editor = stage().editor();
  if (editor == nullptr || !editor->holding()) return;
  if (editor->drop()) edited();
}

void Viewer::point(const PointerEvent& event) {
  const Vec2 place = onField(event.place);
  MatchEditor* editor = stage().editor();
  switch (event.kind) {
    case PointerEvent::Kind::kDown:
      press(event, place);
      break;
    case PointerEvent::Kind::kMove:
      if (scrubbing_) {
        stage().seek(event.bar_seconds);
      } else if (editor != nullptr && editor->holding()) {
        editor->drag(place);
        if (!editor->flaw().empty()) notify(editor->flaw());
      } else {
        return;
      }
      break;
    case PointerEvent::Kind::kUp:
      letGo();
      break;
    case PointerEvent::Kind::kWheel:
      if (editor == nullptr) return;
      if (editor->turn(place, event.wheel * kNotch)) edited();
      break;
  }
  stale_ = true;
}

void Viewer::flip(ReplayMoment& moment, MatchOverlays& overlays) {
  moment.blue_side = opposite(moment.blue_side);
  for (auto& pose : moment.bodies) {
    if (pose) pose = Pose2{-pose->position, math::wrapAngle(pose->heading + math::kPi)};
  }
  for (BodyTrail& trail : overlays.trails) {
    for (Vec2& point : trail.points) point = -point;
  }
  turned_.assign(overlays.drawings.begin(), overlays.drawings.end());
  for (RecordedDrawing& drawing : turned_) {
    drawing.from = -drawing.from;
    drawing.to = -drawing.to;
  }
  overlays.drawings = turned_;
}

void Viewer::show(ReplayMoment& moment, MatchOverlays& overlays) {
  OverlayChoice choice;
  choice.drawings = settings_.drawings;
  if (!settings_.trails) choice.trail_seconds = 0.0;
  stage().show(choice, moment, overlays);
  score_ = moment.score;
  if (settings_.flipped && !stage().look().layout) flip(moment, overlays);
  stale_ = false;
}

std::string Viewer::title() const {
  const MatchPictureSpec& look = stage().look();
  std::string text = look.layout
                         ? look.names[0]
                         : fmt::format("{} {} : {} {}", look.names[0], score_[0], score_[1], look.names[1]);
  text += " - " + stage().name();
  if (stage().edited()) text += " - edited";
  return text;
}

std::string Viewer::note() const {
  std::string text = notice_;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " - ") + part; };
  if (settings_.paused && !stage().over()) add("paused");
  if (stage().over()) add("end");
  if (stages_.size() > 1) add(fmt::format("file {} of {}", current_ + 1, stages_.size()));
  return text;
}

std::string Viewer::hint() const { return speedText(settings_.speed) + " speed,  H: keys"; }

}  // namespace fulbito
