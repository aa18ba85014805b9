#include "tournament/store/match_log.hpp"

#include <mutex>
#include <utility>

#include "tournament/store/appended_file.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito {

struct MatchLog::Impl {
  explicit Impl(AppendedFile opened) : file(std::move(opened)) {}

  Result<void> begin(const std::string& name);

  AppendedFile file;
  std::mutex appending;
  MatchMemory rows;
  bool torn = false;
};

Result<void> MatchLog::Impl::begin(const std::string& name) {
  const auto end = readRows(file.descriptor(), name, keepIn(rows));
  if (!end) return tl::unexpected<Error>(end.error());
  torn = end->torn;
  auto begun = file.begin(end->size);
  return begun && end->size == 0 ? file.append(logHeader()) : begun;
}

MatchLog::MatchLog(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MatchLog::~MatchLog() = default;

Result<std::unique_ptr<MatchLog>> MatchLog::open(const std::string& file) {
  auto opened = AppendedFile::open(file);
  if (!opened) return tl::unexpected<Error>(opened.error());
  auto impl = std::make_unique<Impl>(std::move(*opened));
  if (auto begun = impl->begin(file); !begun) return tl::unexpected<Error>(begun.error());
  return std::unique_ptr<MatchLog>(new MatchLog(std::move(impl)));
}

std::optional<MatchRow> MatchLog::find(const MatchId& id) const { return impl_->rows.find(id); }

Result<Added> MatchLog::add(const MatchRow& row) {
  const std::lock_guard lock(impl_->appending);
  if (const auto there = find(row.id)) {
    return sameResult(there->result, row.result) ? Added::kSame : Added::kDifferent;
  }
  auto written = impl_->file.append(toLine(row));
  if (!written) return tl::unexpected<Error>(written.error());
  return impl_->rows.add(row);
}

std::size_t MatchLog::size() const { return impl_->rows.size(); }
bool MatchLog::wasTorn() const { return impl_->torn; }

}  // namespace fulbito
