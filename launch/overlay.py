"""Lays a variant and --set values over a case."""

from __future__ import annotations

import tomllib

from launch import schema
from launch.errors import InputError, did_you_mean


def overlay(base: dict, top: dict) -> dict:
    """`top` laid over `base`: tables merge, lists of named tables merge by name, all else replaces."""
    result = dict(base)
    for key, value in top.items():
        old = result.get(key)
        if isinstance(value, dict) and isinstance(old, dict):
            result[key] = overlay(old, value)
        elif key == "target" and isinstance(value, list) and isinstance(old, list):
            named = {t.get("name"): t for t in old}
            for entry in value:
                name = entry.get("name") if isinstance(entry, dict) else None
                named[name] = overlay(named.get(name, {}), entry) if name else entry
            result[key] = list(named.values())
        else:
            result[key] = value
    return result


def parse_setting(text: str) -> tuple[str, object]:
    """key=value of --set; the value is TOML, or a plain word."""
    key, separator, value = text.partition("=")
    key, value = key.strip(), value.strip()
    if not separator or not key or not value:
        raise InputError("--set", text, None, "write key=value, e.g. --set coupling.window=0.01")
    try:
        return key, tomllib.loads(f"v = {value}")["v"]
    except tomllib.TOMLDecodeError:
        return key, value


def apply_setting(data: dict, text: str) -> None:
    """Sets one key, which must exist or be known, to a value of its type."""
    key, value = parse_setting(text)
    words = key.split(".")
    parameters = data.get("parameters", {})
    if len(words) == 1 and key in parameters:
        raise InputError("--set", key, value, f"write parameters.{key}")
    known = schema.find_key(key)
    optional = ("parameters.coarse_grain", "parameters.dem_dt")
    new_parameter = words[0] == "parameters" and words[-1] not in parameters and key not in optional
    if known is None or words[0] in ("target", "variant", "run") or new_parameter:
        guess = did_you_mean(words[-1], parameters) if new_parameter else schema.hint(key)
        raise InputError("--set", key, value, f"unknown key; {guess or 'the case has none such'}")
    table = data
    for word in words[:-1]:
        table = table.setdefault(word, {})
    old = table.get(words[-1])
    if isinstance(old, (int, float)) and not isinstance(old, bool) and isinstance(value, str):
        raise InputError("--set", key, value, f"give a number, as in the case ({old})")
    remedy = schema.fault(known, value)
    if remedy:
        raise InputError("--set", key, value, remedy)
    table[words[-1]] = value
