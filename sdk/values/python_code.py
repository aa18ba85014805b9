"""The SDK in Python: classes of sdk/python/fulbito_team.py."""

from typing import List

from description import PARTS, Description, Member, Value, wrapped

WIDTH = 120
TYPES = {"number": ("float", "0.0"), "integer": ("int", "0"), "tick": ("int", "0"), "flag": ("bool", "False"), "text": ("str", '""'),
         "seed": ("int", "0"), "colour": ("str", '"blue"'), "side": ("str", '"left"'), "point": ("Point", ""), "poses": ("List[Optional[Pose]]", "")}
# Classes of plain attributes, made once per tick; the others are dataclasses.
PLAIN = {"Ball": "", "Opponent": "", "Robot": "Opponent", "Observation": ""}
# Dataclasses that programs make without arguments, for tests and before the match.
WITH_DEFAULTS = ("Field", "RobotModel", "BallModel", "Vision", "DecisionTime", "Info", "GoTo")


def type_of(description: Description, member: Member) -> str:
    by_name = "str" if member.type in description.enums else member.type
    kind = TYPES[member.type][0] if member.type in TYPES else by_name
    absent = member.optional or member.more.get("nullable") or member.more.get("default") == "infinity"
    return "Optional[%s]" % kind if absent else kind


def default_of(description: Description, member: Member) -> str:
    given = member.more.get("default")
    if member.optional or given == "infinity":
        return "None"
    if given is not None:
        return {"true": "True", "false": "False"}.get(given, str(given))
    if member.type in description.values:
        return "dataclasses.field(default_factory=%s)" % member.type
    return "(0.0, 0.0)" if member.type == "point" else TYPES[member.type][1]


def attributes(member: Member) -> List[str]:
    """Names in Python; a point's parts are attributes of their own where they are in the protocol."""
    if member.is_split():
        return member.json_names()
    return [member.more["json"] if member.more.get("json") in ("team", "omega") else member.name]


def meaning(description: Description, member: Member) -> str:
    if member.type in description.enums:
        return member.meaning() + ": " + ", ".join(description.enums[member.type].words)
    return member.meaning("None").replace("infinity: no", "None: no").replace("no clause", "None")


def row(declaration: str, doc: str) -> List[str]:
    behind = "%s  #: %s" % (declaration, doc) if doc else declaration
    if len(behind) <= WIDTH:
        return [behind]
    return wrapped(doc, "    #: ", "    #: ", WIDTH) + [declaration]


def dataclass(description: Description, name: str, value: Value) -> List[str]:
    lines = ["@dataclass", "class %s:" % value.py, '    """%s"""' % value.doc, ""]
    for member in value.of("py"):
        kind, doc = type_of(description, member), meaning(description, member)
        if name in ("Info", "PlacementRequest") and member.type in ("Physics", "Rules"):
            kind, default = "_Object", "dataclasses.field(default_factory=dict)"
            doc = "by the keys of %s files" % member.name
        elif member.type == "point" and name == "Field":
            kind, default = "Sequence[float]", "(0.0, 0.0)"
        elif member.type == "point" and member.is_split():
            for part in attributes(member):
                lines += row("    %s: float" % part, doc if part == attributes(member)[0] else "")
            continue
        else:
            default = default_of(description, member) if name in WITH_DEFAULTS else ""
        if name not in WITH_DEFAULTS:
            default = ""
        for attribute in attributes(member):
            lines += row("    %s: %s%s" % (attribute, kind, " = " + default if default else ""), doc)
    if "py" in value.code:
        lines += value.code["py"].rstrip().split("\n")
    return lines


def reading(description: Description, member: Member, name: str) -> str:
    """The expression of an attribute in the constructor of a plain class."""
    if member.type == "robots":
        return "List[Optional[Robot]] = [Robot(v) if v is not None else None for v in values[\"own\"]]"
    if member.type == "opponents":
        return "List[Optional[Opponent]] = [\n            Opponent(v) if v is not None else None for v in values[\"opponents\"]]"
    if member.type in description.values:
        return "%s = %s(values[\"%s\"])" % (member.type, member.type, name)
    kind = "float" if member.is_split() else type_of(description, member)
    return "%s = values[\"%s\"]" % (kind, name)


def plain(description: Description, name: str) -> List[str]:
    value = description.values["Robot" if name == "Opponent" else name]
    base = PLAIN[name]
    members = [m for m in value.of("py") if not (name == "Opponent" and m.more.get("own"))]
    own = [a for m in members for a in attributes(m) if not base or m.more.get("own")]
    doc = {"Opponent": "A robot of the other team as the team sees it.",
           "Robot": "A robot of the team: an opponent's members, and its wheels."}.get(name, value.doc)
    extra = ["dt"] if name == "Observation" else []
    slots = wrapped(", ".join('"%s"' % a for a in own[:1] + extra + own[1:]) + ")", "    __slots__ = (", " " * 17, WIDTH)
    lines = ["class %s%s:" % (name, "(%s)" % base if base else ""), '    """%s"""' % doc, ""]
    lines += slots + ["", "    def __init__(self, values: _Object%s) -> None:" % (", dt: float" if extra else "")]
    for member in members:
        for i, attribute in enumerate(attributes(member)):
            known = base and not member.more.get("own")
            text = reading(description, member, attribute)
            declaration = "        self.%s%s%s" % (attribute, " = " if known else ": ", text.split(" = ", 1)[1] if known else text)
            doc_text = "" if known or i > 0 else meaning(description, member)
            if "\n" in declaration or len(declaration) + len(doc_text) + 5 > WIDTH:
                lines += wrapped(doc_text, "        #: ", "        #: ", WIDTH) + declaration.split("\n")
            else:
                lines += row(declaration, doc_text)
        if extra and member.name == "tick":
            lines += row("        self.dt = dt", "[s] control period: time between two decisions")
    return lines


def classes(description: Description, names: List[str]) -> List[str]:
    lines: List[str] = []
    for name in names:
        lines += plain(description, name) if name in PLAIN else dataclass(description, name, description.values[name])
        lines += ["", ""]
    return lines[:-2]
