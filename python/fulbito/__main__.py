"""`python -m fulbito match libero classic` runs the program `fulbito` with these arguments."""

import os
import sys

from fulbito.program import program_path


def main() -> None:
    """Becomes the program; its exit code is the command's. Does not return."""
    program = os.fspath(program_path())
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    main()
