#pragma once

#include <string>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero {

/// The tables of skills by role (playbook.def), as a match uses them.
class PlayBook {
 public:
  /// The whole play book.
  PlayBook();
  /// The play book without skills, such as `race+squeeze`. A name that several roles have leaves all of them
  /// out. Errors: kUsage for an unknown name, and for the last skill of a role.
  static Result<PlayBook> without(const std::string& names);
  /// Every skill, role by role, in the order of priority.
  static std::vector<SkillInfo> skills();

  /// The move of the first skill that answers. What a robot remembers is in `memory`.
  Move decide(Role role, const Picture& picture, int robot, Memory& memory) const;

 private:
  struct Skill {
    const char* name;
    SkillFunction* decide;
  };
  using Table = std::vector<Skill>;

  explicit PlayBook(const std::vector<std::string>& left_out);
  const Table& tableOf(Role role) const;
  /// Sets `move` to that of the table's first skill that answers, and returns whether one does. A move is
  /// large, so it is copied only once.
  static bool takeFirst(const Table& table, const Picture& picture, int robot, Memory& memory, Move& move);

  Table field_, keeper_, striker_, support_;
};

}  // namespace fulbito::libero
