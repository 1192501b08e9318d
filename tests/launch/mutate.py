"""Small wrongs done to a case's files, as tired users and broken disks do them: seeded, so that a number names one.

mutate(case, seed) changes one file of a case's directory and tells which, and how."""

from __future__ import annotations

import random
import re
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.$\"/])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
STRANGE = ("-1", "0", "1e300", "-1e-300", "nan", "inf", "1e", "12,5", "seven", '"5"', "[1, 2]", "{}", "true", "1e-12",
           "99999999999999999999", "0x10", "''", "\u00b5", "$nothing", "${nothing}")


def mutate(case: Path, files: list[str], seed: int) -> str:
    """Changes one of `files` (below `case`); gives "file: what was done"."""
    dice = random.Random(seed)
    name = dice.choice(files)
    path = case / name
    text = path.read_text()
    done, changed = "nothing", text
    while changed == text:
        how = dice.choice(WAYS)
        done, changed = how(text, dice)
    path.write_bytes(changed if isinstance(changed, bytes) else changed.encode())
    return f"{name}: {done}"


def _lines(text: str) -> list[int]:
    """Numbers of the lines that say something."""
    return [i for i, line in enumerate(text.splitlines()) if line.strip() and not line.lstrip().startswith(("#", "//"))]


def _with_line(text: str, number: int, *new: str) -> str:
    lines = text.splitlines()
    return "\n".join(lines[:number] + list(new) + lines[number + 1:]) + "\n"


def drop_line(text: str, dice: random.Random) -> tuple[str, str]:
    number = dice.choice(_lines(text))
    return f"without line {number + 1}", _with_line(text, number)


def double_line(text: str, dice: random.Random) -> tuple[str, str]:
    number = dice.choice(_lines(text))
    line = text.splitlines()[number]
    return f"line {number + 1} twice", _with_line(text, number, line, line)


def swap_lines(text: str, dice: random.Random) -> tuple[str, str]:
    one, other = dice.choice(_lines(text)), dice.choice(_lines(text))
    lines = text.splitlines()
    lines[one], lines[other] = lines[other], lines[one]
    return f"lines {one + 1} and {other + 1} swapped", "\n".join(lines) + "\n"


def strange_number(text: str, dice: random.Random) -> tuple[str, str]:
    found = list(NUMBER.finditer(text))
    if not found:
        return "nothing", text
    spot, new = dice.choice(found), dice.choice(STRANGE)
    return f"{new} for {spot.group()} at {spot.start()}", text[: spot.start()] + new + text[spot.end():]


def typing_error(text: str, dice: random.Random) -> tuple[str, str]:
    words = [w for w in re.finditer(r"[A-Za-z_]{3,}", text)]
    spot = dice.choice(words)
    k = dice.randrange(spot.start(), spot.end() - 1)
    return f"letters turned in {spot.group()}", text[:k] + text[k + 1] + text[k] + text[k + 2:]


def drop_sign(text: str, dice: random.Random) -> tuple[str, str]:
    signs = [i for i, c in enumerate(text) if c in "\"'=[](){};,.$"]
    spot = dice.choice(signs)
    return f"without {text[spot]!r} at {spot}", text[:spot] + text[spot + 1:]


def cut_off(text: str, dice: random.Random) -> tuple[str, str]:
    end = dice.randrange(len(text))
    return f"cut off at {end}", text[:end]


def noise(text: str, dice: random.Random) -> tuple[str, bytes]:
    spot = dice.randrange(len(text))
    raw = text.encode()
    return f"bytes of another file at {spot}", raw[:spot] + bytes(dice.randrange(256) for _ in range(8)) + raw[spot:]


def empty(text: str, dice: random.Random) -> tuple[str, str]:
    return "empty", "" if dice.random() < 0.2 else text


WAYS = (drop_line, double_line, swap_lines, strange_number, strange_number, strange_number, typing_error, typing_error,
        drop_sign, cut_off, noise, empty)
