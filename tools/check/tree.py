"""What the checks share: the files of the tree, C++ without its comments, and one way to report faults.

A check is a program that prints each fault as `path:line: what is wrong; what would be right`, ends with status 1 if
there is one, and takes the folder to look at as an optional argument (so that self-test can plant faults elsewhere).
"""
import pathlib
import re
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def root_argument():
    return pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else REPOSITORY


def files(root, *patterns):
    """Paths relative to `root` of the files that git tracks or would track, in order; patterns as git knows them."""
    listing = subprocess.run(
        ["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *patterns],
        check=True, capture_output=True, text=True).stdout
    names = sorted({name for name in listing.split("\0") if name})
    return [pathlib.PurePosixPath(name) for name in names if (root / name).is_file()]


# Comments, string literals and character literals of C++, as far as a search needs them.
_NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
_INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)


def code_lines(text):
    """(line number, line) of C++ with comments and literals blanked out; the lines keep their numbers."""
    blank = _NOT_CODE.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    return enumerate(blank.split("\n"), start=1)


def includes(text):
    """(line number, '<' or '"', header) of each #include."""
    return [(text.count("\n", 0, match.start(1)) + 1, match.group(1), match.group(2))
            for match in _INCLUDE.finditer(text)]


def finish(faults, passed):
    """Prints the faults, or the sentence `passed`, and ends the program."""
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {len(faults)} fault{'s' if len(faults) > 1 else ''}")
    print(passed)
