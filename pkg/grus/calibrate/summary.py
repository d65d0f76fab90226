"""One screen about a calibration."""

from grus.calibrate.words import measured, spread


def summary(result: dict) -> str:
    """Parameters with intervals and targets against the model, in plain lines; result: what result.json holds."""
    lines = []
    width = max(26, *map(len, result["parameters"])) + 2
    for name, one in result["parameters"].items():
        value = measured(one["value"], one["unit"])
        lines.append(f"{name:<{width}}{value}{spread(one, result['confidence'])}")
    lines.append("")
    lines.append(f"{'target':<{width}}{'wanted':>14}{'model':>14}{'off by tolerances':>20}")
    for one in result["targets"].values():
        for wanted, model, off, at in rows(one):
            lines.append(f"{one['quantity'] + at:<{width}}{wanted:>14}{model:>14}{off:>20}")
    lines.append("")
    lines.append(
        f"misfit {result['misfit']:.3g} in trial {result['best_trial']} of {len(result['trials'])}; "
        f"{result['runs']} runs, {result['failed_runs']} failed"
    )
    return "\n".join(lines)


def rows(target: dict) -> list[tuple[str, str, str, str]]:
    """Wanted, model, distance, and of a curve the stress, as texts; target: of result.json."""
    unit = target["unit"]
    names = ("target", "model", "off_by_tolerances")
    columns = [target[name] if "stress" in target else [target[name]] for name in names]
    wanted = columns[0]
    model, off = (column or [None] * len(wanted) for column in columns[1:])
    places = [f", {1e-3 * s:.4g} kPa" for s in target.get("stress", ())] or [""]
    return [
        (
            measured(w, unit),
            "-" if m is None else measured(m, unit),
            "-" if o is None else f"{o:+.2f}",
            at,
        )
        for w, m, o, at in zip(wanted, model, off, places)
    ]
