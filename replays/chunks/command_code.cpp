#include "replays/chunks/command_code.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "replays/coding/range_coder.hpp"

namespace fulbito {
namespace {

constexpr std::int64_t kFull = std::int64_t{1} << 16;  // 1 as a ratio
constexpr std::int64_t kExactShare = 32;  // of the most change, within which a limit counts as hit
constexpr std::int64_t kExactUnits = 2;   // and so many units more, as the model is rounded to units
constexpr int kSatContexts = 9;
constexpr std::int64_t kMostSteps = std::int64_t{1} << 33;  // of what a residual may say

/// How a value came about: free, at its upper limit, at its lower limit, or held for want of room.
enum : unsigned { kFree, kUpper, kLower, kHeld };

/// What is known of one robot's motors.
struct Motors {
  std::int32_t unit = 1;   ///< its commands are multiples of
  CommandModel model;      ///< in that unit
  std::int64_t exact = 0;  ///< units within which a limit counts as hit
};

/// One robot's wheels: turn is right less left, pace is right and left together.
struct Wheels {
  std::int64_t turn = 0, turn_before = 0;
  std::int64_t pace = 0, pace_before = 0;
  unsigned turn_case = 0, pace_case = 0;  ///< of the last change
  int turn_size = 0, pace_size = 0;       ///< of its residuals
  unsigned same = 0;
};

/// All that is learned in one chunk.
struct Learned {
  std::array<BitModel, 32> same;
  std::array<ChoiceModel<2>, 16> turn_case;
  std::array<ChoiceModel<2>, 32> pace_case;
  ResidualModel turn_limit, turn_free, pace_limit, pace_free;
};

std::int64_t limited(std::int64_t value) { return std::clamp(value, -kMostSteps, kMostSteps); }

/// What a robot on free ground makes of a commanded turn.
std::int64_t reachedTurn(const CommandModel& model, std::int64_t turn) {
  const std::int64_t span = std::int64_t{model.spin_to} - model.spin_from;
  std::int64_t ratio = model.spin_slow;
  if (span > 0) {
    const std::int64_t over =
        std::clamp<std::int64_t>(std::abs(turn), model.spin_from, model.spin_to) - model.spin_from;
    ratio += (std::int64_t{model.spin_fast} - model.spin_slow) * over / span;
  }
  return turn * ratio / kFull;
}

/// Works through a table of commands, one robot's pair of wheels at a time.
template <typename Coder>
class CommandCode {
 public:
  explicit CommandCode(Coder& coder) : coder_(coder) {}

  struct Pair {
    std::int32_t left = 0, right = 0;
  };

  Pair code(const Motors& motors, Wheels& w, Pair wheels) {
    const auto [left, right] = wheels;
    const std::int64_t turn = std::int64_t{right} - left, pace = std::int64_t{right} + left;
    const unsigned same = coder_.bit(learned_.same[w.same * 16 + w.turn_case * 4 + w.pace_case],
                                     turn == w.turn && pace == w.pace ? 1 : 0);
    Wheels next = w;
    next.same = same;
    next.turn_before = w.turn;
    next.pace_before = w.pace;
    if (same == 0) {
      const std::int64_t reached = reachedTurn(motors.model, w.turn);
      codeTurn(motors, w, reached, turn, next);
      codePace(motors, w, std::abs(next.turn - reached), pace, next);
    }
    w = next;
    return {static_cast<std::int32_t>((w.pace - w.turn) / 2),
            static_cast<std::int32_t>((w.pace + w.turn) / 2)};
  }

 private:
  void codeTurn(const Motors& motors, const Wheels& w, std::int64_t reached, std::int64_t turn,
                Wheels& next) {
    const std::int64_t most = motors.model.most_change;
    const std::int64_t change = turn - reached;
    unsigned how = kFree;
    if (std::abs(change - most) <= motors.exact) how = kUpper;
    if (std::abs(change + most) <= motors.exact) how = kLower;
    how = learned_.turn_case[w.turn_case * 4 + w.pace_case].code(coder_, how);
    if (how == kFree) {
      const std::int64_t onward = w.turn_case == kFree ? w.turn + (w.turn - w.turn_before) / 2 : reached;
      const std::int64_t expected = std::clamp(onward, reached - most, reached + most);
      const int context = std::min(w.turn_size, ResidualModel::kContexts - 1);
      next.turn = expected + learned_.turn_free.code(coder_, turn - expected, context, next.turn_size);
    } else {
      const std::int64_t expected = how == kUpper ? reached + most : reached - most;
      const int context = std::min(w.turn_size, kSatContexts - 1);
      next.turn = expected + learned_.turn_limit.code(coder_, turn - expected, context, next.turn_size);
    }
    next.turn = limited(next.turn);
    next.turn_case = how;
  }

  /// What the turn leaves of the wheels' acceleration is what the pace may change by.
  void codePace(const Motors& motors, const Wheels& w, std::int64_t used, std::int64_t pace, Wheels& next) {
    const std::int64_t room = std::max<std::int64_t>(0, motors.model.most_change - used);
    const bool tight = room < motors.exact;
    const std::int64_t change = pace - w.pace;
    unsigned how = kFree;
    if (tight) {
      if (std::abs(change) <= 2 * motors.exact) how = kHeld;
    } else if (std::abs(change - room) <= motors.exact) {
      how = kUpper;
    } else if (std::abs(change + room) <= motors.exact) {
      how = kLower;
    }
    const unsigned turn_case = next.turn_case;
    how = learned_.pace_case[(w.pace_case * 4 + turn_case) * 2 + (tight ? 1 : 0)].code(coder_, how);
    std::int64_t expected = w.pace;
    if (how == kUpper) expected += room;
    if (how == kLower) expected -= room;
    if (how == kFree && w.pace_case == kFree) expected += (w.pace - w.pace_before) / 2;
    // The two have the same parity, as each wheel turns by whole steps.
    expected += (expected ^ next.turn) & 1;
    const bool is_free = how == kFree;
    ResidualModel& residual = is_free ? learned_.pace_free : learned_.pace_limit;
    const int context = std::min(w.pace_size, is_free ? ResidualModel::kContexts - 1 : kSatContexts - 1);
    const std::int64_t half = residual.code(coder_, (pace - expected) / 2, context, next.pace_size);
    // A broken file may leave the range that two wheels can have.
    next.pace = limited(expected + 2 * half);
    next.pace_case = how;
  }

  Coder& coder_;
  Learned learned_;
};

/// The largest number of which all of a robot's commands are multiples; 1 where it never moves.
std::int32_t unitOf(const Columns& table, std::size_t robot) {
  std::int32_t unit = 0;
  for (std::size_t row = 0; row < table.rows() && unit != 1; ++row) {
    for (const std::size_t column : {2 * robot, 2 * robot + 1}) {
      const std::int32_t command = table.at(column, row);
      if (unit == 0 || command % unit != 0) unit = std::gcd(unit, command);
    }
  }
  return std::max(unit, 1);
}

Motors motorsIn(std::int32_t unit, CommandModel model) {
  for (int* steps : {&model.most_change, &model.spin_from, &model.spin_to}) *steps /= unit;
  return {unit, model, model.most_change / kExactShare + kExactUnits};
}

}  // namespace

void packCommands(const Columns& table, const CommandModel& model, Bytes& out) {
  const std::size_t robots = table.columns() / 2;
  std::vector<Motors> motors(robots);
  ByteWriter head(out);
  for (std::size_t robot = 0; robot < robots; ++robot) {
    motors[robot] = motorsIn(unitOf(table, robot), model);
    head.varint(static_cast<std::uint64_t>(motors[robot].unit));
  }
  RangeEncoder coder(out);
  CommandCode<RangeEncoder> code(coder);
  std::vector<Wheels> wheels(robots);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t robot = 0; robot < robots; ++robot) {
      const std::int32_t unit = motors[robot].unit;
      code.code(motors[robot], wheels[robot],
                {table.at(2 * robot, row) / unit, table.at(2 * robot + 1, row) / unit});
    }
  }
  coder.finish();
}

std::optional<Columns> unpackCommands(BytesView bytes, const CommandModel& model, std::size_t columns,
                                      std::size_t rows) {
  const std::size_t robots = columns / 2;
  std::vector<Motors> motors;
  ByteReader head(bytes);
  for (std::size_t robot = 0; robot < robots; ++robot) {
    const auto unit = static_cast<std::int32_t>(head.varint(std::numeric_limits<std::int32_t>::max()));
    if (unit < 1) return std::nullopt;
    motors.push_back(motorsIn(unit, model));
  }
  RangeDecoder coder(head.bytes(head.left()));
  CommandCode<RangeDecoder> code(coder);
  std::vector<Wheels> wheels(robots);
  Columns table(columns, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    table.addRow();
    for (std::size_t robot = 0; robot < robots; ++robot) {
      const auto pair = code.code(motors[robot], wheels[robot], {});
      // A broken file may leave the range of a command.
      const std::int64_t unit = motors[robot].unit;
      table.at(2 * robot, row) = static_cast<std::int32_t>(pair.left * unit);
      table.at(2 * robot + 1, row) = static_cast<std::int32_t>(pair.right * unit);
    }
  }
  if (!coder.good()) return std::nullopt;
  return table;
}

}  // namespace fulbito
