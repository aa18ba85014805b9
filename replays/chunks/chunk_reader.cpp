#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "replays/chunks/chunk.hpp"
#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

using Flaw = std::string;

/// Largest unpacked size of a list in a chunk [bytes].
constexpr std::size_t kMaxListBytes = std::size_t{16} << 20;
constexpr std::uint64_t kMaxTick = std::uint64_t{1} << 40;

using Sections = std::array<BytesView, kSectionNames.size()>;

struct ChunkLayout {
  ChunkHead head;
  Sections sections;  ///< packed
};

tl::expected<ChunkHead, Flaw> takeHead(ByteReader& in, const RecordingHeader& header) {
  ChunkHead head;
  head.first_tick = static_cast<Tick>(in.varint(kMaxTick));
  head.ticks = static_cast<int>(in.varint(static_cast<std::uint64_t>(header.chunk_ticks)));
  head.plays_before = static_cast<std::int64_t>(in.varint(kMaxTick));
  head.plays = static_cast<std::int64_t>(in.varint(kMaxChunkPlays));
  head.events = in.varint(kMaxListBytes);
  head.drawings = in.varint(kMaxListBytes);
  head.present = readFlags(header.bodies.size(), in);
  if (!in.good()) return tl::unexpected<Flaw>("its head is broken");
  return head;
}

tl::expected<ChunkLayout, Flaw> layoutOf(BytesView payload, const RecordingHeader& header) {
  ByteReader in(payload);
  auto head = takeHead(in, header);
  if (!head) return tl::unexpected(head.error());
  ChunkLayout layout{std::move(*head), {}};
  std::array<std::size_t, kSectionNames.size()> sizes;
  for (std::size_t& size : sizes) size = static_cast<std::size_t>(in.varint(payload.size()));
  for (std::size_t i = 0; i < sizes.size(); ++i) layout.sections[i] = in.bytes(sizes[i]);
  if (!in.good() || !in.atEnd()) return tl::unexpected<Flaw>("its sections do not fill it");
  return layout;
}

/// Parses the sections of one chunk.
class ChunkParser {
 public:
  ChunkParser(const RecordingHeader& header, ChunkLayout layout)
      : header_(header), layout_(std::move(layout)), robots_(count(BodyKind::kRobot)) {
    chunk_.first_tick = layout_.head.first_tick;
    chunk_.ticks = layout_.head.ticks;
    chunk_.plays_before = layout_.head.plays_before;
    chunk_.present = layout_.head.present;
  }

  tl::expected<RecordedChunk, Flaw> parse() {
    using Step = bool (ChunkParser::*)();
    static constexpr std::array<Step, kSectionNames.size()> kSteps{
        &ChunkParser::plays,  &ChunkParser::commands, &ChunkParser::hashes,   &ChunkParser::playing,
        &ChunkParser::checks, &ChunkParser::events,   &ChunkParser::drawings, &ChunkParser::samples};
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      if (!(this->*kSteps[i])()) return tl::unexpected(fmt::format("its {} are broken", kSectionNames[i]));
    }
    return std::move(chunk_);
  }

 private:
  std::size_t count(BodyKind kind) const { return static_cast<std::size_t>(countOf(header_, kind)); }
  std::size_t ticks() const { return static_cast<std::size_t>(chunk_.ticks); }

  /// The unpacked content of a section, empty if the chunk lacks it. No value if it is broken or larger than
  /// `most`.
  std::optional<Bytes> open(Section section, std::size_t most) const {
    const BytesView packed = layout_.sections[indexOf(section)];
    return packed.empty() ? Bytes() : unpacked(packed, most);
  }
  std::optional<Bytes> openExactly(Section section, std::size_t size) const {
    auto bytes = open(section, size);
    if (bytes && bytes->size() != size) return std::nullopt;
    return bytes;
  }
  std::optional<Columns> table(Section section, std::size_t columns, std::size_t rows, Trend trend) const {
    if (columns * rows == 0 && layout_.sections[indexOf(section)].empty()) return Columns();
    const auto bytes = open(section, mostColumnBytes(columns, rows));
    return bytes ? readColumns(*bytes, columns, rows, trend) : std::nullopt;
  }

  /// Reads a section that is a list of `count` items. `each` reads one item.
  template <typename Each>
  bool list(Section section, std::uint64_t count, const Each& each) const {
    const auto bytes = open(section, kMaxListBytes);
    if (!bytes) return false;
    ByteReader in(*bytes);
    for (std::uint64_t left = count; left > 0 && in.good(); --left) each(in);
    return in.good() && in.atEnd();
  }

  Tick tickFrom(std::int64_t offset, ByteReader& in) const {
    const auto most = static_cast<std::int64_t>(kMaxTick);
    if (offset < -most || offset > most) in.fail();
    return in.good() ? chunk_.first_tick + offset : 0;
  }

  bool plays() {
    Tick last = chunk_.first_tick;
    return list(Section::kPlays, static_cast<std::uint64_t>(layout_.head.plays), [&](ByteReader& in) {
      RecordedPlay play = takePlay(in);
      if (play.tick < last) in.fail();
      last = play.tick;
      if (in.good()) chunk_.plays.push_back(std::move(play));
    });
  }

  RecordedPlay takePlay(ByteReader& in) {
    RecordedPlay play;
    play.tick = chunk_.first_tick + static_cast<Tick>(in.varint(ticks()));
    const std::uint8_t kind = in.byte(), flags = in.byte();
    if (kind > static_cast<std::uint8_t>(RestartKind::kGiven) || flags > 7) in.fail();
    if (!in.good()) return play;
    play.kind = static_cast<RestartKind>(kind);
    play.team = static_cast<TeamId>(flags & 1);
    play.blue_side = static_cast<Side>(flags >> 1 & 1);
    play.defenders_back = (flags & 4) != 0;
    play.delay = static_cast<Tick>(in.varint(kMaxTick));
    play.period = static_cast<int>(in.varint(1000));
    play.play_ticks = static_cast<Tick>(in.varint(kMaxTick));
    for (int& goals : play.score) goals = static_cast<int>(in.varint(1'000'000));
    play.hash = in.fixed<std::uint64_t>();
    readNumbers({&play.ball.x, &play.ball.y}, in);
    const auto present = readFlags(header_.bodies.size(), in);
    for (const std::uint8_t flag : present) {
      RecordedStart& s = play.starts.emplace_back();
      s.present = flag != 0;
      if (!s.present || !in.good()) continue;
      readNumbers({&s.pose.position.x, &s.pose.position.y, &s.pose.heading, &s.velocity.x, &s.velocity.y,
                   &s.angular_velocity, &s.spin.x, &s.spin.y},
                  in);
    }
    return play;
  }

  bool commands() {
    chunk_.commands.resize(robots_ * ticks());
    if (header_.command_step == 0.0) return exactCommands();
    const auto table = this->table(Section::kCommands, 2 * robots_, ticks(), kCommandTrend);
    if (!table) return false;
    for (std::size_t row = 0; row < ticks(); ++row) {
      for (std::size_t robot = 0; robot < robots_; ++robot) {
        chunk_.commands[row * robots_ + robot] = {table->at(2 * robot, row) * header_.command_step,
                                                  table->at(2 * robot + 1, row) * header_.command_step};
      }
    }
    return true;
  }

  bool exactCommands() {
    const auto bytes = openExactly(Section::kCommands, 16 * chunk_.commands.size());
    if (!bytes) return false;
    ByteReader in(*bytes);
    for (WheelSpeeds& command : chunk_.commands) {
      command.left = in.number();
      command.right = in.number();
      if (!std::isfinite(command.left) || !std::isfinite(command.right)) return false;
    }
    return true;
  }

  bool hashes() {
    const auto bytes = openExactly(Section::kTickHashes, 2 * ticks());
    if (!bytes) return false;
    ByteReader in(*bytes);
    chunk_.tick_hashes.resize(ticks());
    for (std::uint16_t& hash : chunk_.tick_hashes) hash = in.fixed<std::uint16_t>();
    return true;
  }

  bool playing() {
    const auto bytes = open(Section::kPlaying, 10 * (ticks() + 1));
    if (!bytes) return false;
    ByteReader in(*bytes);
    for (std::uint8_t value = 1; !in.atEnd(); value ^= 1) {
      const std::size_t run = static_cast<std::size_t>(in.varint(ticks() - chunk_.playing.size()));
      chunk_.playing.insert(chunk_.playing.end(), run, value);
    }
    return in.good() && chunk_.playing.size() == ticks();
  }

  bool checks() {
    const std::size_t bodies = header_.bodies.size();
    const Tick every = header_.control_rate;
    const auto expected = static_cast<std::size_t>(multiplesIn(chunk_.first_tick, chunk_.ticks, every));
    const auto bytes = openExactly(Section::kChecks, 8 * bodies * expected);
    if (!bytes) return false;
    ByteReader in(*bytes);
    for (std::size_t i = 0; i < expected; ++i) {
      RecordedCheck& check = chunk_.checks.emplace_back();
      check.tick = (chunk_.first_tick / every + 1 + static_cast<Tick>(i)) * every;
      check.bodies.resize(bodies);
      for (BodyHash& hash : check.bodies) hash = {in.fixed<std::uint32_t>(), in.fixed<std::uint32_t>()};
    }
    return true;
  }

  bool events() {
    return list(Section::kEvents, layout_.head.events, [&](ByteReader& in) {
      RecordedEvent& event = chunk_.events.emplace_back();
      event.tick = tickFrom(in.signedVarint(), in);
      event.period = in.byte();
      const std::uint8_t team = in.byte();
      if (team > 2) in.fail();
      if (team > 0 && in.good()) event.team = static_cast<TeamId>(team - 1);
      const auto robot = in.varint(256);
      if (robot > 0) event.robot = static_cast<std::uint8_t>(robot - 1);
      event.clause = in.text(kMaxClauseBytes);
      event.law = in.text(kMaxClauseBytes);
      readNumbers(
          {&event.play_time, &event.place.x, &event.place.y, &event.value, &event.threshold, &event.margin},
          in);
    });
  }

  bool drawings() {
    return list(Section::kDrawings, layout_.head.drawings, [&](ByteReader& in) {
      RecordedDrawing& drawing = chunk_.drawings.emplace_back();
      drawing.tick = tickFrom(in.signedVarint(), in);
      const std::uint8_t what = in.byte();
      if (what > 5) in.fail();
      drawing.kind = static_cast<RecordedDrawing::Kind>(in.good() ? what / 2 : 0);
      drawing.team = static_cast<TeamId>(what % 2);
      for (double* value :
           {&drawing.from.x, &drawing.from.y, &drawing.to.x, &drawing.to.y, &drawing.radius}) {
        *value = static_cast<double>(in.signedVarint()) * kDrawingStep;
      }
      drawing.text = in.text();
    });
  }

  bool samples() {
    const Tick every = header_.sample_every;
    const auto rows = header_.level == RecordingLevel::kFull
                          ? static_cast<std::size_t>(multiplesIn(chunk_.first_tick, chunk_.ticks, every))
                          : std::size_t{0};
    const auto table = this->table(Section::kSamples, sampleColumns(header_), rows, kSampleTrend);
    if (!table) return false;
    for (std::size_t row = 0; row < rows; ++row) {
      const Tick tick = (chunk_.first_tick / every + 1 + static_cast<Tick>(row)) * every;
      chunk_.samples.push_back({tick, posesOf(*table, row)});
    }
    return true;
  }

  std::vector<Pose2> posesOf(const Columns& table, std::size_t row) const {
    const double heading_step = sampleHeadingStep(header_);
    std::vector<Pose2> poses;
    poses.reserve(header_.bodies.size());
    std::size_t column = 0;
    for (const RecordedBody& body : header_.bodies) {
      Pose2& pose = poses.emplace_back();
      pose.position.x = table.at(column++, row) * header_.sample_step;
      pose.position.y = table.at(column++, row) * header_.sample_step;
      if (sampleColumns(body.kind) == 3) pose.heading = table.at(column++, row) * heading_step;
    }
    return poses;
  }

  const RecordingHeader& header_;
  const ChunkLayout layout_;
  const std::size_t robots_;
  RecordedChunk chunk_;
};

}  // namespace

tl::expected<ChunkHead, std::string> readChunkHead(BytesView payload, const RecordingHeader& header) {
  ByteReader in(payload);
  return takeHead(in, header);
}

Sections sectionsOf(BytesView payload, const RecordingHeader& header) {
  const auto layout = layoutOf(payload, header);
  return layout ? layout->sections : Sections{};
}

std::uint64_t listBytes(BytesView payload, const RecordingHeader& header) {
  const Sections sections = sectionsOf(payload, header);
  std::uint64_t bytes = 0;
  for (const Section list : {Section::kPlays, Section::kEvents, Section::kDrawings}) {
    // A larger claim is rejected when the list is read.
    bytes += ByteReader(sections[indexOf(list)]).varint(kMaxListBytes);
  }
  return bytes;
}

tl::expected<RecordedChunk, std::string> readChunk(BytesView payload, const RecordingHeader& header) {
  auto layout = layoutOf(payload, header);
  if (!layout) return tl::unexpected(layout.error());
  return ChunkParser(header, std::move(*layout)).parse();
}

}  // namespace fulbito
