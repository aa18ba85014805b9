"""The JSON Schema of the line protocol against the sample session and the replies that the reader's test has."""

import json
import pathlib
import re
import unittest

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "docs/team-protocol.schema.json").read_text())


def validator(definition: str) -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator({**SCHEMA, "anyOf": [{"$ref": "#/$defs/" + definition}]})


def session(mark: str) -> list:
    lines = (ROOT / "docs/team-protocol-session.txt").read_text().splitlines()
    return [json.loads(line[2:]) for line in lines if line.startswith(mark)]


def replies() -> list:
    """Pairs of the reader's outcome and the reply's text."""
    lines = (ROOT / "tests/unit/bridge/lines/replies.txt").read_text().split("\n")
    return [tuple(line.split("\t", 1)) for line in lines if "\t" in line and not line.startswith("#")]


class SchemaTest(unittest.TestCase):
    def test_is_a_schema(self) -> None:
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_takes_the_sample_session(self) -> None:
        for mark, definition in (("> ", "simulator"), ("< ", "reply")):
            messages = session(mark)
            self.assertGreater(len(messages), 10)
            for message in messages:
                validator(definition).validate(message)
                jsonschema.Draft202012Validator(SCHEMA).validate(message)

    def test_needs_each_member_that_the_simulator_sends(self) -> None:
        check = validator("simulator")
        for message in session("> "):
            for name in message:
                lacking = {key: value for key, value in message.items() if key != name}
                self.assertFalse(check.is_valid(lacking), "%s without %s" % (message["type"], name))

    def test_needs_each_member_of_an_observation(self) -> None:
        check = validator("observation")
        now = next(message["now"] for message in session("> ") if message["type"] == "decide")
        for name in now:
            self.assertFalse(check.is_valid({key: value for key, value in now.items() if key != name}), name)
        for name in now["own"][0]:
            robot = {key: value for key, value in now["own"][0].items() if key != name}
            self.assertFalse(check.is_valid({**now, "own": [robot]}), name)

    def test_agrees_with_the_reader(self) -> None:
        check = validator("reply")
        counts = {True: 0, False: 0}
        for outcome, text in replies():
            if outcome.startswith("["):
                continue
            good = outcome == "ok"
            counts[good] += 1
            self.assertEqual(check.is_valid(json.loads(text)), good, "%s: %s" % (outcome, text))
        self.assertGreater(counts[True], 15)
        self.assertGreater(counts[False], 35)

    def test_takes_the_examples_of_the_page(self) -> None:
        page = (ROOT / "docs/team-protocol.md").read_text()
        examples = [json.loads(text) for text in re.findall("```json\n(.*?)\n```", page, re.DOTALL)]
        # One shortens its observation.
        whole = [example for example in examples if "..." not in example.get("now", {})]
        self.assertEqual((len(examples), len(whole)), (7, 6))
        for example in whole:
            jsonschema.Draft202012Validator(SCHEMA).validate(example)


if __name__ == "__main__":
    unittest.main()
