"""Golden files, tests/golden/NAME.txt: the approved hash, and below it who approved which value when, and why.

    hash: 0123456789abcdef
    approved: 2026-01-31 0123456789abcdef The first stack that stands.

Invariant: the last log line holds the hash of the first line; an edit by hand that leaves no reason is seen.
"""
import re

FOLDER = "tests/golden"
NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*$")
HASH = re.compile(r"[0-9a-f]{16}$")
_HEAD = re.compile(r"hash: ([0-9a-f]{16})$")
_APPROVAL = re.compile(r"approved: \d{4}-\d{2}-\d{2} ([0-9a-f]{16}) \S.*$")


def path_of(root, name):
    return root / FOLDER / f"{name}.txt"


def faults(name, text):
    """(line number, what is wrong) for each fault of a golden file."""
    if not NAME.match(name):
        return [(1, "a golden's name has lower-case letters, digits and single dashes")]
    lines = text.split("\n")
    if lines.pop() != "" or not lines:
        return [(1, "a golden file ends with a line end")]
    head = _HEAD.match(lines[0])
    if not head:
        return [(1, "the first line is not `hash: ` and 16 hexadecimal digits")]
    found = [(number, "not `approved: YYYY-MM-DD HASH reason`")
             for number, line in enumerate(lines[1:], start=2) if not _APPROVAL.match(line)]
    if found:
        return found
    if len(lines) == 1:
        return [(1, "the hash was never approved")]
    last = _APPROVAL.match(lines[-1]).group(1)
    if last != head.group(1):
        return [(1, f"the hash is {head.group(1)}, but the last approval is of {last}: use tools/check/approve")]
    return []


def approved(text, new_hash, date, reason):
    """The text of a golden file (empty for a new one) after one more approval."""
    log = text.split("\n", 1)[1] if text else ""
    return f"hash: {new_hash}\n{log}approved: {date} {new_hash} {reason}\n"
