#include "replays/verify/verify.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/system/error_text.hpp"
#include "fulbito/detail/math.hpp"
#include "replays/verify/resimulate.hpp"

namespace fulbito {
namespace {

/// Smallest difference from a sample that counts, in steps of the sample. Rounding causes up to half a step.
constexpr double kRounding = 0.75;

class Verifier final : public ReplayVisitor {
 public:
  explicit Verifier(const RecordingReader& recording) : recording_(recording), header_(recording.header()) {}

  bool playBegins(const ReplayedPlay& play) override {
    if (found_) return false;
    play_ = play.number;
    began_ = play.recorded->tick;
    ++result_.plays;
    // A recording that was cut out of a longer one begins with the hash of that place in the longer one.
    const bool first = result_.plays == 1;
    if (!first && play.hash != play.recorded->hash) {
      diverge(began_, "the play does not continue the previous one");
    }
    return !found_;
  }

  bool ticked(const ReplayedTick& tick) override {
    result_.ticks = tick.tick;
    result_.final_hash = tick.hash;
    if (!found_ && asRecorded(tick)) return true;
    if (!found_) diverge(tick.tick, "");
    if (const RecordedCheck* check = checkAt(tick)) nameByHash(tick, *check);
    if (const RecordedSample* sample = sampleAt(tick)) nameBySample(tick, *sample);
    return !found_->body;
  }

  Verification take() {
    result_.seconds = static_cast<double>(result_.ticks) / header_.control_rate;
    result_.finished = recording_.finished();
    const BuildInfo &made = header_.build, &own = buildInfo();
    result_.same_build = made.version == own.version && made.compiler == own.compiler &&
                         made.type == own.type && made.box2d == own.box2d;
    const auto& end = recording_.result();
    if (!found_ && end && end->final_hash != result_.final_hash) {
      diverge(result_.ticks, "the final hash differs");
    }
    if (found_) describe();
    result_.divergence = found_;
    return result_;
  }

 private:
  const RecordedSample* sampleAt(const ReplayedTick& tick) const {
    const Tick every = header_.sample_every;
    if (tick.chunk->samples.empty() || tick.tick % every != 0) return nullptr;
    return &tick.chunk
                ->samples[static_cast<std::size_t>(tick.tick / every - tick.chunk->first_tick / every - 1)];
  }

  void diverge(Tick tick, const char* what) {
    found_.emplace();
    found_->tick = tick;
    found_->play = play_;
    found_->play_tick = tick - began_;
    found_->text = what;
  }

  void nameBody(std::size_t body, Tick tick, const char* field) {
    found_->body = body;
    found_->body_name = bodyName(header_, body);
    found_->body_tick = tick;
    found_->field = field;
  }

  void nameByHash(const ReplayedTick& tick, const RecordedCheck& check) {
    for (std::size_t i = 0; i < tick.bodies.size(); ++i) {
      const BodyHash now = bodyHash(*tick.state, i), then = check.bodies[tick.bodies[i]];
      if (now == then) continue;
      if (!found_->body) nameBody(tick.bodies[i], tick.tick, now.place != then.place ? "place" : "motion");
      ++found_->bodies;
    }
  }

  static Pose2 poseOf(const WorldState& world, std::size_t i) {
    if (i < world.robots.size()) return world.robots[i].pose;
    i -= world.robots.size();
    if (i < world.balls.size()) return {world.balls[i].position, 0.0};
    return world.obstacles[i - world.balls.size()].pose;
  }

  /// Names the body that is farthest from its recorded sample, if by at least `kRounding` steps.
  void nameBySample(const ReplayedTick& tick, const RecordedSample& sample) {
    double most = kRounding;
    int differ = 0;
    for (std::size_t i = 0; i < tick.bodies.size(); ++i) {
      bool same = true;
      const Pose2 now = poseOf(*tick.state, i);
      const Pose2& then = sample.poses[tick.bodies[i]];
      const auto compare = [&](const char* field, double recorded, double replayed, double step) {
        const double steps = std::abs(recorded - replayed) / step;
        same = same && steps <= kRounding;
        if (!(steps > most)) return;
        most = steps;
        nameBody(tick.bodies[i], tick.tick, field);
        found_->recorded = recorded;
        found_->replayed = replayed;
      };
      compare("x", then.position.x, now.position.x, header_.sample_step);
      compare("y", then.position.y, now.position.y, header_.sample_step);
      compare("heading", now.heading + math::wrapAngle(then.heading - now.heading), now.heading,
              sampleHeadingStep(header_));
      differ += same ? 0 : 1;
    }
    if (differ > 0) found_->bodies = differ;
  }

  void describe() {
    Divergence& d = *found_;
    std::string text =
        fmt::format("differs from tick {} on (tick {} of play {}, {:.3f} s)", d.tick, d.play_tick, d.play + 1,
                    static_cast<double>(d.tick) / header_.control_rate);
    if (!d.text.empty()) text += ": " + d.text;
    if (d.body) {
      text += fmt::format("; at tick {} {} of {}", d.body_tick, d.field, d.body_name);
      text += d.recorded == d.replayed ? std::string(" differs")
                                       : fmt::format(" is {:.6f}, recorded {:.6f}", d.replayed, d.recorded);
      if (d.bodies > 1) text += fmt::format(" ({} bodies differ there)", d.bodies);
    }
    d.text = text;
  }

  const RecordingReader& recording_;
  const RecordingHeader& header_;
  Verification result_;
  std::optional<Divergence> found_;
  std::int64_t play_ = 0;
  Tick began_ = 0;
};

}  // namespace

Result<Verification> verify(const RecordingReader& recording) {
  if (recording.header().heard) {
    Verification heard;
    heard.heard = true;
    heard.finished = recording.finished();
    if (recording.finished()) heard.final_hash = recording.result()->final_hash;
    heard.ticks = recording.ticks();
    heard.seconds = static_cast<double>(heard.ticks) / recording.header().control_rate;
    return heard;
  }
  Verifier verifier(recording);
  if (auto played = resimulate(recording, verifier); !played) return tl::unexpected<Error>(played.error());
  return verifier.take();
}

Result<Verification> verifyRecording(const std::string& file) {
  const auto recording = RecordingReader::open(file);
  if (!recording) return tl::unexpected<Error>(recording.error());
  auto verified = verify(*recording);
  if (!verified) return inFile(file, verified.error());
  return verified;
}

}  // namespace fulbito
