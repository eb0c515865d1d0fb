"""Answers as lists of dicts, as pandas.DataFrame takes them."""


def table(answer):
    """The rows of an answer: of study, compare, another job, or render with frame_report=True."""
    if "frame_report" in answer:
        answer = answer["frame_report"]
    if "points" in answer:
        return [_point(point) for point in answer["points"]]
    if "distances" in answer:
        return [{"metric": metric, "distance": value} for metric, value in answer["distances"].items()]
    if "facts" in answer:
        return [{"label": f["label"], "value": f["value"], "unit": f.get("unit", "")} for f in answer["facts"]]
    if "ran" in answer:
        return [_pass(entry, True) for entry in answer["ran"]] + [_pass(entry, False) for entry in answer["skipped"]]
    raise ValueError("this answer has no rows; give one of study, compare, another job, or render with frame_report=True")


def _point(point):
    row = dict(point["values"])
    row.update({key: point[key] for key in ("error", "cost", "dominated", "knee", "present")})
    if "ms" in point:
        row.update(ms=point["ms"]["median"], ms_low=point["ms"]["low"], ms_high=point["ms"]["high"])
    row.update({f"count_{name}": count for name, count in point["counters"].items()})
    return row


def _pass(entry, ran):
    return {
        "name": entry["name"],
        "kind": entry["kind"],
        "ran": ran,
        "reason": entry["reason"],
        "ms": entry["ms"] if ran else entry["wouldCostMs"],
    }
