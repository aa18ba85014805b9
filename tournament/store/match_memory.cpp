#include <mutex>
#include <unordered_map>
#include <utility>

#include "tournament/store/match_line.hpp"
#include "tournament/store/match_store.hpp"

namespace fulbito {

struct MatchMemory::Impl {
  mutable std::mutex mutex;
  std::unordered_map<MatchId, MatchRow, WordOfId> rows;
};

MatchMemory::MatchMemory() : impl_(std::make_unique<Impl>()) {}
MatchMemory::~MatchMemory() = default;

std::optional<MatchRow> MatchMemory::find(const MatchId& id) const {
  const std::lock_guard lock(impl_->mutex);
  const auto found = impl_->rows.find(id);
  return found == impl_->rows.end() ? std::nullopt : std::optional(found->second);
}

Result<Added> MatchMemory::add(const MatchRow& row) { return take(storedForm(row)); }

Added MatchMemory::take(MatchRow&& row) {
  const std::lock_guard lock(impl_->mutex);
  const MatchId id = row.id;
  const auto [place, is_new] = impl_->rows.try_emplace(id, std::move(row));
  if (is_new) return Added::kNew;
  // `try_emplace` does not move from `row` if the key exists.
  return sameResult(place->second.result, row.result) ? Added::kSame : Added::kDifferent;
}

std::size_t MatchMemory::size() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->rows.size();
}

}  // namespace fulbito
