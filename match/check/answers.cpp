#include "match/check/answers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/core/system/stop_request.hpp"
#include "match/check/command_numbers.hpp"
#include "match/check/mirror.hpp"

namespace fulbito {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Tolerance of mirrored numbers: far above the rounding of a double, far below any difference that moves a
// robot.
constexpr double kRounding = 1e-6;
constexpr double kOnAxis = 1e-3;  // [m]

/// [s] time to wait for an answer: all that the team may use, since another check judges slow answers
double patienceOf(const MatchInfo& info) {
  return info.decision_time ? info.decision_time->decision + info.decision_time->bank
                            : std::numeric_limits<double>::infinity();
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool nearly(double a, double b) {
  return std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

template <typename Equal>
bool equalCommands(const RobotCommand& a, const RobotCommand& b, const Equal& equal) {
  const auto x = commandNumbers(a), y = commandNumbers(b);
  return x.size() == y.size() && std::equal(x.begin(), x.end(), y.begin(), equal);
}

template <typename Equal>
bool equalPoses(const TeamPlacement& a, const TeamPlacement& b, const Equal& equal) {
  return std::equal(a.begin(), a.end(), b.begin(), [&](const auto& x, const auto& y) {
    if (!x || !y) return x.has_value() == y.has_value();
    return equal(x->position.x, y->position.x) && equal(x->position.y, y->position.y) &&
           equal(math::sin(x->heading), math::sin(y->heading)) &&
           equal(math::cos(x->heading), math::cos(y->heading));
  });
}

/// Compares `change` applied to the answers `a` with the answers `b`.
template <typename Change, typename Equal>
AnswerDifference compare(const RecordedCalls& told, const TeamAnswers& a, const TeamAnswers& b,
                         const Change& change, const Equal& equal) {
  AnswerDifference found;
  std::size_t at = 0;
  for (const TeamCall& call : told.calls) {
    const auto* decide = std::get_if<DecideCall>(&call);
    if (decide == nullptr) continue;
    if (at >= std::min(a.commands.size(), b.commands.size())) break;
    ++found.compared;
    for (std::size_t i = 0; i < static_cast<std::size_t>(decide->seen.team_size); ++i) {
      if (!decide->seen.own[i].present) continue;
      if (equalCommands(change(a.commands[at].robots[i]), b.commands[at].robots[i], equal)) continue;
      ++found.different;
      if (found.first < 0) found.first = static_cast<int>(at), found.robot = static_cast<int>(i);
      break;
    }
    ++at;
  }
  for (std::size_t i = 0; i < std::min(a.places.size(), b.places.size()); ++i) {
    ++found.compared;
    const auto &x = a.places[i], &y = b.places[i];
    const bool same =
        x && y ? equalPoses(change(x->robots), y->robots, equal) : x.has_value() == y.has_value();
    if (!same) ++found.different;
  }
  return found;
}

}  // namespace

Result<TeamAnswers> answersOf(const TeamChoice& team, const RecordedCalls& told) {
  auto made = makeTeam(team);
  if (!made) return tl::unexpected<Error>(made.error());
  Strategy& asked = **made;
  TeamAnswers answers;
  asked.begin(told.info);
  const double patience = patienceOf(told.info);
  const Overloaded tell{[&](const PlacementRequest& request) {
                          asked.allow(patience);
                          answers.places.push_back(asked.place(request));
                        },
                        [&](const ReadyCall& call) { asked.ready(call.seen); },
                        [&](const DecideCall& call) {
                          asked.allow(patience);
                          asked.ask(call.seen);
                          answers.commands.push_back(asked.decide(call.seen));
                        },
                        [&](const PlayStop& stop) { asked.stopped(stop); }};
  for (const TeamCall& call : told.calls) {
    std::visit(tell, call);
    const TeamCondition& condition = asked.condition();
    if (condition.state == TeamCondition::State::kWell) continue;
    if (condition.state == TeamCondition::State::kCut) {
      return fail(stopRequested() ? ErrorCode::kInterrupted : ErrorCode::kMachine, condition.reason);
    }
    answers.failure = condition.reason.empty() ? "no answer in time" : condition.reason;
    if (std::holds_alternative<DecideCall>(call)) answers.commands.pop_back();
    if (std::holds_alternative<PlacementRequest>(call)) answers.places.pop_back();
    break;
  }
  MatchEnd end;
  end.reason = MatchEnd::Reason::kInterrupted;
  asked.ended(end);
  return answers;
}

RecordedCalls inOtherSeat(RecordedCalls told) {
  told.info.team = other(told.info.team);
  told.info.side = told.info.side == Side::kLeft ? Side::kRight : Side::kLeft;
  return told;
}

RecordedCalls offAxis(RecordedCalls told) {
  const auto on_axis = [](Vec2 ball) { return std::abs(ball.y) < kOnAxis; };
  const auto begins = [&](const TeamCall& call) {
    if (const auto* request = std::get_if<PlacementRequest>(&call)) return on_axis(request->ball);
    const auto* ready = std::get_if<ReadyCall>(&call);
    return ready != nullptr && on_axis(ready->seen.ball.position);
  };
  told.calls.erase(std::find_if(told.calls.begin(), told.calls.end(), begins), told.calls.end());
  return told;
}

RecordedCalls mirrored(RecordedCalls told) {
  const Overloaded turn{[](PlacementRequest& request) { request = mirrored(request); },
                        [](ReadyCall& call) { call.seen = mirrored(call.seen); },
                        [](DecideCall& call) { call.seen = mirrored(call.seen); },
                        [](PlayStop& stop) { stop = mirrored(stop); }};
  for (TeamCall& call : told.calls) std::visit(turn, call);
  return told;
}

AnswerDifference compareAnswers(const RecordedCalls& told, const TeamAnswers& a, const TeamAnswers& b) {
  return compare(told, a, b, [](const auto& same) { return same; }, sameBits);
}

AnswerDifference compareMirrored(const RecordedCalls& told, const TeamAnswers& a, const TeamAnswers& mirror) {
  return compare(told, a, mirror, [](const auto& value) { return mirrored(value); }, nearly);
}

}  // namespace fulbito
