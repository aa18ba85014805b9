#include "strategies/teams/libero/playbook/playbook.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"

namespace fulbito::libero {
namespace {

struct Row {
  std::string_view role;
  const char* name;
  const char* summary;
  SkillFunction* decide;
};

constexpr Row kRows[] = {
#define SKILL(role, name, function, summary) {#role, name, summary, role::function},
#include "strategies/teams/libero/playbook/playbook.def"
};

/// Whether another row stands in when this one is left out: any but the last of keeper, striker and support.
bool mayBeLeftOut(const Row& row) {
  if (row.role == "field") return true;
  return std::any_of(&row + 1, std::end(kRows), [&](const Row& next) { return next.role == row.role; });
}

Result<void> checkLeftOut(const std::string& name) {
  std::vector<std::string> names;
  for (const Row& row : kRows) {
    if (name == row.name && !mayBeLeftOut(row)) {
      return fail(
          ErrorCode::kUsage,
          fmt::format("libero: without={}: the {} needs this skill when no other answers", name, row.role));
    }
    if (mayBeLeftOut(row) && std::find(names.begin(), names.end(), row.name) == names.end())
      names.emplace_back(row.name);
  }
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  return fail(ErrorCode::kUsage, fmt::format("libero: there is no skill '{}'.{} It must be one of {}", name,
                                             suggestion(name, names), fmt::join(names, ", ")));
}

std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('+', at), text.size());
    found.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return found;
}

}  // namespace

PlayBook::PlayBook() : PlayBook(std::vector<std::string>{}) {}

PlayBook::PlayBook(const std::vector<std::string>& left_out) {
  for (const Row& row : kRows) {
    if (std::find(left_out.begin(), left_out.end(), row.name) != left_out.end()) continue;
    Table& table = row.role == "field"     ? field_
                   : row.role == "keeper"  ? keeper_
                   : row.role == "striker" ? striker_
                                           : support_;
    table.push_back({row.name, row.decide});
  }
}

Result<PlayBook> PlayBook::without(const std::string& names) {
  const std::vector<std::string> left_out = parts(names);
  for (const std::string& name : left_out) {
    if (auto checked = checkLeftOut(name); !checked) return tl::unexpected<Error>(checked.error());
  }
  return PlayBook(left_out);
}

std::vector<SkillInfo> PlayBook::skills() {
  std::vector<SkillInfo> list;
  for (const Row& row : kRows) list.push_back({std::string(row.role), row.name, row.summary});
  return list;
}

Move PlayBook::decide(Role role, const Picture& picture, int robot, Memory& memory) const {
  memory.shot.now.reset();
  memory.spin.locked = std::max(0.0, memory.spin.locked - picture.seen.dt);
  memory.ram.left = std::max(0.0, memory.ram.left - picture.seen.dt);
  watchJam(picture, robot, memory.press);
  Move move;
  if (role == Role::kKeeper || !takeFirst(field_, picture, robot, memory, move))
    takeFirst(tableOf(role), picture, robot, memory, move);
  return move;
}

const PlayBook::Table& PlayBook::tableOf(Role role) const {
  if (role == Role::kKeeper) return keeper_;
  return role == Role::kSupport ? support_ : striker_;
}

bool PlayBook::takeFirst(const Table& table, const Picture& picture, int robot, Memory& memory, Move& move) {
  for (const Skill& skill : table) {
    if (const auto answer = skill.decide(picture, robot, memory)) {
      move = *answer;
      move.skill = skill.name;
      return true;
    }
  }
  return false;
}

}  // namespace fulbito::libero
