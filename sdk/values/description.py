"""The description of team values (values.toml) as objects."""

import pathlib
import re
import tomllib
from typing import Any, Dict, Iterator, List, NamedTuple, Optional

PLACES = ("c", "cpp", "py", "json")
# Members of a point or of wheels.
PARTS = {"point": ("x", "y"), "wheels": ("left", "right")}
# Lists with one item per robot, which each place writes in its own way.
LISTS = ("robots", "opponents", "sent")


class CMember(NamedTuple):
    """A member of a structure of the C interface."""

    name: str
    type: str
    doc: str
    core: Optional[str]  # expression of the simulator's value; None: handwritten code fills it in
    repeat: int = 1  # number of bytes that the layout reserves


class Member:
    """One row of the description."""

    def __init__(self, row: List[Any]) -> None:
        self.name, kind, self.unit, self.doc = (str(cell) for cell in row[:4])
        self.more: Dict[str, Any] = row[4] if len(row) > 4 else {}
        self.optional = kind.endswith("?")
        self.type = kind.rstrip("?")

    def is_in(self, place: str) -> bool:
        return place in self.more.get("only", " ".join(PLACES)).split()

    def meaning(self, empty: str = "") -> str:
        """Its meaning with the unit before it; `empty` stands for an absent value."""
        text: str = ("[%s] " % self.unit if self.unit else "") + self.doc
        none = "; %s: %s" % (empty, self.more["none"]) if self.optional and empty else ""
        return text + none

    def json_names(self) -> List[str]:
        names = self.more.get("json", self.name)
        return names if isinstance(names, list) else [names]

    def is_split(self) -> bool:
        """Whether its parts are members of the object that it belongs to."""
        return len(self.json_names()) > 1

    def core(self) -> str:
        by_default = "v." + self.name if self.is_split() else "v." + self.json_names()[0]
        return str(self.more.get("core", by_default))


class Value:
    """A structure: its members, and its names in each place."""

    def __init__(self, name: str, table: Dict[str, Any]) -> None:
        self.name = name
        self.c = table.get("c", "")
        self.core = table["core"]
        self.py = table.get("py", name)
        self.doc = table["doc"]
        self.members = [Member(row) for row in table["members"]]
        self.layout: List[str] = table.get("layout", [])
        self.answer = table.get("answer", False)  # teams answer with it; the simulator presets its members in C
        self.code: Dict[str, str] = table.get("code", {})

    def of(self, place: str) -> Iterator[Member]:
        return (member for member in self.members if member.is_in(place))


class Enumeration:
    """A list of words that stand for the numbers from 0."""

    def __init__(self, table: Dict[str, Any]) -> None:
        self.c, self.cpp, self.doc = table["c"], table["cpp"], table["doc"]
        self.core = table["core"]
        self.words = [word for word, _ in table["words"]]
        self.docs = [doc for _, doc in table["words"]]

    def c_names(self) -> List[str]:
        return ["FULBITO_" + word.upper().replace("-", "_") for word in self.words]

    def cpp_names(self) -> List[str]:
        return ["k" + "".join(part.capitalize() for part in word.split("-")) for word in self.words]


class Description:
    def __init__(self, path: pathlib.Path) -> None:
        table = tomllib.loads(path.read_text())
        self.values = {name: Value(name, entry) for name, entry in table["values"].items()}
        self.enums = {name: Enumeration(entry) for name, entry in table["enums"].items()}

    def enums_of(self, owner: str) -> List[Enumeration]:
        """The enumerations within the structure `owner` of the SDK in C++."""
        return [entry for entry in self.enums.values() if entry.cpp.startswith(owner + "::")]


def wrapped(text: str, first: str, rest: str, width: int) -> List[str]:
    """`text` in lines of at most `width` characters, which begin with `first` and then `rest`."""
    lines, line = [], first
    for word in text.split():
        if len(line) + 1 + len(word) > width and line.strip() not in (first.strip(), rest.strip()):
            lines.append(line)
            line = rest
        line += ("" if line.endswith((" ", "(", "[")) or not line else " ") + word
    return lines + [line]


def aligned(rows: List[List[str]], mark: str, end: str, width: int) -> List[str]:
    """Declarations with their meanings behind them in a column, or above them where there is no room."""
    column = max(len(declaration) for declaration, doc in rows if len(declaration) + len(doc) + 12 <= width)
    lines = []
    for declaration, doc in rows:
        behind = "%-*s%s%s< %s%s" % (column, declaration, " " if end else "  ", mark, doc, end)
        if len(behind) <= width:
            lines.append(behind)
        else:
            indent = re.match(" *", declaration).group()  # type: ignore[union-attr]
            lines += wrapped(doc + end, indent + mark + " ", indent + (" * " if end else mark + " "), width) + [declaration]
    return lines
