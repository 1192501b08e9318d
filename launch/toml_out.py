"""Writes TOML: what tomllib reads, the other way round, for the resolved case of a run."""

from __future__ import annotations

import json


def value_text(value: object) -> str:
    """One value in TOML. Numbers keep every digit."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return "[" + ", ".join(value_text(v) for v in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key_text(k)} = {value_text(v)}" for k, v in value.items()) + "}"
    raise TypeError(f"no TOML for {type(value).__name__}")


def key_text(key: str) -> str:
    """A bare key where TOML allows it, else a quoted one."""
    bare = key.isascii() and key.replace("_", "").replace("-", "").isalnum()
    return key if bare else json.dumps(key)


def dumps(data: dict, prefix: str = "") -> str:
    """A whole document: plain values first, then tables, then arrays of tables."""
    plain, tables, arrays = [], [], []
    for key, value in data.items():
        if isinstance(value, dict):
            tables.append((key, value))
        elif isinstance(value, list) and value and all(isinstance(v, dict) for v in value):
            arrays.append((key, value))
        else:
            plain.append(f"{key_text(key)} = {value_text(value)}\n")
    text = "".join(plain)
    for key, value in tables:
        name = prefix + key_text(key)
        text += f"\n[{name}]\n" + dumps(value, name + ".")
    for key, values in arrays:
        name = prefix + key_text(key)
        text += "".join(f"\n[[{name}]]\n" + dumps(value, name + ".") for value in values)
    return text
