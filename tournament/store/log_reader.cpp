#include "tournament/store/log_reader.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/error_text.hpp"
#include "engine/core/system/regular_file.hpp"
#include "engine/core/system/repeat_call.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;  // [bytes] per read

/// Reads a file line by line.
class LineReader {
 public:
  LineReader(int descriptor, const std::string& file) : descriptor_(descriptor), file_(file) {}

  /// The next line without its line end, valid until the next call; empty after the last whole line.
  Result<std::optional<std::string_view>> next();
  /// Number of the last line, from 1.
  std::size_t line() const { return line_; }
  /// Offset of the end of the last line, and of its begin [bytes].
  std::uint64_t end() const { return end_; }
  std::uint64_t begin() const { return begin_; }
  /// Bytes after the last whole line; valid once `next` has returned nothing.
  std::string_view rest() const { return std::string_view(buffer_).substr(at_); }
  /// Whether the last line is the end of the file.
  Result<bool> isLast();

 private:
  /// Reads more of the file. @return whether there was more
  Result<bool> fill();

  const int descriptor_;
  const std::string& file_;
  std::string buffer_;
  std::size_t at_ = 0;  ///< index of the next line in the buffer
  std::size_t line_ = 0;
  std::uint64_t begin_ = 0, end_ = 0;
};

Result<bool> LineReader::fill() {
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t had = buffer_.size();
  buffer_.resize(had + kStep);
  const ssize_t n = repeatCall([&] { return ::read(descriptor_, buffer_.data() + had, kStep); });
  buffer_.resize(had + static_cast<std::size_t>(n < 0 ? 0 : n));
  if (n < 0) return ioFailure("read", file_, errno);
  return n > 0;
}

Result<std::optional<std::string_view>> LineReader::next() {
  for (std::size_t searched = 0;;) {
    const std::size_t found = buffer_.find('\n', at_ + searched);
    if (found != std::string::npos) {
      const std::string_view text = std::string_view(buffer_).substr(at_, found - at_);
      ++line_;
      begin_ = end_;
      end_ += text.size() + 1;
      at_ = found + 1;
      return text;
    }
    searched = buffer_.size() - at_;
    if (searched > kLongestLine)
      return fail(ErrorCode::kBadInput, fmt::format("{}:{}: the line is too long", file_, line_ + 1));
    const auto more = fill();
    if (!more) return tl::unexpected<Error>(more.error());
    if (!*more) return std::optional<std::string_view>();
  }
}

Result<bool> LineReader::isLast() {
  if (at_ < buffer_.size()) return false;
  return fill().map([](bool more) { return !more; });
}

/// Reads the rows of one log.
class LogReading {
 public:
  LogReading(int descriptor, const std::string& file, const RowReceiver& receive)
      : file_(file), receive_(receive), lines_(descriptor, file) {}

  Result<LogEnd> readAll();

 private:
  tl::unexpected<Error> wrong(Error error) const {
    return inFile(fmt::format("{}:{}", file_, lines_.line()), std::move(error));
  }
  tl::unexpected<Error> noLog() const {
    const std::string_view header = logHeader().substr(0, logHeader().size() - 1);
    return fail(ErrorCode::kBadInput,
                fmt::format("{}:1: not a log of matches that this version reads: it does not begin with {}",
                            file_, header));
  }
  Result<void> take(std::string_view line);
  Result<void> takeDamaged();
  Result<void> takeRest();

  const std::string& file_;
  const RowReceiver& receive_;
  LineReader lines_;
  LogEnd end_;
};

Result<LogEnd> LogReading::readAll() {
  for (;;) {
    const auto line = lines_.next();
    if (!line) return tl::unexpected<Error>(line.error());
    const auto taken = *line ? take(**line) : takeRest();
    if (!taken) return tl::unexpected<Error>(taken.error());
    if (!*line || end_.torn) return end_;
  }
}

Result<void> LogReading::take(std::string_view line) {
  const bool is_header = line == logHeader().substr(0, logHeader().size() - 1);
  if (lines_.line() == 1 && !is_header) return noLog();
  if (!is_header) {
    if (!isIntact(line)) return takeDamaged();
    auto row = parseLine(line);
    if (!row) return wrong(std::move(row.error()));
    if (auto received = receive_(std::move(*row), lines_.line()); !received)
      return wrong(std::move(received.error()));
  }
  end_.size = lines_.end();
  return {};
}

Result<void> LogReading::takeDamaged() {
  const auto last = lines_.isLast();
  if (!last) return tl::unexpected<Error>(last.error());
  end_.torn = true;
  if (*last) return {};
  return wrong({ErrorCode::kBadInput, "the line is damaged: its checksum differs"});
}

Result<void> LogReading::takeRest() {
  end_.torn = !lines_.rest().empty();
  // Only a log may have a torn header; any other file must not be overwritten.
  return lines_.line() > 0 || logHeader().starts_with(lines_.rest()) ? Result<void>() : noLog();
}

tl::unexpected<Error> twice(const MatchId& id) {
  return fail(ErrorCode::kBadInput,
              fmt::format("match {} is there twice, with different results", id.text()));
}

}  // namespace

Result<LogEnd> readRows(int descriptor, const std::string& file, const RowReceiver& receive) {
  return LogReading(descriptor, file, receive).readAll();
}

Result<LogEnd> readRows(const std::string& file, bool may_miss, const RowReceiver& receive) {
  std::error_code unknown;
  if (may_miss &&
      std::filesystem::symlink_status(file, unknown).type() == std::filesystem::file_type::not_found) {
    return LogEnd();
  }
  const auto opened = RegularFile::open("read", file, O_RDONLY);
  return opened ? readRows(opened->descriptor(), file, receive) : tl::unexpected<Error>(opened.error());
}

RowReceiver keepIn(MatchMemory& memory) {
  return [&memory](MatchRow row, std::size_t) -> Result<void> {
    const MatchId id = row.id;
    return memory.take(std::move(row)) == Added::kDifferent ? twice(id) : Result<void>();
  };
}

Result<std::vector<MatchRow>> readMatchLog(const std::string& file, bool may_miss) {
  std::vector<MatchRow> rows;
  std::unordered_map<MatchId, std::size_t, WordOfId> places;
  const auto end = readRows(file, may_miss, [&](MatchRow row, std::size_t) -> Result<void> {
    const auto [place, is_new] = places.try_emplace(row.id, rows.size());
    if (!is_new) return sameResult(rows[place->second].result, row.result) ? Result<void>() : twice(row.id);
    rows.push_back(std::move(row));
    return {};
  });
  return end.map([&](LogEnd) { return std::move(rows); });
}

Result<std::unique_ptr<MatchMemory>> readMatchStore(const std::string& file, bool may_miss) {
  auto memory = std::make_unique<MatchMemory>();
  return readRows(file, may_miss, keepIn(*memory)).map([&](LogEnd) { return std::move(memory); });
}

}  // namespace fulbito
