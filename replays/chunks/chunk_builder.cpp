#include "replays/chunks/chunk.hpp"
#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

/// Initial capacity for the events and drawings of a chunk [bytes]; most chunks need less.
constexpr std::size_t kListBytes = 16384;

std::size_t samplesPerChunk(const RecordingHeader& header) {
  return static_cast<std::size_t>(header.chunk_ticks / header.sample_every) + 1;
}

void writePlay(const RecordedPlay& play, Tick offset, Bytes& bytes) {
  ByteWriter out(bytes);
  out.varint(static_cast<std::uint64_t>(offset));
  out.byte(static_cast<std::uint8_t>(play.kind));
  out.byte(static_cast<std::uint8_t>(static_cast<unsigned>(play.team) |
                                     static_cast<unsigned>(play.blue_side) << 1 |
                                     (play.defenders_back ? 4u : 0u)));
  out.varint(static_cast<std::uint64_t>(play.delay));
  out.varint(static_cast<std::uint64_t>(play.period));
  out.varint(static_cast<std::uint64_t>(play.play_ticks));
  for (const int goals : play.score) out.varint(static_cast<std::uint64_t>(goals));
  out.fixed(play.hash);
  writeNumbers({play.ball.x, play.ball.y}, out);
  std::vector<std::uint8_t> present;
  present.reserve(play.starts.size());
  for (const RecordedStart& start : play.starts) present.push_back(start.present ? 1 : 0);
  writeFlags(present.cbegin(), present.size(), out);
  for (const RecordedStart& s : play.starts) {
    if (!s.present) continue;
    writeNumbers({s.pose.position.x, s.pose.position.y, s.pose.heading, s.velocity.x, s.velocity.y,
                  s.angular_velocity, s.spin.x, s.spin.y},
                 out);
  }
}

std::int64_t drawingSteps(double value) { return wholeSteps(value, kDrawingStep); }

}  // namespace

ChunkBuilder::ChunkBuilder(const RecordingHeader& header)
    : header_(header),
      robots_(static_cast<std::size_t>(countOf(header, BodyKind::kRobot))),
      balls_(static_cast<std::size_t>(countOf(header, BodyKind::kBall))),
      present_at_start_(header.bodies.size()),
      present_(header.bodies.size()) {
  const auto ticks = static_cast<std::size_t>(header.chunk_ticks);
  if (header.command_step > 0.0) {
    commands_ = Columns(2 * robots_, ticks);
  } else {
    exact_commands_.reserve(16 * robots_ * ticks);
  }
  if (header.level == RecordingLevel::kFull) {
    samples_ = Columns(sampleColumns(header), samplesPerChunk(header));
    drawings_.bytes.reserve(kListBytes);
  }
  hashes_.reserve(2 * ticks);
  checks_.reserve(8 * header.bodies.size() * (ticks / header.control_rate + 2));
  on_field_.reserve(header.bodies.size());
  events_.bytes.reserve(kListBytes);
  runs_.reserve(256);
}

bool ChunkBuilder::full() const { return ticks_ >= header_.chunk_ticks || plays_ >= kMaxChunkPlays; }

void ChunkBuilder::play(const RecordedPlay& play, Tick tick) {
  on_field_.clear();
  for (std::size_t body = 0; body < header_.bodies.size(); ++body) {
    present_[body] = play.starts[body].present ? 1 : 0;
    if (present_[body] != 0) on_field_.push_back(static_cast<std::uint16_t>(body));
  }
  writePlay(play, tick - first_tick_, play_list_);
  ++plays_;
}

void ChunkBuilder::tick(const TickData& data) {
  const std::size_t robots = data.world->robots.size();
  if (header_.command_step > 0.0) {
    const std::size_t row = commands_.addRow();
    for (std::size_t column = 0; column < commands_.columns(); ++column) commands_.at(column, row) = 0;
    for (std::size_t i = 0; i < robots && i < data.commands.size(); ++i) {
      const std::size_t column = 2 * std::size_t{on_field_[i]};
      commands_.at(column, row) = wholeSteps(data.commands[i].left, header_.command_step);
      commands_.at(column + 1, row) = wholeSteps(data.commands[i].right, header_.command_step);
    }
  } else {
    const std::size_t row = exact_commands_.size();
    exact_commands_.resize(row + 16 * robots_);
    Bytes bytes;
    for (std::size_t i = 0; i < robots && i < data.commands.size(); ++i) {
      bytes.clear();
      ByteWriter out(bytes);
      out.number(data.commands[i].left);
      out.number(data.commands[i].right);
      exact_commands_.replace(row + 16 * std::size_t{on_field_[i]}, 16, bytes);
    }
  }
  ByteWriter(hashes_).fixed(static_cast<std::uint16_t>(data.hash));
  if (data.playing != run_value_) {
    ByteWriter(runs_).varint(run_length_);
    run_value_ = data.playing;
    run_length_ = 0;
  }
  ++run_length_;
  ++ticks_;
  if (data.tick % header_.control_rate == 0) check(*data.world);
  if (header_.level == RecordingLevel::kFull && data.tick % header_.sample_every == 0) sample(*data.world);
}

void ChunkBuilder::check(const WorldState& world) {
  ByteWriter out(checks_);
  std::size_t next = 0;
  for (const std::uint8_t present : present_) {
    const BodyHash hash = present != 0 ? bodyHash(world, next++) : BodyHash{};
    out.fixed(hash.place);
    out.fixed(hash.motion);
  }
}

void ChunkBuilder::sample(const WorldState& world) {
  const std::size_t row = samples_.addRow();
  std::size_t column = 0;
  const auto put = [&](double value, double step) { samples_.at(column++, row) = wholeSteps(value, step); };
  const double place_step = header_.sample_step;
  const auto put_pose = [&](const Pose2& pose) {
    put(pose.position.x, place_step);
    put(pose.position.y, place_step);
    samples_.at(column++, row) = headingSteps(pose.heading, header_);
  };
  std::size_t robot = 0, ball = 0, obstacle = 0;
  for (std::size_t body = 0; body < header_.bodies.size(); ++body) {
    if (present_[body] == 0) {
      for (std::size_t i = sampleColumns(header_.bodies[body].kind); i > 0; --i) put(0.0, 1.0);
    } else if (body < robots_) {
      put_pose(world.robots[robot++].pose);
    } else if (body < robots_ + balls_) {
      const BallState& state = world.balls[ball++];
      put(state.position.x, place_step);
      put(state.position.y, place_step);
    } else {
      put_pose(world.obstacles[obstacle++].pose);
    }
  }
}

void ChunkBuilder::event(const RecordedEvent& event) {
  ByteWriter out(events_.bytes);
  out.signedVarint(event.tick - first_tick_);
  out.byte(event.period);
  out.byte(event.team ? static_cast<std::uint8_t>(1 + indexOf(*event.team)) : 0);
  out.varint(event.robot ? 1u + *event.robot : 0u);
  out.text(std::string_view(event.clause).substr(0, kMaxClauseBytes));
  out.text(std::string_view(event.law).substr(0, kMaxClauseBytes));
  writeNumbers({event.play_time, event.place.x, event.place.y, event.value, event.threshold, event.margin},
               out);
  ++events_.count;
}

void ChunkBuilder::drawing(const RecordedDrawing& drawing) {
  ByteWriter out(drawings_.bytes);
  out.signedVarint(drawing.tick - first_tick_);
  out.byte(static_cast<std::uint8_t>(2 * static_cast<unsigned>(drawing.kind) + indexOf(drawing.team)));
  for (const double value : {drawing.from.x, drawing.from.y, drawing.to.x, drawing.to.y, drawing.radius}) {
    out.signedVarint(drawingSteps(value));
  }
  out.text(drawing.text);
  ++drawings_.count;
}

void ChunkBuilder::writeHead(Bytes& bytes) const {
  ByteWriter out(bytes);
  out.varint(static_cast<std::uint64_t>(first_tick_));
  out.varint(static_cast<std::uint64_t>(ticks_));
  out.varint(static_cast<std::uint64_t>(plays_before_));
  out.varint(static_cast<std::uint64_t>(plays_));
  out.varint(events_.count);
  out.varint(drawings_.count);
  writeFlags(present_at_start_.cbegin(), present_at_start_.size(), out);
  for (const std::size_t size : sizes_) out.varint(size);
}

void ChunkBuilder::putSection(Section section, BytesView content, const Packer& packer) {
  const std::size_t begin = body_.size();
  if (!content.empty()) packer.pack(content, body_);
  sizes_[indexOf(section)] = body_.size() - begin;
}

void ChunkBuilder::pack(const Packer& packer, Bytes& out) {
  ByteWriter(runs_).varint(run_length_);
  body_.clear();
  const auto table = [&](const Columns& columns, Trend trend) {
    table_.clear();
    if (columns.rows() > 0) writeColumns(columns, trend, table_);
    return BytesView(table_);
  };
  putSection(Section::kPlays, play_list_, packer);
  putSection(Section::kCommands,
             header_.command_step > 0.0 ? table(commands_, kCommandTrend) : exact_commands_, packer);
  putSection(Section::kTickHashes, hashes_, packer);
  putSection(Section::kPlaying, runs_, packer);
  putSection(Section::kChecks, checks_, packer);
  putSection(Section::kEvents, events_.bytes, packer);
  putSection(Section::kDrawings, drawings_.bytes, packer);
  putSection(Section::kSamples, table(samples_, kSampleTrend), packer);
  writeHead(out);
  out.append(body_);
  startNext();
}

void ChunkBuilder::startNext() {
  first_tick_ += ticks_;
  ticks_ = 0;
  plays_before_ += plays_;
  plays_ = 0;
  present_at_start_ = present_;
  commands_.clear();
  samples_.clear();
  for (Bytes* bytes : {&exact_commands_, &hashes_, &checks_, &runs_, &play_list_}) bytes->clear();
  run_value_ = true;
  run_length_ = 0;
  for (List* list : {&events_, &drawings_}) list->clear();
}

}  // namespace fulbito
