"""The end of a study: rows read back, errors against the reference, what is said and drawn."""

from __future__ import annotations

from launch import study_analysis, study_plot, study_results, study_table
from launch.progress import say
from launch.study_quantities import Reference
from launch.study_results import Row
from launch.study_setup import Plan


def rows_of(plan: Plan, reasons: dict, pending: bool = False) -> list[Row]:
    """The rows in the order of the points. Quick: only small files are read."""
    rows = []
    for point in plan.points:
        places = [job.directory for job in plan.jobs.get(point, [])]
        row = study_results.read(point, places, plan.quantities, reasons.get(point, ""))
        row.by = plan.time
        if pending and row.reason == "not run":
            row.status, row.reason = "pending", ""
        rows.append(row)
    return rows


def judge(plan: Plan, rows: list[Row], ablate: bool, wanted: float) -> None:
    """Errors, fronts, orders and the sentence for an error of `wanted`, group by group; both files."""
    groups: dict[str, list[Row]] = {}
    for row in rows:
        groups.setdefault(row.point.text(plan.group), []).append(row)
    for members in groups.values():
        reference = plan.reference
        if reference is None:
            finest = rows[0] if ablate else study_results.best(members, plan.grid)
            if finest is None or not finest.completed:
                continue
            finest.is_reference = True
            reference = Reference(finest.point.label, history=finest.histories[0])
        study_results.compare(members, plan.quantities, reference)
        if ablate:
            continue
        for row in members if plan.reference and plan.reference.history else ():
            row.is_reference = row.worst == 0  # the run that the file came from
        if plan.reference is None:
            study_analysis.set_floor(members, [q.name for q in plan.quantities])
        study_analysis.mark_front(members)
    study_table.write(plan.out / "study.csv", rows, plan.quantities)
    shown = "change without each term" if ablate else "error against run time"
    title = f"{' '.join(filter(None, (plan.case.name, plan.case.variant)))}: {shown}"
    study_plot.write(plan.out / "study.svg", title, groups, plan.quantities, ablate)
    if ablate:
        say("\n".join(study_table.change_lines(rows, plan.quantities)))
        return
    say("\n".join(study_table.lines(rows)))
    for name, members in groups.items():
        for quantity in plan.quantities:
            for found in study_analysis.orders(members, quantity.name):
                say(f"{name + ': ' if name else ''}{quantity.name}, {found}")
        floor = max(row.floor for row in members)
        if floor > study_analysis.NOTHING:
            say(f"errors are against the finest run, which by the order is {100 * floor:.2g} % off itself; "
                "the sentence adds that")
        say(study_analysis.sentence(members, wanted, name))
