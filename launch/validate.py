"""Checks the keys of a case against the schema: unknown, wrong type or range, missing."""

from __future__ import annotations

from pathlib import Path

from launch import schema
from launch.errors import InputError, did_you_mean

TABLES = sorted({key.partition(".")[0] for key in schema.KEYS} - {"target"})


def check_tables(file: Path, data: dict) -> None:
    """Refuses a table written as a plain value, before anything looks into it."""
    for name in TABLES + ["variant", "run"]:
        if name in data and not isinstance(data[name], dict):
            raise InputError(file, name, data[name], f"write a table: [{name}]")


def check_keys(file: Path, data: dict) -> None:
    """Refuses unknown keys, wrong types and values out of range, and missing required keys."""
    for key, value in schema.leaves({k: v for k, v in data.items() if k != "target"}):
        known = schema.find_key(key)
        if known is None:
            raise InputError(file, key, value, f"unknown key; {schema.hint(key)}")
        _check_value(file, key, known, value)
    targets = data.get("target", [])
    if not isinstance(targets, list) or not all(isinstance(t, dict) for t in targets):
        raise InputError(file, "target", None, "write [[target]], with double brackets")
    for number, target in enumerate(targets, start=1):
        _check_target(file, f"target {target.get('name', number)!r}: ", target)
    for key, known in schema.KEYS.items():
        table, _, name = key.partition(".")
        if known.required and "*" not in key and table != "target" and name not in data.get(table, {}):
            unit = f" [{known.unit}]" if known.unit else ""
            raise InputError(file, key, None, f"missing: {known.meaning}{unit}")
    for name, observer in data.get("observe", {}).items():
        _check_observer(file, f"observe.{name}", observer)


def _check_observer(file: Path, where: str, observer: object) -> None:
    if not isinstance(observer, dict) or "type" not in observer:
        raise InputError(file, f"{where}.type", None, f"missing: one of {', '.join(schema.OBSERVERS)}")
    needed, optional = schema.OBSERVERS[observer["type"]]
    for key in observer.keys() - {"type", *needed, *optional}:
        guess = did_you_mean(key, needed + optional) or f"known: {', '.join(needed + optional) or 'none'}"
        raise InputError(file, f"{where}.{key}", observer[key], f"unknown key; {guess}")
    for key in needed:
        if key not in observer:
            raise InputError(file, f"{where}.{key}", None, f"missing: {observer['type']} needs it")


def _check_value(file: Path, key: str, known: schema.Key, value: object) -> None:
    remedy = schema.fault(known, value)
    if remedy:
        raise InputError(file, key, value, remedy)


def _check_target(file: Path, where: str, target: dict) -> None:
    for key, value in target.items():
        known = schema.KEYS.get(f"target.{key}")
        if known is None:
            raise InputError(file, where + key, value, f"unknown key; {schema.hint('target.' + key)}")
        _check_value(file, where + key, known, value)
    for key, known in schema.KEYS.items():
        if key.startswith("target.") and known.required and key[7:] not in target:
            raise InputError(file, where + key[7:], None, f"missing: {known.meaning}")
    if not {"tolerance", "tolerance_absolute"} & target.keys():
        raise InputError(file, where + "tolerance", None, "missing: largest error that passes")
