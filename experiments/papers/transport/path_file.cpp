#include "experiments/papers/transport/path_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "experiments/papers/transport/path_fit.hpp"
#include "experiments/papers/transport/rod_constraint.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito {
namespace {

constexpr double kCentimetre = 0.01;           // [m]
constexpr double kDegree = math::kPi / 180.0;  // [rad]
constexpr double kRounding = 0.001;            // [m] rounding of printed coordinates
constexpr double kFarthest = 100.0;            // [m] limit of coordinates
constexpr std::size_t kMostRows = 10000;

/// A row of the file.
struct Row {
  std::size_t line = 0;
  std::string word;
  std::vector<double> numbers;

  Vec2 point() const { return Vec2{numbers[0], numbers[1]} * kCentimetre; }
  double angle() const { return numbers[2] * kDegree; }
};

/// A word of the file format and the numbers after it.
struct Word {
  const char* name;
  std::size_t numbers;
  const char* form;
  std::size_t more = 0;  // number of optional numbers after the required ones
};

constexpr Word kWords[] = {{"rod", 1, "rod LENGTH"},
                           {"speed", 1, "speed V"},
                           {"max-speed", 1, "max-speed V"},
                           {"lead", 2, "lead X Y"},
                           {"follower", 2, "follower X Y"},
                           {"line", 3, "line X Y SLOPE [LENGTH]", 1},
                           {"arc", 3, "arc X Y ANGLE"},
                           {"start", 2, "start X Y"},
                           {"end", 2, "end X Y"},
                           {"point", 2, "point X Y"},
                           {"tolerance", 1, "tolerance LENGTH"}};

constexpr std::string_view kBlanks = " \t\r";

std::vector<std::string_view> wordsOf(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::optional<double> numberOf(std::string_view word) {
  double value = 0.0;
  const char *begin = word.data(), *end = begin + word.size();
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || rest != end || !(std::abs(value) <= kFarthest / kCentimetre)) return {};
  return value;
}

/// Makes a task from the rows of a file.
class Reader {
 public:
  explicit Reader(std::string origin) : origin_(std::move(origin)) {}

  Result<TransportTask> read(std::string_view text);

 private:
  tl::unexpected<Error> wrong(std::size_t line, const std::string& what) const {
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: {}", origin_, line, what));
  }
  Result<void> readRow(std::size_t line, std::string_view text);
  Result<void> keep(Row row, bool single);
  const Row* find(std::string_view word) const;
  double lengthOf(std::string_view word, double otherwise) const;
  Result<PartPath> path();
  Result<PartPath> fitted() const;
  Result<Vec2> beginning() const;
  Result<Vec2> targetOf(std::size_t i, Vec2 from) const;
  Result<Arc> lineAt(std::size_t i, Vec2 from) const;
  Result<Arc> arcAt(std::size_t i, Vec2 from) const;
  Result<void> setPlaces(TransportTask& task) const;
  Result<double> placeOf(const TransportTask& task, const Row& row) const;

  std::string origin_;
  std::size_t lines_ = 0;
  std::vector<Row> parts_;   // in the order of the path
  std::vector<Row> points_;  // in the order of a polyline
  std::vector<Row> single_;
};

Result<void> Reader::keep(Row row, bool single) {
  if (single && find(row.word) != nullptr)
    return wrong(row.line, fmt::format("'{}' stands in line {} already", row.word, find(row.word)->line));
  std::vector<Row>& rows = single ? single_ : row.word == "point" ? points_ : parts_;
  if (rows.size() == kMostRows) return wrong(row.line, fmt::format("more than {} rows", kMostRows));
  rows.push_back(std::move(row));
  return {};
}

Result<void> Reader::readRow(std::size_t line, std::string_view text) {
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.empty()) return {};
  const Word* known = std::find_if(std::begin(kWords), std::end(kWords),
                                   [&](const Word& word) { return words[0] == word.name; });
  if (known == std::end(kWords)) return wrong(line, fmt::format("unknown word '{}'", words[0]));
  Row row{line, known->name, {}};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<double> number = numberOf(words[i]);
    if (!number)
      return wrong(line, fmt::format("'{}' is not a number in -{:g} ... {:g}", words[i],
                                     kFarthest / kCentimetre, kFarthest / kCentimetre));
    row.numbers.push_back(*number);
  }
  if (row.numbers.size() < known->numbers || row.numbers.size() > known->numbers + known->more)
    return wrong(line, fmt::format("expected '{}'", known->form));
  const bool many = row.word == "line" || row.word == "arc" || row.word == "point";
  return keep(std::move(row), !many);
}

const Row* Reader::find(std::string_view word) const {
  const auto found =
      std::find_if(single_.begin(), single_.end(), [&](const Row& row) { return row.word == word; });
  return found == single_.end() ? nullptr : &*found;
}

double Reader::lengthOf(std::string_view word, double otherwise) const {
  const Row* row = find(word);
  return row == nullptr ? otherwise : row->numbers[0] * kCentimetre;
}

Result<PartPath> Reader::fitted() const {
  if (!parts_.empty()) return wrong(parts_[0].line, "a path has either points, or lines and arcs");
  std::vector<Vec2> points;
  points.reserve(points_.size());
  for (const Row& row : points_) points.push_back(row.point());
  PathFit fit;
  fit.tolerance = lengthOf("tolerance", fit.tolerance);
  auto path = fitPath(points, fit);
  if (!path) return wrong(points_[0].line, path.error().message);
  return path;
}

Result<Vec2> Reader::beginning() const {
  const Row* start = find("start");
  if (start != nullptr) return start->point();
  if (parts_[0].word == "line") return parts_[0].point();
  return wrong(parts_[0].line, "a path that begins with an arc needs a row 'start X Y'");
}

// The point beside which a line ends: the next part's point, or the path's end.
Result<Vec2> Reader::targetOf(std::size_t i, Vec2 from) const {
  if (i + 1 < parts_.size()) return parts_[i + 1].point();
  const Row* end = find("end");
  if (end == nullptr) return wrong(parts_[i].line, "a path that ends with a line needs a row 'end X Y'");
  const Vec2 ahead = math::unit(parts_[i].angle());
  if (std::abs(cross(ahead, end->point() - from)) > kRounding)
    return wrong(end->line, "the end is not on the last line");
  return end->point();
}

Result<Arc> Reader::lineAt(std::size_t i, Vec2 from) const {
  const Row& row = parts_[i];
  if (distance(row.point(), from) > kRounding)
    return wrong(row.line,
                 fmt::format("the line begins at ({:g}, {:g}), but the part before ends at ({:.2f}, {:.2f})",
                             row.numbers[0], row.numbers[1], from.x / kCentimetre, from.y / kCentimetre));
  Arc line{{from, math::wrapAngle(row.angle())}, 0.0, 0.0};
  if (row.numbers.size() > 3) {
    line.length = row.numbers[3] * kCentimetre;
    if (!(line.length > 0.0)) return wrong(row.line, "a line's length must be above 0");
    return line;
  }
  auto target = targetOf(i, from);
  if (!target) return tl::unexpected<Error>(target.error());
  line.length = dot(math::unit(row.angle()), *target - from);
  if (!(line.length > 0.0)) return wrong(row.line, "the line would end before it begins");
  const bool joins = i + 1 == parts_.size() || parts_[i + 1].word == "arc" ||
                     distance(endOf(line).position, *target) <= kRounding;
  if (!joins) return wrong(parts_[i + 1].line, "the line does not begin on the line before");
  return line;
}

Result<Arc> Reader::arcAt(std::size_t i, Vec2 from) const {
  const Row& row = parts_[i];
  const Vec2 out = from - row.point();
  const double radius = norm(out), side = row.angle() < 0.0 ? -1.0 : 1.0;
  if (radius < kRounding) return wrong(row.line, "the arc begins at its own centre");
  if (row.angle() == 0.0 || std::abs(row.angle()) >= 2 * math::kPi)
    return wrong(row.line, "an arc's angle must be above 0 and below 360 degrees to either side");
  return Arc{{from, math::angleOf(perp(out) * side)}, side / radius, std::abs(row.angle()) * radius};
}

Result<PartPath> Reader::path() {
  if (!points_.empty()) return fitted();
  if (parts_.empty()) return wrong(lines_, "no 'line', 'arc' or 'point' in the file");
  auto from = beginning();
  if (!from) return tl::unexpected<Error>(from.error());
  std::vector<Arc> parts;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto part = parts_[i].word == "line" ? lineAt(i, *from) : arcAt(i, *from);
    if (!part) return tl::unexpected<Error>(part.error());
    parts.push_back(*part);
    *from = endOf(*part).position;
  }
  return PartPath(std::move(parts));
}

Result<double> Reader::placeOf(const TransportTask& task, const Row& row) const {
  const double q = task.path.nearest(row.point());
  const double off = distance(task.path.pose(q).position, row.point());
  if (off > kRounding)
    return wrong(row.line,
                 fmt::format("the {} starts {:.1f} cm beside the path", row.word, off / kCentimetre));
  return q;
}

Result<void> Reader::setPlaces(TransportTask& task) const {
  if (const Row* row = find("follower"); row != nullptr) {
    auto place = placeOf(task, *row);
    if (!place) return tl::unexpected<Error>(place.error());
    task.follower = *place;
  }
  const Row* row = find("lead");
  if (row == nullptr) {
    auto ahead = rodLengthAhead(task.path, task.follower, task.rod);
    if (!ahead) return wrong(lines_, ahead.error().message);
    task.lead = *ahead;
    return {};
  }
  auto place = placeOf(task, *row);
  if (!place) return tl::unexpected<Error>(place.error());
  const Vec2 follower = task.path.pose(task.follower).position;
  const double apart = distance(task.path.pose(*place).position, follower);
  if (std::abs(apart - task.rod) > kRounding)
    return wrong(row->line,
                 fmt::format("the lead starts {:.2f} cm from the follower, but the rod has {:.2f} cm",
                             apart / kCentimetre, task.rod / kCentimetre));
  task.lead = onRod(task.path, follower, {task.path.partAt(*place), *place}, task.rod);
  return {};
}

Result<void> within(double value, double low, double high, const std::string& origin, const char* word) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kBadInput,
              fmt::format("{}: {} must be {:g} ... {:g} (cm, s), not {:g}", origin, word, low / kCentimetre,
                          high / kCentimetre, value / kCentimetre));
}

Result<void> checkRanges(const TransportTask& task, const std::string& origin) {
  if (auto rod = within(task.rod, 0.01, 10.0, origin, "rod"); !rod) return rod;
  if (auto fastest = within(task.max_speed, 1e-4, 10.0, origin, "max-speed"); !fastest) return fastest;
  if (auto length = within(task.path.length(), 0.01, 1000.0, origin, "the path's length"); !length)
    return length;
  return within(task.speed, 1e-4, task.max_speed, origin, "speed");
}

Result<TransportTask> Reader::read(std::string_view text) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (auto row = readRow(++lines_, text.substr(at, end - at)); !row)
      return tl::unexpected<Error>(row.error());
    at = end + 1;
  }
  auto path = this->path();
  if (!path) return tl::unexpected<Error>(path.error());
  TransportTask task;
  task.path = std::move(*path);
  task.rod = lengthOf("rod", task.rod);
  task.speed = lengthOf("speed", task.speed);
  task.max_speed = lengthOf("max-speed", task.max_speed);
  if (auto checked = checkRanges(task, origin_); !checked) return tl::unexpected<Error>(checked.error());
  if (auto set = setPlaces(task); !set) return tl::unexpected<Error>(set.error());
  return task;
}

std::string pointText(const char* word, Vec2 at) {
  return fmt::format("{} {:.5f} {:.5f}", word, at.x / kCentimetre, at.y / kCentimetre);
}

std::string partText(const Arc& part) {
  if (part.curvature == 0.0)
    return fmt::format("{} {:.8f} {:.5f}\n", pointText("line", part.start.position),
                       part.start.heading / kDegree, part.length / kCentimetre);
  const Vec2 centre = part.start.position + perp(math::unit(part.start.heading)) / part.curvature;
  return fmt::format("{} {:.8f}\n", pointText("arc", centre), part.turn() / kDegree);
}

}  // namespace

Result<TransportTask> parseTransport(std::string_view text, const std::string& origin) {
  return Reader(origin).read(text);
}

Result<TransportTask> loadTransport(const std::string& file) {
  constexpr std::size_t kLargestFile = 1 << 20;
  auto text = readSettingFile(file, kLargestFile);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseTransport(*text, file);
}

std::string toText(const TransportTask& task) {
  const PartPath& path = task.path;
  std::string text = fmt::format("rod {:.5f}\nspeed {:.5f}\nmax-speed {:.5f}\n", task.rod / kCentimetre,
                                 task.speed / kCentimetre, task.max_speed / kCentimetre);
  text += pointText("lead", path.pose(task.lead).position) + "\n";
  text += pointText("follower", path.pose(task.follower).position) + "\n";
  text += pointText("start", path.pose(0.0).position) + "\n";
  for (const Arc& part : path.parts()) text += partText(part);
  return text;
}

TransportTask builtInTransport(std::string_view name) {
  for (const PathText& file : embeddedPaths()) {
    if (file.name == name) return parseTransport(file.text, std::string(file.file)).value();
  }
  return {};
}

}  // namespace fulbito
