#include "tournament/store/match_line.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/system/error_text.hpp"
#include "fulbito/detail/state_hash.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

/// The parts of a line, in their order.
enum Part : std::size_t {
  kId,
  kTeamNames,
  kStart,
  kSeed,
  kScore,
  kWinner,
  kGoalsAfterFoul,
  kTicks,
  kHash,
  kOutcome,
  kFaults,
  kAbandoned,
  kSum
};
constexpr const char* kKeys[] = {
    "id",    "teams",      "start",   "seed",   "score",     "winner", "goals_after_foul",
    "ticks", "final_hash", "outcome", "faults", "abandoned", "sum"};

/// A count of `TeamFaults` and its key.
struct FaultCount {
  const char* key;
  std::int64_t TeamFaults::* count;
};
constexpr FaultCount kCounts[] = {
    {"not_finite", &TeamFaults::not_finite}, {"no_navigator", &TeamFaults::no_navigator},
    {"saturated", &TeamFaults::saturated},   {"late", &TeamFaults::late},
    {"stale", &TeamFaults::stale},           {"failures", &TeamFaults::failures}};
constexpr const char* kFailure = "failure";
constexpr const char* kForfeited = "forfeited";

constexpr std::string_view kBeforeSum = R"(,"sum":")";
constexpr std::string_view kAfterSum = "\"}";
constexpr std::size_t kHashDigits = 16;
constexpr std::size_t kSumSize = kBeforeSum.size() + kHashDigits + kAfterSum.size();

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string hexText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::optional<std::uint64_t> hexValue(std::string_view text) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole && text.size() == kHashDigits ? std::optional(value) : std::nullopt;
}

/// Hash of the bytes before the checksum.
std::uint64_t sumOf(std::string_view bytes) {
  StateHash hash;
  hash.add(bytes);
  return hash.value();
}

bool isPlain(char c) { return c >= 0x20 && c < 0x7f; }

std::string storedText(const std::string& text) {
  if (text.size() <= kLongestRowText && std::all_of(text.begin(), text.end(), isPlain)) return text;
  // The library itself knows what it replaces when it writes.
  return shortened(Json::parse(dumped(text)).get<std::string>(), kLongestRowText);
}

Json faultsJson(const TeamFaults& faults) {
  Json json = Json::object();
  for (const FaultCount& entry : kCounts) {
    if (const std::int64_t count = faults.*entry.count; count != 0) json[entry.key] = count;
  }
  if (!faults.failure.empty()) json[kFailure] = faults.failure;
  if (faults.forfeited) json[kForfeited] = true;
  return json;
}

Json rowJson(const MatchRow& row) {
  const MatchResult& result = row.result;
  Json json{{kKeys[kId], row.id.text()},
            {kKeys[kTeamNames], row.teams},
            {kKeys[kStart], row.start},
            {kKeys[kSeed], row.seed},
            {kKeys[kScore], result.score},
            {kKeys[kWinner], result.winner ? Json(nameOf(*result.winner)) : Json(nullptr)},
            {kKeys[kGoalsAfterFoul], result.goals_after_foul},
            {kKeys[kTicks], result.ticks},
            {kKeys[kHash], hexText(result.hash)},
            {kKeys[kOutcome], nameOf(result.outcome)},
            {kKeys[kFaults], {faultsJson(result.faults.teams[0]), faultsJson(result.faults.teams[1])}}};
  if (result.faults.abandoned) json[kKeys[kAbandoned]] = result.faults.abandoned->message;
  return json;
}

/// Reads a line as it was written: each key once, in its order. Without a tree in memory, a log of 100,000
/// matches is read in half the time.
class RowReader final : public nlohmann::json_sax<Json> {
 public:
  bool key(string_t& name) override { return depth_ == 1 ? rowKey(name) : faultKey(name); }
  bool start_object(std::size_t) override {
    const bool is_team = depth_ == 1 && part_ == kFaults && in_array_ && at_ < kTeams.size();
    fault_ = kNoFault;
    return ++depth_ == 1 || is_team;
  }
  bool end_object() override {
    at_ += depth_ == 2 ? 1 : 0;
    return --depth_ == 1 || part_ == kSum;
  }
  bool start_array(std::size_t) override {
    if (depth_ != 1 || !isArray() || in_array_) return false;
    return in_array_ = true;
  }
  bool end_array() override {
    in_array_ = false;
    return at_ == kTeams.size();
  }
  bool null() override { return depth_ == 1 && part_ == kWinner; }
  bool boolean(bool value) override {
    return faults() != nullptr && fault_ == kForfeitedAt && (faults()->forfeited = value);
  }
  // Only a score is below zero, after a walk-over.
  bool number_integer(number_integer_t value) override {
    const bool score = depth_ == 1 && part_ == kScore && in_array_ && at_ < kTeams.size();
    return score && set(row_.result.score[at_++], value);
  }
  bool number_unsigned(number_unsigned_t value) override {
    return depth_ == 2 ? faultNumber(value) : rowNumber(value);
  }
  bool number_float(number_float_t, const string_t&) override { return false; }
  bool string(string_t& text) override { return depth_ == 2 ? faultText(text) : rowText(text); }
  bool binary(binary_t&) override { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

  MatchRow& row() { return row_; }
  /// Where the reading is or stopped.
  const char* part() const { return part_ < std::size(kKeys) ? kKeys[part_] : kKeys[kId]; }
  bool isWhole() const { return depth_ == 0 && part_ == kSum; }

 private:
  static constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);
  static constexpr std::size_t kNoFault = static_cast<std::size_t>(-1);
  static constexpr std::size_t kFailureAt = std::size(kCounts);
  static constexpr std::size_t kForfeitedAt = kFailureAt + 1;

  bool isArray() const {
    return part_ == kTeamNames || part_ == kScore || part_ == kGoalsAfterFoul || part_ == kFaults;
  }
  bool rowKey(const string_t& name) {
    at_ = 0;
    ++part_;
    if (part_ == kAbandoned && name != kKeys[kAbandoned]) ++part_;
    return part_ < std::size(kKeys) && name == kKeys[part_];
  }
  bool faultKey(const string_t& name) {
    const std::size_t before = fault_;
    const auto* entry = std::find_if(std::begin(kCounts), std::end(kCounts),
                                     [&](const FaultCount& c) { return name == c.key; });
    fault_ = static_cast<std::size_t>(entry - std::begin(kCounts));
    if (fault_ == kFailureAt && name == kForfeited) fault_ = kForfeitedAt;
    const bool known = fault_ != kFailureAt || name == kFailure;
    return known && (before == kNoFault || fault_ > before);
  }
  TeamFaults* faults() { return depth_ == 2 ? &row_.result.faults.teams[at_] : nullptr; }
  bool faultNumber(std::uint64_t value) {
    return fault_ < kFailureAt && set(faults()->*kCounts[fault_].count, value);
  }
  bool faultText(string_t& text) {
    if (fault_ != kFailureAt) return false;
    faults()->failure = std::move(text);
    return true;
  }
  bool rowNumber(std::uint64_t value) {
    MatchResult& result = row_.result;
    if (in_array_ != isArray() || at_ >= kTeams.size()) return false;
    if (part_ == kSeed) return set(row_.seed, value);
    if (part_ == kTicks) return set(result.ticks, value);
    if (part_ == kScore) return set(result.score[at_++], value);
    return part_ == kGoalsAfterFoul && set(result.goals_after_foul[at_++], value);
  }
  bool rowText(string_t& text) {
    if (in_array_ != isArray() || at_ >= kTeams.size()) return false;
    switch (part_) {
      case kId:
        return take(row_.id, MatchId::parse(text));
      case kTeamNames:
        return move(row_.teams[at_++], text);
      case kStart:
        return move(row_.start, text);
      case kWinner:
        return winner(text);
      case kHash:
        return take(row_.result.hash, hexValue(text));
      case kOutcome:
        return take(row_.result.outcome, outcomeOf(text));
      case kAbandoned:
        return abandoned(text);
      default:
        return part_ == kSum;
    }
  }
  bool winner(std::string_view text) {
    for (const TeamId team : kTeams) {
      if (text == nameOf(team)) row_.result.winner = team;
    }
    return row_.result.winner.has_value();
  }
  bool abandoned(string_t& text) {
    row_.result.faults.abandoned = Error{ErrorCode::kBadInput, std::move(text)};
    return true;
  }
  template <typename T, typename Value>
  static bool set(T& place, Value value) {
    place = static_cast<T>(value);
    return std::in_range<T>(value);
  }
  template <typename T>
  static bool take(T& place, const std::optional<T>& value) {
    if (value) place = *value;
    return value.has_value();
  }
  static bool move(std::string& place, string_t& text) {
    place = std::move(text);
    return true;
  }

  MatchRow row_;
  std::size_t depth_ = 0, part_ = kNoPart, fault_ = kNoFault;
  std::size_t at_ = 0;  ///< index in the array
  bool in_array_ = false;
};

}  // namespace

std::string_view logHeader() {
  static const std::string header =
      dumped(Json{{"schema_version", kMatchLogVersion}, {"content", "matches"}}) + '\n';
  return header;
}

MatchRow storedForm(MatchRow row) {
  for (std::string& name : row.teams) name = storedText(name);
  row.start = storedText(row.start);
  MatchFaults& faults = row.result.faults;
  for (TeamFaults& team : faults.teams) team.failure = storedText(team.failure);
  if (faults.abandoned) faults.abandoned = Error{ErrorCode::kBadInput, storedText(faults.abandoned->message)};
  return row;
}

bool sameResult(const MatchResult& a, const MatchResult& b) {
  const auto values = [](const MatchResult& r) {
    return std::tie(r.score, r.winner, r.goals_after_foul, r.ticks, r.hash, r.outcome);
  };
  const auto same_faults = [](const TeamFaults& x, const TeamFaults& y) {
    return x.forfeited == y.forfeited &&
           std::all_of(std::begin(kCounts), std::end(kCounts),
                       [&](const FaultCount& c) { return x.*c.count == y.*c.count; });
  };
  return values(a) == values(b) &&
         std::equal(a.faults.teams.begin(), a.faults.teams.end(), b.faults.teams.begin(), same_faults) &&
         a.faults.abandoned.has_value() == b.faults.abandoned.has_value();
}

std::string toLine(const MatchRow& row) {
  std::string line = dumped(rowJson(storedForm(row)));
  line.pop_back();  // the checksum comes before the last brace
  return fmt::format("{}{}{}{}\n", line, kBeforeSum, hexText(sumOf(line)), kAfterSum);
}

bool isIntact(std::string_view line) {
  if (line.size() <= kSumSize) return false;
  const std::string_view bytes = line.substr(0, line.size() - kSumSize);
  std::string_view sum = line.substr(bytes.size());
  if (!sum.starts_with(kBeforeSum) || !sum.ends_with(kAfterSum)) return false;
  return hexValue(sum.substr(kBeforeSum.size(), kHashDigits)) == sumOf(bytes);
}

Result<MatchRow> parseLine(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (!isIntact(line)) return fail(ErrorCode::kBadInput, "the line is damaged: its checksum differs");
  RowReader reader;
  if (!Json::sax_parse(line, &reader) || !reader.isWhole()) {
    return fail(ErrorCode::kBadInput, fmt::format("not a match: '{}' is missing or wrong", reader.part()));
  }
  return std::move(reader.row());
}

}  // namespace fulbito
