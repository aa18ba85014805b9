#include "replays/verify/resimulate.hpp"

#include <fmt/format.h>

#include "engine/core/system/stop_request.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/models.hpp"
#include "replays/chunks/heard_state.hpp"

namespace fulbito {
namespace {

/// The models that all worlds of a recording share.
struct Models {
  FieldGeometry field;
  PhysicsProfile physics;
  RobotPreset robot;
  std::vector<ObstacleSpec> obstacles;
};

Result<Models> modelsOf(const RecordingRecipe& recipe) {
  auto field = parseField(recipe.field, "recorded field");
  if (!field) return tl::unexpected<Error>(field.error());
  auto physics = parsePhysics(recipe.physics, "recorded physics");
  if (!physics) return tl::unexpected<Error>(physics.error());
  auto robot = parseRobot(recipe.robot, "recorded robot");
  if (!robot) return tl::unexpected<Error>(robot.error());
  Models models{*field, *physics, *robot, {}};
  if (!recipe.layout.empty()) {
    auto layout = parseLayout(recipe.layout, "recorded layout");
    if (!layout) return tl::unexpected<Error>(layout.error());
    models.obstacles = layout->obstacles;
  }
  return models;
}

class Replay {
 public:
  Replay(const RecordingHeader& header, Models models, const PlayRange& range, ReplayVisitor& visitor)
      : header_(header),
        robots_(static_cast<std::size_t>(countOf(header_, BodyKind::kRobot))),
        models_(std::move(models)),
        range_(range),
        visitor_(visitor) {}

  Result<void> run(const ChunkSource& chunks) {
    for (;;) {
      const auto chunk = chunks();
      if (!chunk) return tl::unexpected<Error>(chunk.error());
      if (!*chunk) return {};
      auto played = play(**chunk);
      if (!played) return tl::unexpected<Error>(played.error());
      if (!*played) return {};
    }
  }

 private:
  void stop() {
    world_.reset();
    heard_.reset();
  }

  /// Simulates the plays of a chunk. False if the visitor ended the resimulation.
  Result<bool> play(const RecordedChunk& chunk) {
    if (chunk.first_tick != expected_) {  // chunks are missing
      stop();
      plays_ = chunk.plays_before;
    } else if (chunk.first_tick == 0 && chunk.ticks > 0 &&
               (chunk.plays.empty() || chunk.plays.front().tick > 0)) {
      return fail(ErrorCode::kBadInput, "the recording begins without a play");
    }
    expected_ = chunk.first_tick + chunk.ticks;
    visitor_.chunkBegins(chunk);
    auto next = chunk.plays.begin();
    for (std::size_t row = 0; row <= static_cast<std::size_t>(chunk.ticks); ++row) {
      const Tick before = chunk.first_tick + static_cast<Tick>(row);
      for (; next != chunk.plays.end() && next->tick <= before; ++next) {
        stop();
        const std::int64_t number = plays_++;
        if (number > range_.last) return false;
        if (number < range_.first) continue;
        auto begun = begin(*next, number);
        if (!begun || !*begun) return begun;
      }
      if (row == static_cast<std::size_t>(chunk.ticks)) break;
      if (stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
      if ((world_ || heard_) && !step(chunk, row)) return false;
    }
    return true;
  }

  Result<bool> begin(const RecordedPlay& play, std::int64_t number) {
    WorldConfig config;
    config.field = models_.field;
    config.physics = models_.physics;
    ids_.clear();
    bodies_.clear();
    for (std::size_t body = 0; body < header_.bodies.size(); ++body) {
      const RecordedStart& start = play.starts[body];
      if (!start.present) continue;
      bodies_.push_back(body);
      if (auto placed = place(config, body, start); !placed) return tl::unexpected<Error>(placed.error());
    }
    if (header_.heard) {
      heard_.emplace();
    } else {
      auto world = World::create(config);
      if (!world) {
        return fail(ErrorCode::kBadInput, fmt::format("the play at tick {} gives no valid world: {}",
                                                      play.tick, world.error().message));
      }
      world_.emplace(std::move(*world));
    }
    commands_.assign(ids_.size(), {});
    const std::uint64_t reached = hash_.value();
    hash_ = StateHash(play.hash);
    return visitor_.playBegins({&play, number, world(), ids_, bodies_, reached});
  }

  Result<void> place(WorldConfig& config, std::size_t body, const RecordedStart& start) {
    const RecordedBody& what = header_.bodies[body];
    if (what.kind == BodyKind::kRobot) {
      ids_.push_back(what.id.value_or(RobotId{}));
      config.robots.push_back({models_.robot.robot, start.pose, start.velocity, start.angular_velocity});
    } else if (what.kind == BodyKind::kBall) {
      config.balls.push_back({models_.robot.ball, start.pose.position, start.velocity, start.spin});
    } else {
      const std::size_t number = config.obstacles.size();
      if (number >= models_.obstacles.size()) {
        return fail(ErrorCode::kBadInput, "the recording has more obstacles than its layout");
      }
      config.obstacles.push_back(models_.obstacles[number]);
      config.obstacles.back().pose = start.pose;
    }
    return {};
  }

  bool step(const RecordedChunk& chunk, std::size_t row) {
    for (std::size_t i = 0; i < commands_.size(); ++i)
      commands_[i] = chunk.commands[row * robots_ + bodies_[i]];
    if (heard_) {
      standAt(header_, chunk.samples[row].poses, bodies_, *heard_);
    } else {
      world_->step(commands_);
    }
    const WorldState& state = heard_ ? *heard_ : world_->state();
    hash_.add(state);
    return visitor_.ticked({chunk.first_tick + static_cast<Tick>(row) + 1, world(), &state, ids_, bodies_,
                            commands_, hash_.value(), &chunk, row});
  }

  const World* world() const { return world_ ? &*world_ : nullptr; }

  const RecordingHeader& header_;
  const std::size_t robots_;
  const Models models_;
  const PlayRange range_;
  ReplayVisitor& visitor_;
  std::optional<World> world_;       ///< of the play, or
  std::optional<WorldState> heard_;  ///< where its bodies are, if they were heard
  std::vector<RobotId> ids_;
  std::vector<std::size_t> bodies_;
  std::vector<WheelSpeeds> commands_;
  StateHash hash_;
  std::int64_t plays_ = 0;
  Tick expected_ = 0;  ///< first tick of the next chunk if no chunk is missing
};

}  // namespace

const RecordedCheck* checkAt(const ReplayedTick& tick) {
  for (const RecordedCheck& check : tick.chunk->checks) {
    if (check.tick == tick.tick) return &check;
  }
  return nullptr;
}

bool asRecorded(const ReplayedTick& tick) {
  if (static_cast<std::uint16_t>(tick.hash) != tick.chunk->tick_hashes[tick.row]) return false;
  const RecordedCheck* check = checkAt(tick);
  if (check == nullptr) return true;
  for (std::size_t i = 0; i < tick.bodies.size(); ++i) {
    if (bodyHash(*tick.state, i) != check->bodies[tick.bodies[i]]) return false;
  }
  return true;
}

Result<void> resimulate(const RecordingHeader& header, const ChunkSource& chunks, const PlayRange& plays,
                        ReplayVisitor& visitor) {
  auto models = modelsOf(header.recipe);
  if (!models) return fail(ErrorCode::kBadInput, models.error().message);
  return Replay(header, std::move(*models), plays, visitor).run(chunks);
}

Result<void> resimulate(const RecordingReader& recording, const PlayRange& plays, ReplayVisitor& visitor) {
  const auto chunks = [&recording, i = std::size_t{0}]() mutable -> Result<std::optional<RecordedChunk>> {
    if (i == recording.chunkCount()) return std::nullopt;
    auto chunk = recording.chunk(i++);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    return std::optional<RecordedChunk>(std::move(*chunk));
  };
  return resimulate(recording.header(), chunks, plays, visitor);
}

Result<void> resimulate(const RecordingReader& recording, ReplayVisitor& visitor) {
  return resimulate(recording, PlayRange{}, visitor);
}

std::string bodyName(const RecordingHeader& header, std::size_t body) {
  const RecordedBody& what = header.bodies[body];
  if (what.id) return fmt::format("{} {}", nameOf(what.id->team), what.id->number);
  std::size_t first = body;
  while (first > 0 && header.bodies[first - 1].kind == what.kind) --first;
  const int count = countOf(header, what.kind);
  const char* kind = what.kind == BodyKind::kRobot  ? "robot"
                     : what.kind == BodyKind::kBall ? "ball"
                                                    : "obstacle";
  if (count == 1) return kind;
  return fmt::format("{} {}", kind, body - first);
}

}  // namespace fulbito
