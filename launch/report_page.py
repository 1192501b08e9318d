"""report.html: one file, pictures inside, for an engineer who was not there."""

from __future__ import annotations

import base64
import html
import io
from pathlib import Path

from matplotlib.figure import Figure

from launch import foam_file, history_plot, results, section_plot, vtk_file

STYLE = """body{font:15px/1.5 system-ui,sans-serif;max-width:1150px;margin:2em auto;padding:0 1em;color:#222}
h1{margin-bottom:0}h2{border-bottom:1px solid #ccc;margin-top:1.6em}table{border-collapse:collapse}
td,th{padding:.2em .9em .2em 0;text-align:left;border-bottom:1px solid #eee;vertical-align:top}
img,svg{max-width:100%;height:auto}.pass{color:#2a7f3f}.miss{color:#b03a2e}.grey{color:#666}"""
BUDGET_LIMITS = {"momentum_defect": 1e-10, "momentum_outstanding": 1e-2, "solid_volume_defect": 1e-12,
                 "water_volume_defect": 1e-6, "air_volume_defect": 1e-4, "particles_lost": 0}


def write(directory: Path, case: dict, summary: dict) -> None:
    """Makes report.html of a run directory from its case, summary, history, fields and particles."""
    history = results.read_history(directory)
    headline = case.get("output", {}).get("headline")
    about = case.get("case", {})
    title = about.get("title") or about.get("name", directory.name)
    parts = [
        f"<h1>{html.escape(title)}</h1>", _head(summary),
        "<h2>Targets</h2>", _targets(summary.get("targets", [])),
        "<h2>Sections</h2>", _sections(directory, case),
        "<h2>Time histories</h2>",
        _svg(history_plot.figure(history, summary.get("targets", []), [headline] if headline else []),
             "No history was written."),
        "<h2>Budgets</h2>", _budgets(summary.get("budgets", {})),
        "<h2>Run time</h2>", _timings(summary),
        "<h2>Active and left out</h2>", _features(summary),
        "<h2>Extremes</h2>", _pairs(summary.get("extremes", {})),
        "<h2>Parameters</h2>", _pairs(case.get("parameters", {})),
    ]
    page = (f"<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>{html.escape(title)}</title>"
            f"<style>{STYLE}</style></head><body>{''.join(parts)}</body></html>\n")
    (directory / "report.html").write_text(page, encoding="utf-8")


def _head(summary: dict) -> str:
    status = summary.get("status", "unknown")
    kind = "pass" if status == "completed" else "miss"
    ranks = summary.get("ranks", {})
    shown = ", ".join(f"{k} {v}" for k, v in ranks.items()) if isinstance(ranks, dict) else str(ranks)
    facts = [f"case {summary.get('case', '')}", f"variant {summary.get('variant') or '-'}",
             f"version {summary.get('version', '')}", f"ranks: {shown}"]
    facts += [f"{summary[k]:.0f} {k}" for k in ("particles", "cells", "windows")
              if isinstance(summary.get(k), (int, float))]
    reason = f"<p class='miss'>{html.escape(str(summary['reason']))}</p>" if summary.get("reason") else ""
    line = html.escape(" · ".join(facts))
    return f"<p class='grey'>{line} · <b class='{kind}'>{html.escape(status)}</b></p>{reason}"


def number(value: object) -> str:
    """A value for people: five digits, "-" for none."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def table(head: list[str], rows: list[list[str]]) -> str:
    """An HTML table; cells are HTML already."""
    if not rows:
        return "<p class='grey'>None.</p>"
    lines = ["<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows]
    return "<table><tr>" + "".join(f"<th>{h}</th>" for h in head) + "</tr>" + "".join(lines) + "</table>"


def _targets(targets: list[dict]) -> str:
    others = [k for k in ("one_way", "no_water") if any(k in t for t in targets)]
    rows = []
    for t in targets:
        verdict = "<b class='pass'>passed</b>" if t["pass"] else "<b class='miss'>missed</b>"
        limits = []
        if t.get("tolerance") is not None:
            limits.append(f"{100 * t['tolerance']:.3g} %")
        if t.get("tolerance_absolute") is not None:
            limits.append(f"{t['tolerance_absolute']:g} {t['unit']}")
        error = "-" if t["relative_error"] is None else f"{100 * t['relative_error']:.3g} %"
        rows.append([html.escape(t["name"]), f"{number(t['value'])} {t['unit']}", number(t["reference"]),
                     error, " and ".join(limits), "required" if t["required"] else "", verdict,
                     *(number(t.get(k)) for k in others), html.escape(t.get("source", ""))])
    labels = {"one_way": "one-way run", "no_water": "dry run"}
    return table(["target", "value", "reference", "error", "tolerance", "", "", *(labels[k] for k in others),
                  "source"], rows)


def _sections(directory: Path, case: dict) -> str:
    try:
        drawing, caption = section_plot.figure(directory, case)
    except (foam_file.FoamFormatError, vtk_file.VtkFormatError) as error:
        return f"<p class='miss'>Cannot be drawn: {html.escape(str(error))}</p>"
    if drawing is None:
        return f"<p class='grey'>{caption}</p>"
    raw = io.BytesIO()
    drawing.savefig(raw, format="png", dpi=130)
    picture = base64.b64encode(raw.getvalue()).decode()
    return f"<p>{caption}</p><img alt='sections over time' src='data:image/png;base64,{picture}'>"


def _svg(drawing: Figure | None, otherwise: str) -> str:
    if drawing is None:
        return f"<p class='grey'>{otherwise}</p>"
    raw = io.StringIO()
    drawing.savefig(raw, format="svg", metadata={"Date": None})
    text = raw.getvalue()
    return text[text.index("<svg") :]


def _budgets(budgets: dict) -> str:
    rows = []
    for name, value in budgets.items():
        limit = BUDGET_LIMITS.get(name)
        good = limit is None or (isinstance(value, (int, float)) and abs(value) <= limit)
        verdict = "" if limit is None else f"<b class='{'pass' if good else 'miss'}'>{'held' if good else 'broken'}</b>"
        rows.append([name.replace("_", " "), number(value), number(limit), verdict])
    return table(["budget", "value", "limit", ""], rows)


def _timings(summary: dict) -> str:
    rows = [[label, f"{number(summary[key])} s"] for key, label in
            (("total_s", "whole command"), ("prepare_s", "preparation"), ("wall_s", "coupled run"),
             ("core_s", "core seconds")) if isinstance(summary.get(key), (int, float))]
    for side, stages in summary.get("timings", {}).items():
        if isinstance(stages, dict):
            rows += [[f"{side}: {stage.removesuffix('_s').replace('_', ' ')}", f"{number(s)} s"]
                     for stage, s in stages.items()]
    text = table(["stage", "time"], rows)
    if summary.get("bytes_per_particle") is not None:
        text += f"<p>{number(summary['bytes_per_particle'])} bytes a particle and window are exchanged.</p>"
    return text


def _features(summary: dict) -> str:
    rows = []
    for key, label in (("active", "active"), ("left_out", "left out")):
        entries = summary.get(key, [])
        entries = [{"name": k, "reason": v} for k, v in entries.items()] if isinstance(entries, dict) else entries
        for entry in entries:
            named = entry if isinstance(entry, dict) else {"name": entry}
            rows.append([label, html.escape(str(named.get("name", "")).replace("_", " ")),
                         html.escape(str(named.get("reason", "")))])
    return table(["", "feature", "why"], rows)


def _pairs(values: dict) -> str:
    return table(["name", "value"], [[html.escape(str(k)), html.escape(number(v))] for k, v in values.items()])
