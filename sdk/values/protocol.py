"""The line protocol in words: tables of docs/team-protocol.md, and the JSON schema."""

import json
from typing import Any, Dict, List

from description import Description, Member, Value, wrapped

WIDTH = 135
WORDS = {"number": "number", "integer": "integer", "tick": "integer", "flag": "boolean", "text": "string", "seed": "string",
         "colour": "string", "side": "string", "robots": "list", "opponents": "list", "poses": "list", "wheels": "number"}
# Types that have a definition of their own in the schema.
REFERENCES = {"colour": "colour", "restart": "restart", "point": "point", "poses": "poses", "Ball": "ball", "Call": "call",
              "Observation": "observation", "Field": "table", "RobotModel": "table", "BallModel": "table", "Physics": "table",
              "Rules": "table"}
# Definitions whose members the description gives, and which of them. The rest of the schema is written by hand.
DEFINITIONS = {"ball": "Ball", "opponent": "Robot", "robot": "Robot", "observation": "Observation", "call": "Call", "begin": "Info",
               "place": "PlacementRequest", "ended": "End"}


def word_of(description: Description, member: Member) -> str:
    kind = WORDS.get(member.type, "string" if member.type in description.enums else "object")
    if member.is_split():
        kind = "number"
    absent = member.optional or member.more.get("nullable") or member.more.get("default") == "infinity"
    return kind + (" or null" if absent else "")


def meaning(description: Description, member: Member) -> str:
    text = str(member.more.get("docs", member.doc))
    unit = member.unit if member.type in ("number", "wheels") or member.is_split() else ""
    text = ("[%s] " % unit.replace("^2", "²") if unit else "") + text
    if member.type in description.enums:
        text += ": " + ", ".join("`%s`" % word for word in description.enums[member.type].words)
    return text + ("; null: %s" % member.more["none"] if member.optional else "")


def table(description: Description, names: List[str]) -> List[str]:
    value = description.values[names[0]]
    defaults = value.answer
    lines = ["| member | type |%s meaning |" % (" default |" if defaults else ""), "|---|---|%s---|" % ("---|" if defaults else "")]
    for member in value.of("json"):
        cells = [", ".join("`%s`" % name for name in member.json_names()), word_of(description, member)]
        if defaults:
            usual = member.more.get("default", {"flag": "false", "integer": "0"}.get(member.type, "null"))
            cells.append("required" if member.is_split() else usual.replace("infinity", "null"))
        lines.append("| %s |" % " | ".join(cells + [meaning(description, member)]))
    return lines


def schema_of(description: Description, member: Member) -> Dict[str, Any]:
    """The schema of one member."""
    given: Dict[str, Any] = dict(member.more.get("schema", {}))
    if member.type in REFERENCES and not member.is_split():
        reference = {"$ref": "#/$defs/" + REFERENCES[member.type]}
        return {"oneOf": [reference, {"type": "null"}]} if member.optional else reference
    if member.type in description.enums:
        return {"enum": description.enums[member.type].words}
    if member.type == "side":
        return {"enum": ["left", "right"]}
    if member.type == "seed":
        return {"type": "string", "pattern": "^[0-9]+$"}
    if member.type in ("robots", "opponents"):
        item = "robot" if member.type == "robots" else "opponent"
        return {"type": "array", "maxItems": 11, "items": {"$ref": "#/$defs/" + item}}
    if member.type in description.values:
        inner = object_of(description, description.values[member.type])
        return {"type": ["object", "null"] if member.optional else "object", **inner}
    kind = "number" if member.is_split() else WORDS[member.type]
    return {"type": [kind, "null"] if member.optional else kind, **given}


def object_of(description: Description, value: Value, own: Any = None) -> Dict[str, Any]:
    members = [m for m in value.of("json") if own is None or bool(m.more.get("own")) == own]
    properties = {name: schema_of(description, m) for m in members for name in m.json_names()}
    return {"required": list(properties), "properties": properties}


def written(value: Any, indent: str, before: int) -> str:
    """JSON on one line where there is room, else one member or item per line."""
    line = json.dumps(value)
    if len(indent) + before + len(line) <= WIDTH or not value or not isinstance(value, (dict, list)):
        return line
    deeper = indent + "  "
    if isinstance(value, dict):
        parts = ["%s: %s" % (json.dumps(k), written(v, deeper, len(k) + 4)) for k, v in value.items()]
        return "{\n%s%s\n%s}" % (deeper, (",\n" + deeper).join(parts), indent)
    if all(isinstance(item, str) for item in value):
        return "\n".join(wrapped(line[1:], "[", indent + " ", WIDTH))
    return "[\n%s%s\n%s]" % (deeper, (",\n" + deeper).join(written(v, deeper, 0) for v in value), indent)


def schema(description: Description, text: str) -> str:
    """The schema with the definitions that the description gives."""
    whole = json.loads(text)
    definitions = whole["$defs"]
    for name, value in DEFINITIONS.items():
        made = object_of(description, description.values[value], {"robot": True, "opponent": False}.get(name))
        entry = definitions[name]
        kept = {key: schema for key, schema in entry["properties"].items() if key in ("type", "id")}
        made["properties"] = {**kept, **made["properties"]}
        made["required"] = list(made["properties"])
        if name == "begin":
            made["properties"]["rules"] = entry["properties"]["rules"]  # any keys, as in files of rules
            made["properties"]["vision"]["additionalProperties"] = {"type": "number"}
        definitions[name] = {**{key: value for key, value in entry.items() if key not in made}, **made}
    definitions["restart"] = {"enum": description.enums["restart"].words}
    task = definitions["exercise"]["properties"]["exercise"]
    definitions["exercise"]["properties"]["exercise"] = {**task, **object_of(description, description.values["Exercise"])}
    place = definitions["goTo"]["properties"]["go_to"]
    for member in description.values["GoTo"].of("json"):
        if not member.is_split() and member.name not in place["properties"]:
            place["properties"][member.name] = schema_of(description, member)
    return written(whole, "", 0) + "\n"
