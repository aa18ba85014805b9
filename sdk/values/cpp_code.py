"""C++: structures of the SDK (fulbito/team.hpp) and of the simulator, and the SDK's members beside those of the C interface."""

from typing import List

from description import LISTS, PARTS, Description, Enumeration, Member, aligned, wrapped

WIDTH = 110
TYPES = {"number": ("double", "0.0"), "integer": ("int", "0"), "tick": ("std::int64_t", "0"), "flag": ("bool", "false"),
         "text": ("std::string", ""), "seed": ("std::uint64_t", "0"), "point": ("Vec2", ""), "wheels": ("Wheels", ""),
         "colour": ("Colour", "Colour::kBlue"), "tie_break": ("TieBreak", "TieBreak::kNone"), "poses": ("Poses", ""),
         "robots": ("std::array<Robot, kMaxTeamSize>", ""), "opponents": ("std::array<Robot, kMaxTeamSize>", ""),
         "sent": ("std::array<Wheels, kMaxTeamSize>", "")}
INFINITY = "std::numeric_limits<double>::infinity()"
# Types of the simulator, where they have other names than those of the SDK.
OF_SIMULATOR = {"tick": ("Tick", "0"), "wheels": ("WheelSpeeds", ""), "robots": ("std::array<ObservedRobot, kMaxTeamSize>", ""),
                "opponents": ("std::array<ObservedRobot, kMaxTeamSize>", ""), "sent": ("std::array<WheelSpeeds, kMaxTeamSize>", "")}


def declaration(description: Description, owner: str, member: Member) -> str:
    if member.type in description.enums:
        entry = description.enums[member.type]
        kind = entry.cpp.removeprefix(owner + "::")
        default = "%s::%s" % (kind, entry.cpp_names()[0])
    else:
        kind, default = TYPES.get(member.type, (member.type, ""))
    if member.optional:
        return "  std::optional<%s> %s;" % (kind, member.name)
    default = member.more.get("default", default).replace("infinity", INFINITY)
    return "  %s %s%s;" % (kind, member.name, " = " + default if default else "")


def enumeration(entry: Enumeration, indent: str) -> List[str]:
    names = entry.cpp_names()
    rows = [["%s  %s%s" % (indent, name, "," if i + 1 < len(names) else ""), entry.docs[i]] for i, name in enumerate(names)]
    head = [indent + "/// " + entry.doc, "%senum class %s : std::uint8_t {" % (indent, entry.cpp.split("::")[-1])]
    return head + aligned(rows, "///", "", WIDTH) + [indent + "};"]


def structs(description: Description, names: List[str]) -> List[str]:
    lines: List[str] = []
    for name in names:
        if name in description.enums:
            lines += enumeration(description.enums[name], "") + [""]
            continue
        value = description.values[name]
        lines += wrapped(value.doc, "/// ", "/// ", WIDTH) + ["struct %s {" % name]
        for entry in description.enums_of(name):
            lines += enumeration(entry, "  ")
        rows = [[declaration(description, name, member), member.meaning("empty")] for member in value.of("cpp")]
        lines += aligned(rows, "///", "", WIDTH)
        if "cpp" in value.code:
            lines += [""] + value.code["cpp"].rstrip().split("\n")
        lines += ["};", ""]
    return lines[:-1]


def of_simulator(description: Description, names: List[str]) -> List[str]:
    """The structures of `names` with the names and types of the simulator."""

    def row(member: Member) -> List[str]:
        if member.type in description.enums:
            entry = description.enums[member.type]
            kind, default = entry.core, "%s::%s" % (entry.core, entry.cpp_names()[0])
        elif member.type in description.values:
            kind, default = description.values[member.type].core, ""
        else:
            kind, default = OF_SIMULATOR.get(member.type) or TYPES[member.type]
        default = member.more.get("default", default)
        return ["  %s %s%s;" % (kind, member.name, " = " + default if default else ""), member.meaning("empty")]

    lines: List[str] = []
    for value in (description.values[name] for name in names):
        lines += wrapped(value.doc, "/// ", "/// ", WIDTH) + ["struct %s {" % value.core]
        lines += aligned([row(member) for member in value.of("cpp")], "///", "", WIDTH) + ["};", ""]
    return lines[:-1]


def rows_of(member: Member, in_c: bool) -> List[str]:
    """Calls of the visitor: name in the protocol, member of the class, member of the C structure."""
    in_c = in_c and member.is_in("c") and not isinstance(member.more.get("c"), list)
    names = member.json_names() if member.is_in("json") or "json" in member.more else [""]
    parts = ["." + part for part in PARTS[member.type]] if len(names) > 1 else [""]
    return ['  visit("%s", v.%s%s, %s);' % (name, member.name, part, "c.%s%s" % (member.name, part) if in_c else "nullptr")
            for name, part in zip(names, parts)]


def members(description: Description, names: List[str]) -> List[str]:
    lines: List[str] = []
    for name in names:
        value = description.values[name]
        const = "" if name == "GoTo" else "const "
        c_name = value.c or "std::nullptr_t"
        unused = not value.c
        lines += ["/// %s beside %s." % (name, "its C structure" if value.c else "none: the C interface has it in another form"),
                  "%s abiOf(const %s&);" % (c_name, name),
                  "void members(%s& v, %s%s&%s, auto visit) {" % (name, const, c_name, "" if unused else " c")]
        for member in value.of("cpp"):
            if member.type not in LISTS:
                lines += rows_of(member, bool(value.c))
        lines += ["}", ""]
    return lines[:-1]


def words(description: Description, names: List[str]) -> List[str]:
    """The words of enumerations, for readers of the protocol."""
    lines = []
    for name in names:
        entry = description.enums[name]
        text = ", ".join('"%s"' % word for word in entry.words)
        lines += ["constexpr auto wordsOf(%s) {" % entry.cpp, "  return std::to_array<std::string_view>({%s});" % text, "}"]
    return lines
