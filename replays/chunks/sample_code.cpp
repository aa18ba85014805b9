#include "replays/chunks/sample_code.hpp"

#include <algorithm>

#include "replays/chunks/chunk_format.hpp"
#include "replays/coding/range_coder.hpp"

namespace fulbito {
namespace {

constexpr int kContexts = 10;
constexpr std::int64_t kMostSteps = std::int64_t{1} << 33;

/// One quantity over time.
struct Track {
  std::int64_t last = 0, before = 0;
  int size = 0;  ///< of its residual
};
struct BodyTracks {
  Track x, y, heading;
};

/// What is learned of one kind of body in a chunk.
struct Learned {
  ResidualModel x, y, heading;
};

template <typename Coder>
class SampleCode {
 public:
  SampleCode(Coder& coder, int turn) : coder_(coder), turn_(turn) {}

  /// @{ Each takes the value when writing and gives it when reading. A body goes on as it went; how far from
  /// that it was goes with how far it was before, and with how far its other quantities are.
  std::int64_t x(BodyTracks& body, Learned& learned, std::int64_t value) {
    return place(body.x, learned.x, value, (body.x.size + body.y.size + 1) / 2);
  }
  std::int64_t y(BodyTracks& body, Learned& learned, std::int64_t value) {
    return place(body.y, learned.y, value, (body.y.size + 2 * body.x.size + 1) / 3);
  }
  std::int64_t heading(BodyTracks& body, Learned& learned, std::int64_t value) {
    Track& track = body.heading;
    const std::int64_t expected = 2 * track.last - track.before;
    const int context = std::min((track.size + body.x.size + 1) / 2, kContexts - 1);
    const std::int64_t off = learned.heading.code(coder_, wrapped(value - expected), context, track.size);
    return moved(track, wrapped(expected + off));
  }
  /// @}

 private:
  std::int64_t place(Track& track, ResidualModel& model, std::int64_t value, int context) {
    const std::int64_t expected = 2 * track.last - track.before;
    const std::int64_t off =
        model.code(coder_, value - expected, std::min(context, kContexts - 1), track.size);
    return moved(track, std::clamp(expected + off, -kMostSteps, kMostSteps));
  }
  static std::int64_t moved(Track& track, std::int64_t value) {
    track.before = track.last;
    return track.last = value;
  }
  /// The same heading from half a turn to the right to just below half a turn to the left.
  std::int64_t wrapped(std::int64_t steps) const {
    const std::int64_t half = turn_ / 2;
    const std::int64_t over = (steps + half) % turn_;
    return (over < 0 ? over + turn_ : over) - half;
  }

  Coder& coder_;
  const std::int64_t turn_;
};

/// Calls `body` for every body with its tracks, what was learned of its kind, and its first column.
class Bodies {
 public:
  explicit Bodies(const RecordingHeader& header) : header_(header), tracks_(header.bodies.size()) {}

  template <typename Each>
  void forEach(const Each& each) {
    std::size_t column = 0;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      const BodyKind kind = header_.bodies[i].kind;
      each(tracks_[i], learned_[static_cast<std::size_t>(kind)], column, sampleColumns(kind) == 3);
      column += sampleColumns(kind);
    }
  }

 private:
  const RecordingHeader& header_;
  std::vector<BodyTracks> tracks_;
  std::array<Learned, 4> learned_;  ///< by BodyKind
};

}  // namespace

void packSamples(const Columns& table, const RecordingHeader& header, Bytes& out) {
  RangeEncoder coder(out);
  SampleCode<RangeEncoder> code(coder, header.sample_turn);
  Bodies bodies(header);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    bodies.forEach([&](BodyTracks& body, Learned& learned, std::size_t column, bool turns) {
      code.x(body, learned, table.at(column, row));
      code.y(body, learned, table.at(column + 1, row));
      if (turns) code.heading(body, learned, table.at(column + 2, row));
    });
  }
  coder.finish();
}

std::optional<Columns> unpackSamples(BytesView bytes, const RecordingHeader& header, std::size_t rows) {
  RangeDecoder coder(bytes);
  SampleCode<RangeDecoder> code(coder, header.sample_turn);
  Bodies bodies(header);
  Columns table(sampleColumns(header), rows);
  for (std::size_t row = 0; row < rows; ++row) {
    table.addRow();
    bodies.forEach([&](BodyTracks& body, Learned& learned, std::size_t column, bool turns) {
      table.at(column, row) = static_cast<std::int32_t>(code.x(body, learned, 0));
      table.at(column + 1, row) = static_cast<std::int32_t>(code.y(body, learned, 0));
      if (turns) table.at(column + 2, row) = static_cast<std::int32_t>(code.heading(body, learned, 0));
    });
  }
  if (!coder.good()) return std::nullopt;
  return table;
}

}  // namespace fulbito
