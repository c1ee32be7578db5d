"""``python -m derive [NAME ...] [--check]``: derive kernels and write them, or compare them with what is committed.

``python -m derive review TASK`` answers for reviewers instead, see `derive.review.command`;
``python -m derive verdicts [--check]`` decides what the papers print, see `derive.papers.verdicts`.
"""

from __future__ import annotations

import argparse
import sys


def main() -> int:
    """Run the build step; return 0, or 1 when `--check` finds a difference, 2 where a name is unknown."""
    if sys.argv[1:2] == ["review"]:
        from derive.review import command  # needs what the runtime needs, and for claims no SymPy

        return command.main(sys.argv[2:])
    if sys.argv[1:2] == ["verdicts"]:
        from derive.papers import verdicts

        return verdicts.main(sys.argv[2:])
    return derive_kernels(sys.argv[1:])


def derive_kernels(given: list[str]) -> int:
    """Derive and write, or compare."""
    from derive.compiler import COMMAND, GENERATED, committed, differences, render, write

    parser = argparse.ArgumentParser(prog="python -m derive", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="of mechanisms, effects, measurements; default: all")
    parser.add_argument("--check", action="store_true", help="write nothing; fail if the committed kernels differ")
    arguments = parser.parse_args(given)
    try:
        fresh = render(arguments.names)
    except ValueError as error:
        print(error, file=sys.stderr)
        return 2
    old = committed(arguments.names)
    if not arguments.check:
        touched = write(fresh, old)
        print(f"{len(fresh)} files derived, {len(touched)} changed in {GENERATED.name}/")
        for path in touched:
            print(f"  {path}")
        return 0
    found = differences(fresh, old)
    for diff in found:
        print(diff)
    if found:
        print(f'{len(found)} generated files are not what derive/ yields. Run "{COMMAND}" and commit.')
        return 1
    print(f"{len(fresh)} generated files are what derive/ yields, byte for byte")
    return 0


if __name__ == "__main__":
    sys.exit(main())
